"""The paper's tables and our ablations as one picture: a render and its FLIP map a row."""

import textwrap
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from rna_bench.frontier.paper_tables import paper_tables
from rna_bench.plot_style import figure
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.metrics import display, to_png
from rna_export.pictures import flip_colours

_INCHES = 1.5  # of a picture


def draw_sheet(report: dict[str, Any], folder: Path, views: list[ValidationView]) -> None:
    """Write `tables.png`: a strip for each table that has rows, Cycles first; none if none has.

    folder: of the study.
    """
    tables = [table for table in paper_tables(report["points"]) if table["rows"]]
    if not tables:
        return
    shown = int(np.argmax([display(view.samples["radiance"]).sum() for view in views]))
    view = views[shown]
    reference = to_png(view.image(view.samples["radiance"]))
    columns = 1 + max(len(table["rows"]) for table in tables)
    drawn = figure(_INCHES * columns, 2.5 * _INCHES * len(tables))
    for part, table in zip(drawn.subfigures(len(tables), squeeze=False).flat, tables, strict=True):
        part.suptitle(table["title"], x=0.01, ha="left")
        grid = part.subplots(2, columns)
        for axes in grid.flat:
            axes.set_axis_off()
        _show(grid[:, 0], "Cycles", [reference])
        for axes, row, point in zip(grid[:, 1:].T, table["rows"], table["points"], strict=False):
            strips = (folder / "trials" / f"{point}-{what}.png" for what in ("render", "flip"))
            pair = [_cut(strip, shown, view.resolution) for strip in strips]
            _show(axes, f"{textwrap.fill(row[0], 22)}\n{row[1]} dB", pair)
    drawn.savefig(folder / "tables.png", dpi=80)


def _show(column: np.ndarray, title: str, pictures: list[np.ndarray]) -> None:
    column[0].set_title(title, fontsize=8)
    for axes, picture in zip(column, pictures, strict=False):
        axes.imshow(picture)


def _cut(strip: Path, number: int, size: int) -> np.ndarray:
    """A view (size, size, 3) uint8 of a strip; errors, which are grey, in FLIP's colours."""
    with Image.open(strip) as image:
        pixels = np.asarray(image)
    if pixels.ndim == 2:
        pixels = flip_colours(pixels / 255.0)
    return pixels[:, number * size : (number + 1) * size]

"""All scenes as one picture: what was rendered, FLIP below it, and the charts."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib.figure import FigureBase

from rna_bench.plot_style import figure
from rna_bench.scenes.chart import SIZE, draw_charts
from rna_bench.scenes.judge import shown_pictures
from rna_bench.scenes.measure import MeasuredScene

_PICTURES = 4.2  # inches that pictures and their FLIP maps take


def draw_sheet(done: Sequence[MeasuredScene], found: dict[str, Any], path: Path) -> None:
    """Write the PNG; found: scene -> what `judge` gave."""
    width, height = SIZE
    sheet = figure(width, len(done) * (_PICTURES + height))
    parts = sheet.subfigures(2 * len(done), 1, height_ratios=[_PICTURES, height] * len(done))
    for k, measured in enumerate(done):
        parts[2 * k].suptitle(measured.name, x=0.01, ha="left", fontsize=12, fontweight="bold")
        _draw_pictures(parts[2 * k], measured)
        draw_charts(parts[2 * k + 1], found[measured.name])
    sheet.savefig(path, dpi=100)


def _draw_pictures(part: FigureBase, measured: MeasuredScene) -> None:
    pictures = shown_pictures(measured)
    grid = part.subplots(2, len(pictures))
    for axes in grid.flat:
        axes.set_axis_off()
    for (above, below), shown in zip(grid.T, pictures, strict=True):
        above.set_title(shown.caption, fontsize=8)
        above.imshow(shown.picture)
        if shown.flip is not None:
            below.imshow(shown.flip)
            below.set_title(f"FLIP {shown.flip_mean:.4f}", fontsize=8)

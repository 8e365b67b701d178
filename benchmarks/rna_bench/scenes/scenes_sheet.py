"""All scenes as one picture: renders, FLIP below them, and the charts."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matplotlib.figure import FigureBase

from rna_bench.plot_style import figure
from rna_bench.scenes.judge import shown_pictures
from rna_bench.scenes.measured_scene import MeasuredScene
from rna_bench.scenes.time_chart import SIZE, draw_charts

_TITLES = 0.45  # inches, of a row of pictures and what is above it


def draw_sheet(done: Sequence[MeasuredScene], result: dict[str, Any], path: Path) -> None:
    """Write the PNG; result: scene -> the result of `judge`."""
    heights = [height for one in done for height in (_pictures_height(one), SIZE[1])]
    sheet = figure(SIZE[0], sum(heights))
    parts = sheet.subfigures(len(heights), 1, height_ratios=heights, squeeze=False).flat
    for k, measured in enumerate(done):
        parts[2 * k].suptitle(measured.name, x=0.01, ha="left", fontsize=12, fontweight="bold")
        _draw_pictures(parts[2 * k], measured)
        draw_charts(parts[2 * k + 1], result[measured.name])
    sheet.savefig(path, dpi=100)


def _pictures_height(measured: MeasuredScene) -> float:
    """Inches of pictures and FLIP maps below them."""
    width, height = measured.scene.resolution
    return 2 * (SIZE[0] / len(shown_pictures(measured)) * height / width + _TITLES)


def _draw_pictures(part: FigureBase, measured: MeasuredScene) -> None:
    pictures = shown_pictures(measured)
    grid = part.subplots(2, len(pictures))
    for axes in grid.flat:
        axes.set_axis_off()
    for (above, below), shown in zip(grid.T, pictures, strict=True):
        above.set_title(shown.caption.replace(": ", "\n", 1), fontsize=8)
        above.imshow(shown.picture)
        if shown.flip is not None:
            below.imshow(shown.flip)
            below.set_title(f"FLIP {shown.flip_mean:.4f}", fontsize=8)

"""One scene as two charts: PSNR and FLIP over time."""

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import FigureBase

from rna_bench.plot_style import CYCLES, OURS, log_ticks

SIZE = (12.0, 3.2)
"""Inches."""

_LINES = {
    "ours": ("ours", OURS, "o-"),
    "ours_denoised": ("ours, denoised", OURS, "o--"),
    "cycles": ("Cycles", CYCLES, "s-"),
    "cycles_denoised": ("Cycles, denoised", CYCLES, "s--"),
}


def draw_charts(chart: FigureBase, scene: dict[str, Any]) -> None:
    """scene: as `judge` gives it."""
    psnr, flip = chart.subplots(1, 2)
    _over_time(psnr, scene, "psnr", "PSNR of the asset, dB")
    _over_time(flip, scene, "flip", "mean FLIP of the asset")
    flip.set_yscale("log")
    log_ticks(flip.yaxis)
    lines = psnr.get_legend_handles_labels()
    chart.legend(*lines, loc="outside lower center", ncols=len(lines[0]))


def _over_time(axes: Axes, scene: dict[str, Any], error: str, title: str) -> None:
    for key, (label, colour, style) in _LINES.items():
        rows = scene[key]
        seconds, values = [r["seconds"] for r in rows], [r[error] for r in rows]
        if not rows:
            continue
        axes.plot(seconds, values, style, color=colour, label=label)
        for row in rows if not key.endswith("denoised") else ():
            at = row["seconds"], row[error]
            axes.annotate(
                str(row["samples"]),
                at,
                (3, -9),
                textcoords="offset points",
                fontsize=7,
                color=colour,
            )
    floor = scene["floor"]
    label = f"floor: ours, {floor['samples']} samples"
    axes.axhline(floor[error], color=OURS, lw=0.8, ls=":", label=label)
    axes.set_xscale("log")
    log_ticks(axes.xaxis)
    axes.set_xlabel("seconds; numbers are samples a pixel")
    axes.set_title(title)

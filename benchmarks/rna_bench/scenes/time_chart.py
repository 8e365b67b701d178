"""One scene as three charts: PSNR over time, FLIP over time, CPU time by kernel."""

from __future__ import annotations

import base64
import io
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import FigureBase

from rna_bench.plot_style import CYCLES, OPPONENT, OURS, PAPER, QUIET, figure, log_ticks
from rna_bench.scenes.kernel_times import KERNELS

SIZE = (12.0, 3.2)
"""Inches."""

_LINES = {
    "ours": ("ours", OURS, "o-"),
    "ours_denoised": ("ours, denoised", OURS, "o--"),
    "cycles": ("Cycles", CYCLES, "s-"),
    "cycles_denoised": ("Cycles, denoised", CYCLES, "s--"),
}
_KERNEL_COLOURS = dict(zip(KERNELS, (OURS, OPPONENT, PAPER, QUIET), strict=True))


def draw_charts(chart: FigureBase, scene: dict[str, Any]) -> None:
    """scene: as `judge` gives it."""
    psnr, flip, kernels = chart.subplots(1, 3, width_ratios=(1.0, 1.0, 0.75))
    _over_time(psnr, scene, "psnr", "PSNR of the asset, dB")
    _over_time(flip, scene, "flip", "mean FLIP of the image")
    flip.set_yscale("log")
    log_ticks(flip.yaxis)
    lines = psnr.get_legend_handles_labels()
    chart.legend(*lines, loc="outside lower center", ncols=len(lines[0]))
    _by_kernel(kernels, scene["kernels"])


def svg_address(scene: dict[str, Any]) -> str:
    """The charts as a data address, for the page."""
    chart, buffer = figure(*SIZE), io.BytesIO()
    draw_charts(chart, scene)
    chart.savefig(buffer, format="svg", metadata={"Date": None})
    return "data:image/svg+xml;base64," + base64.b64encode(buffer.getvalue()).decode()


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


def _by_kernel(axes: Axes, kernels: dict[str, Any]) -> None:
    seconds = kernels["cpu_seconds"]
    total = sum(seconds.values())
    bars = axes.barh(KERNELS, [seconds[k] for k in KERNELS], height=0.6)
    for bar, kernel in zip(bars, KERNELS, strict=True):
        bar.set_color(_KERNEL_COLOURS[kernel])
    labels = [f"{seconds[k]:.2f} s, {100 * seconds[k] / total:.0f}%" for k in KERNELS]
    axes.bar_label(bars, labels, padding=3, fontsize=8)
    axes.set_xlim(right=1.5 * max(seconds.values()))
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("CPU seconds")
    axes.set_title(f"ours, {kernels['samples']} samples: {total:.2f} CPU s on one thread")

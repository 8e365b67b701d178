"""The frontier as a picture: PSNR against cost, and against bytes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import matplotlib

from rna_bench.frontier.points import COSTS, front

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import EngFormatter, LogLocator, NullFormatter

COLOURS = {"ours": "#2f6fb3", "paper": "#d9822b", "ablation": "#8a8f98", "cycles": "#b0407a"}
LABELS = {
    "ours": "our models",
    "paper": "the paper's models",
    "ablation": "ablations",
    "cycles": "Cycles, paths a pixel",
}
_MARKERS = {"float32": "o", "int8": "D"}


def draw(report: dict[str, Any], path: Path) -> None:
    """Write a PNG of a report of `study`."""
    figure, axes = plt.subplots(1, 2, figsize=(12, 5), layout="constrained", sharey=True)
    for axis, cost in zip(axes, ("ns", "bytes"), strict=True):
        axis.set(xscale="log", xlabel=COSTS[cost])
        if cost == "bytes":  # less than a decade or two
            axis.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.xaxis.set_major_formatter(EngFormatter())
        axis.xaxis.set_minor_formatter(NullFormatter())
        axis.grid(alpha=0.25)
        _draw_points(axis, report["points"], cost)
    _draw_cycles(axes[0], report["cycles"])
    axes[0].set_ylabel("PSNR, dB (irradiance pi, clamped to [0, 1])")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    steps = report["points"][0]["steps"]
    figure.suptitle(f"{report['dataset']['name']}: {steps:,} steps of training for each model")
    figure.savefig(path, dpi=120)
    plt.close(figure)


def _draw_points(axis: Any, points: list[dict[str, Any]], cost: str) -> None:
    shown = [p for p in points if p[cost] is not None]
    for family in ("ours", "paper", "ablation"):
        for decoder, marker in _MARKERS.items():
            some = [
                p for p in shown if p["family"] == family and p["precision"].startswith(decoder)
            ]
            if some:
                label = LABELS[family] + (", int8" if decoder == "int8" else "")
                axis.scatter(
                    [p[cost] for p in some],
                    [p["psnr"] for p in some],
                    s=26,
                    c=COLOURS[family],
                    marker=marker,
                    label=label,
                    alpha=0.85,
                    lw=0,
                )
    best = front(points, cost, "psnr")
    line = [p[cost] for p in best], [p["psnr"] for p in best]
    axis.step(*line, where="post", color=COLOURS["ours"], lw=1, alpha=0.6, label="best at its cost")
    for point in shown:
        if point["name"] in ("paper-small", "paper-hq") and point["precision"].startswith("float"):
            at = point[cost], point["psnr"]
            axis.annotate(
                point["name"], at, (0, 6), textcoords="offset points", fontsize=8, ha="center"
            )


def _draw_cycles(axis: Any, curve: dict[str, Any] | None) -> None:
    if curve is None:
        return
    at = [p["ns"] for p in curve["points"]], [p["scores"]["psnr"] for p in curve["points"]]
    axis.plot(*at, "s-", ms=4, lw=1, color=COLOURS["cycles"], label=LABELS["cycles"])
    for point in curve["points"]:
        at = point["ns"], point["scores"]["psnr"]
        axis.annotate(str(point["samples"]), at, (4, -9), textcoords="offset points", fontsize=7)

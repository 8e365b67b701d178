"""Frontiers as a picture: FLIP against cost, and against bytes."""

from pathlib import Path
from textwrap import wrap
from typing import Any

from matplotlib.ticker import EngFormatter, LogLocator, NullFormatter

from rna_bench.frontier.chart_points import COSTS, front
from rna_bench.plot_style import CYCLES, OPPONENT, OURS, PAPER, QUIET, figure, log_ticks, save_chart

COLOURS = {"ours": OURS, "paper": PAPER, "opponent": OPPONENT, "ablation": QUIET, "cycles": CYCLES}
LABELS = {
    "ours": "our models",
    "paper": "the paper's models",
    "opponent": "NRHints' network",
    "ablation": "ablations",
    "cycles": "Cycles, paths a pixel",
}
_ABOVE = 0.6  # of the best model's FLIP, where the chart ends
_MARKERS = {"float32": "o", "int8": "D"}


def draw(reports: list[dict[str, Any]], path: Path) -> None:
    """Write an SVG of reports of `study`: a row an asset, whose longest trainings are filled."""
    assets = list(dict.fromkeys(report["dataset"]["name"] for report in reports))
    drawn = figure(12, 0.8 + 4.2 * len(assets))
    grid = drawn.subplots(len(assets), 2, sharey="row", squeeze=False)
    for axes, asset in zip(grid, assets, strict=True):
        of_asset = [report for report in reports if report["dataset"]["name"] == asset]
        _draw_row(axes, asset, sorted(of_asset, key=_steps, reverse=True))
    for axis, cost in zip(grid[-1], COSTS, strict=True):
        axis.set_xlabel(COSTS[cost])
    drawn.legend(*grid[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    save_chart(drawn, path)


def _steps(report: dict[str, Any]) -> int:
    return max(point["steps"] for point in report["points"])


def _draw_row(axes: Any, asset: str, reports: list[dict[str, Any]]) -> None:
    longest, *shorter = reports
    for axis, cost in zip(axes, COSTS, strict=True):
        axis.set(xscale="log")
        if cost == "bytes":  # less than a decade or two
            axis.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axis.xaxis.set_major_formatter(EngFormatter())
        axis.xaxis.set_minor_formatter(NullFormatter())
        for report in shorter:
            _draw_points(axis, report["points"], cost, is_short=True)
        _draw_points(axis, longest["points"], cost)
    flips = [point["flip"] for report in reports for point in report["points"]]
    best, worst = _ABOVE * min(flips), 1.1 * max(flips)
    axes[0].set(yscale="log", ylim=(worst, best))
    log_ticks(axes[0].yaxis)
    _draw_cycles(axes[0], next((r["cycles"] for r in reports if r["cycles"]), None), best)
    axes[0].set_ylabel(f"{_flip_of(longest)}, better above")
    lengths = "; hollow: ".join(f"{_steps(report):,} steps" for report in reports)
    axes[0].set_title(f"{asset}: {lengths} of each model", loc="left")


def _flip_of(report: dict[str, Any]) -> str:
    """Pixels of the report's FLIP, as its definition begins."""
    return "\n".join(wrap(report["definitions"]["flip"].split(";")[0], 40))


def _draw_points(
    axis: Any, points: list[dict[str, Any]], cost: str, is_short: bool = False
) -> None:
    shown = [p for p in points if p[cost] is not None]
    for family in ("ours", "paper", "opponent", "ablation"):
        for decoder, marker in _MARKERS.items():
            some = [
                p for p in shown if p["family"] == family and p["precision"].startswith(decoder)
            ]
            if some:
                label = LABELS[family] + (", int8" if decoder == "int8" else "")
                axis.scatter(
                    [p[cost] for p in some],
                    [p["flip"] for p in some],
                    s=26,
                    facecolors="none" if is_short else COLOURS[family],
                    edgecolors=COLOURS[family],
                    marker=marker,
                    label=None if is_short else label,
                    alpha=0.5 if is_short else 0.85,
                    lw=0.8 if is_short else 0,
                )
    if is_short:
        return
    best = front(points, cost)
    axis.step(
        [p[cost] for p in best],
        [p["flip"] for p in best],
        where="post",
        color=COLOURS["ours"],
        lw=1,
        alpha=0.6,
        label="best at its cost",
    )
    for point in shown:
        if point["name"] in ("paper-small", "paper-hq") and point["precision"].startswith("float"):
            at = point[cost], point["flip"]
            axis.annotate(
                point["name"], at, (0, 6), textcoords="offset points", fontsize=8, ha="center"
            )


def _draw_cycles(axis: Any, curve: dict[str, Any] | None, top: float) -> None:
    """Cycles' points; those better than `top` stand at the edge, with their value."""
    if curve is None:
        return
    ns = [p["ns"] for p in curve["points"]]
    flips = [p["scores"]["flip"] for p in curve["points"]]
    axis.plot(ns, flips, "s-", ms=4, lw=1, color=COLOURS["cycles"], label=LABELS["cycles"])
    for point, x, y in zip(curve["points"], ns, flips, strict=True):
        text = {"textcoords": "offset points", "fontsize": 7}
        if y >= top:
            axis.annotate(str(point["samples"]), (x, y), (4, -9), **text)
        else:
            axis.plot(x, top, "^", ms=5, color=COLOURS["cycles"], clip_on=False)
            label = f"{point['samples']}: {y:.3f}"
            axis.annotate(label, (x, top), (-4, -38), rotation=90, **text)

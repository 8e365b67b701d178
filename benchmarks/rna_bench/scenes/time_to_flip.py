"""Seconds until a denoised picture is within a FLIP of the converged one, ours and Cycles'.

    rna-bench time-to-flip benchmarks/results/scenes-{toy,head,curls}.json --out time-to-flip.svg

Reads results of `rna-bench scenes`, prints a Markdown table and draws it. Seconds are those of
rendering and denoising; between the samples that were measured the curve is a line in logarithms.
A picture of the fewest samples that is good enough gives an upper limit.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.results import read_scenes

TARGETS = (0.05, 0.03)
_SIDES = {"ours": "ours_denoised", "Cycles": "cycles_denoised"}


@dataclass(frozen=True)
class Wait:
    """Seconds to a target; None where it was not reached.

    is_limit: whether fewer seconds might do. best: the lowest FLIP that was measured, denoised or,
    of ours, the package's own with many samples.
    """

    seconds: float | None
    is_limit: bool
    best: float

    def __str__(self) -> str:
        if self.seconds is None:
            return f"not reached, {self.best:.3f}"
        return f"{'at most ' if self.is_limit else ''}{self.seconds:.2f} s"


@dataclass(frozen=True)
class Row:
    """A scene of an asset: waits by side of `_SIDES` and target."""

    asset: str
    scene: str
    waits: dict[str, dict[float, Wait]]


def wait_for(target: float, curve: Sequence[dict[str, Any]], floor: float | None = None) -> Wait:
    """The wait on a curve of results, each with `seconds` and `flip`, fewest samples first.

    floor: FLIP that more samples would reach at most.
    """
    flips = [row["flip"] for row in curve]
    seconds = [row["seconds"] for row in curve]
    best = min(flips if floor is None else [*flips, floor])
    reached = next((k for k, flip in enumerate(flips) if flip <= target), None)
    if reached is None:
        return Wait(None, False, best)
    if reached == 0:
        return Wait(seconds[0], True, best)
    ends = np.log([flips[reached], flips[reached - 1]])
    times = np.log([seconds[reached], seconds[reached - 1]])
    return Wait(float(np.exp(np.interp(np.log(target), ends, times))), False, best)


def rows_of(result: dict[str, Any]) -> list[Row]:
    """A row for each scene of a result of `rna-bench scenes`."""
    name = Path(result["asset"]).stem.replace("_", " ")
    tier = "" if result["tier"] == "default" else f", {result['tier']}"
    rows = []
    for scene, results in result["scenes"].items():
        floors = {"ours": results["floor"]["flip"], "Cycles": None}
        waits = {
            side: {target: wait_for(target, results[key], floors[side]) for target in TARGETS}
            for side, key in _SIDES.items()
            if results[key]
        }
        rows.append(Row(name + tier, scene, waits))
    return rows


def table(rows: Sequence[Row]) -> str:
    """Markdown."""
    heads = [f"FLIP {target:g}: {side}" for target in TARGETS for side in _SIDES]
    lines = ["| asset, scene | " + " | ".join(heads) + " |", "| --- " * (1 + len(heads)) + "|"]
    for row in rows:
        cells = [
            str(row.waits[side][target]) if side in row.waits else "not measured"
            for target in TARGETS
            for side in _SIDES
        ]
        lines.append(f"| {row.asset}, {row.scene} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def draw(rows: Sequence[Row], path: Path) -> None:
    """Write the chart: a line for each row, a panel for each target."""
    from rna_bench.plot_style import CYCLES, OURS, figure, log_ticks, save_chart

    waits = [wait for row in rows for side in row.waits.values() for wait in side.values()]
    missed_at = 1.6 * max((wait.seconds for wait in waits if wait.seconds), default=1.0)
    chart = figure(11.0, 1.0 + 0.24 * len(rows))
    for axes, target in zip(chart.subplots(1, len(TARGETS), sharey=True), TARGETS, strict=True):
        for side, style in (("ours", (OURS, "o", -0.15)), ("Cycles", (CYCLES, "s", 0.15))):
            _draw_side(axes, rows, target, side, style, missed_at)
        axes.set(xscale="log", xlim=(None, 1.25 * missed_at))
        log_ticks(axes.xaxis)
        axes.set_xlabel("seconds; hollow: at most; cross: not reached")
        axes.set_title(f"until FLIP {target:g}, denoised")
    axes.set_yticks(range(len(rows)), [f"{row.asset}, {row.scene}" for row in rows])
    axes.invert_yaxis()
    chart.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=2)
    save_chart(chart, path)


def _draw_side(
    axes: Any,
    rows: Sequence[Row],
    target: float,
    side: str,
    style: tuple[str, str, float],
    missed_at: float,
) -> None:
    """style: colour, marker, and how far below its line."""
    colour, marker, below = style
    for line, row in enumerate(rows):
        if side not in row.waits:
            continue
        wait = row.waits[side][target]
        if wait.seconds is None:
            axes.plot(missed_at, line + below, "x", color=colour)
            continue
        fill = "none" if wait.is_limit else colour
        axes.plot(wait.seconds, line + below, marker, color=colour, markerfacecolor=fill)
    axes.plot([], [], marker, color=colour, label=side)


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of the command."""
    parser.add_argument("results", type=Path, nargs="+", help="JSON of `rna-bench scenes` (path)")
    parser.add_argument("--out", type=Path, help="SVG to draw (path, default: only the table)")


def run(args: argparse.Namespace) -> None:
    """Print the table, and draw it."""
    rows = [row for path in args.results for row in read_scenes(path, rows_of)]
    print(table(rows))
    if args.out:
        draw(rows, args.out)
        print(f"wrote {args.out}")

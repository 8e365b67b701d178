"""Seconds until a picture is within a FLIP of the converged one, ours and Cycles'.

    rna-bench time-to-flip benchmarks/results/scenes-{toy,head,curls}.json --out time-to-flip.svg

Reads results of `rna-bench scenes`, prints a Markdown table and draws it. The sooner of raw and
denoised pictures counts on each side. Seconds are those of rendering and denoising; between the
samples that were measured the curve is a line in logarithms. A picture of the fewest samples that
is good enough gives an upper limit.
"""

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.results import read_scenes

TARGETS = (0.15, 0.1)
_SIDES = {"ours": ("ours", "ours_denoised"), "Cycles": ("cycles", "cycles_denoised")}


@dataclass(frozen=True)
class Wait:
    """Seconds to a target; None where it was not reached.

    is_limit: whether fewer seconds might do. best: the lowest FLIP that was measured, or, of ours,
    the package's own with many samples.
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


def sooner(waits: Sequence[Wait]) -> Wait:
    """The shortest wait; if no picture reached the target, the wait for the nearest one."""
    reached = [wait for wait in waits if wait.seconds is not None]
    if reached:
        return min(reached, key=lambda wait: wait.seconds or 0.0)
    return min(waits, key=lambda wait: wait.best)


def rows_of(result: dict[str, Any], targets: Sequence[float] = TARGETS) -> list[Row]:
    """A row for each scene of a result of `rna-bench scenes`."""
    name = Path(result["asset"]).stem.replace("_", " ")
    tier = "" if result["tier"] == "default" else f", {result['tier']}"
    rows = []
    for scene, results in result["scenes"].items():
        floors = {"ours": results["floor"]["flip"], "Cycles": None}
        waits = {
            side: {
                target: sooner(
                    [wait_for(target, results[k], floors[side]) for k in keys if results[k]]
                )
                for target in targets
            }
            for side, keys in _SIDES.items()
        }
        rows.append(Row(name + tier, scene, waits))
    return rows


def table(rows: Sequence[Row]) -> str:
    """Markdown."""
    targets = _targets(rows)
    heads = [f"FLIP {target:g}: {side}" for target in targets for side in _SIDES]
    lines = ["| asset, scene | " + " | ".join(heads) + " |", "| --- " * (1 + len(heads)) + "|"]
    for row in rows:
        cells = [str(row.waits[side][target]) for target in targets for side in _SIDES]
        lines.append(f"| {row.asset}, {row.scene} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _first(rows: Sequence[Row]) -> str:
    """In how many scenes each side is there first."""
    lines = []
    for target in _targets(rows):
        pairs = [[row.waits[side][target].seconds or np.inf for side in _SIDES] for row in rows]
        ours, theirs = sum(a < b for a, b in pairs), sum(b < a for a, b in pairs)
        lines.append(
            f"FLIP {target:g}: ours first in {ours} of {len(rows)} scenes, Cycles in {theirs}"
        )
    return "\n".join(lines)


def _targets(rows: Sequence[Row]) -> list[float]:
    return list(rows[0].waits["ours"])


def draw(rows: Sequence[Row], path: Path) -> None:
    """Write the chart: a line for each row, a panel for each target."""
    from rna_bench.plot_style import CYCLES, OURS, figure, log_ticks, save_chart

    waits = [wait for row in rows for side in row.waits.values() for wait in side.values()]
    missed_at = 1.6 * max((wait.seconds for wait in waits if wait.seconds), default=1.0)
    chart = figure(11.0, 1.0 + 0.24 * len(rows))
    targets = _targets(rows)
    panels = chart.subplots(1, len(targets), sharey=True, squeeze=False)[0]
    for axes, target in zip(panels, targets, strict=True):
        for side, style in (("ours", (OURS, "o", -0.15)), ("Cycles", (CYCLES, "s", 0.15))):
            _draw_side(axes, rows, target, side, style, missed_at)
        axes.set(xscale="log", xlim=(None, 1.25 * missed_at))
        log_ticks(axes.xaxis)
        axes.set_xlabel("seconds; hollow: at most; cross: not reached")
        axes.set_title(f"until FLIP {target:g}, raw or denoised")
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
    parser.add_argument(
        "--targets", type=float, nargs="+", default=list(TARGETS), help="target FLIP values"
    )
    parser.add_argument("--out", type=Path, help="SVG to draw (path, default: only the table)")


def run(args: argparse.Namespace) -> None:
    """Print the table, and draw it."""
    of_targets = partial(rows_of, targets=args.targets)
    rows = [row for path in args.results for row in read_scenes(path, of_targets)]
    print(table(rows))
    print(_first(rows))
    if args.out:
        draw(rows, args.out)
        print(f"wrote {args.out}")

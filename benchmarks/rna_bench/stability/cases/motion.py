"""Shapes that bend: each point is asked where it was at rest, its own shadows are those of now."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.figure import FigureBase

from rna_bench.stability.case import Case, Row, Verdict, values
from rna_bench.stability.fixtures import ASSETS, Fixtures
from rna_bench.stability.moved_asset import MovedAsset, Seen, joined
from rna_bench.stability.moved_references import Views, references
from rna_bench.stability.view_errors import relative_error

MOST, AT_DEG = 1.25, 30.0  # the mark: times the error at rest, at that angle
JUDGED = ("figure", "slab")

ANGLES = (10.0, 30.0, 60.0, 90.0)  # degrees; the recipes' frames are one more
MOVED_DEG = 2.0  # from which a triangle or segment counts as moved
STRETCHES = (1.0, 1.05, 1.1, 1.2, 1.4, 2.0, np.inf)
NEAR = 0.03  # of the asset's radius: skin that comes as near to skin touches
_FEW = 200  # pixels, below which no error is told

CAPTURES: dict[str, dict[str, int]] = {
    "figure": {"lights": 500, "rays": 4096, "samples": 4},
    "slab": {"lights": 400, "rays": 2048, "samples": 4},
    "flag": {"lights": 250, "rays": 2048, "samples": 4},
    "tail": {"lights": 150, "rays": 4096, "samples": 2},
}


@dataclass(frozen=True)
class Frame:
    """An asset in one frame: what its images say, and how its elements have moved.

    halves: (2, n, 3), of Cycles, in the order of `seen`.
    """

    asset: MovedAsset
    seen: Seen
    halves: np.ndarray

    @cached_property
    def gaps(self) -> np.ndarray:
        """See `MovedAsset.gaps`."""
        return self.asset.gaps()

    def rows(self, elements: np.ndarray) -> np.ndarray:
        """(n,) bool: pixels that show these elements, (t,) bool."""
        return np.asarray(elements[self.seen.element])


def measure(fixtures: Fixtures) -> list[Row]:
    return [row for name in fixtures.moving for row in rows_of(fixtures, name)]


def rows_of(fixtures: Fixtures, name: str) -> list[Row]:
    """The rows of one of the suite's assets."""
    package = fixtures.package_of(capture(fixtures, name))
    frames = [1, *(1 + int(angle) for angle in ANGLES)]
    found = references(fixtures, name, ASSETS / "motion" / f"{name}.py", package, frames)
    views = Views.around([found[f"{frame}-positions"] for frame in frames])
    shown = [shade(package, views, found, frame) for frame in frames]
    rest, moved = shown[0], dict(zip(ANGLES, shown[1:], strict=True))
    rows = [row for angle, frame in moved.items() for row in by_angle(rest, frame, angle)]
    rows += by_stretch(rest, list(moved.values()))
    return [{"asset": name, **row} for row in rows]


def capture(fixtures: Fixtures, name: str) -> Any:
    """The asset at rest."""
    settings = CAPTURES[name]
    return fixtures.capture(
        f"motion-{name}",
        f"motion/{name}.py",
        **(settings | {"lights": fixtures.some(settings["lights"])}),
        validation_views=2,
        validation_resolution=96,
        validation_samples=128,
    )


def shade(package: Any, views: Views, found: dict[str, np.ndarray], frame: int) -> Frame:
    """An asset in a frame, in all views; pixels that either side does not see are left out."""
    asset = MovedAsset(package, found[f"{frame}-positions"])
    seen = [asset.see(*views.rays(k), views.wi[k]) for k in range(len(views.wi))]
    whole = joined(seen, [views.pixels] * len(seen))
    kept = found[f"{frame}-alpha"][whole.ray] > 0.999
    rows = {name: getattr(whole, name)[kept] for name in Seen.__dataclass_fields__}
    return Frame(asset, Seen(**rows), found[f"{frame}-halves"][:, rows["ray"]])


def by_angle(rest: Frame, frame: Frame, angle: float) -> list[Row]:
    """Errors of what has moved, of what newly touches, and of all, over those at rest."""
    turned, stretch = frame.asset.turned_deg(), frame.asset.stretch()
    touching = newly_near(rest, frame)
    chosen = {
        "moved": turned > MOVED_DEG,
        "whole": np.ones(len(turned), bool),
        "touching": np.isin(np.arange(len(turned)), frame.seen.element[touching]),
    }
    rows = []
    for where, elements in chosen.items():
        shown = touching if where == "touching" else frame.rows(elements)
        compared = over_rest([(frame, shown)], [(rest, rest.rows(elements))])
        if compared is not None:
            most = float(np.percentile(stretch[elements], 99.0))
            rows.append({"angle_deg": angle, "where": where, **compared, "stretch": most})
    return rows


Pixels = Sequence[tuple[Frame, np.ndarray]]
"""Frames, and which rows of each, (n,) bool."""


def over_rest(now: Pixels, then: Pixels) -> Row | None:
    """Errors and brightness of pixels now and at rest; None where there are few."""
    sides = []
    for pixels in (now, then):
        ours = np.concatenate([frame.seen.radiance[rows] for frame, rows in pixels])
        halves = np.concatenate([frame.halves[:, rows] for frame, rows in pixels], axis=1)
        if len(ours) < _FEW:
            return None
        brightness = float(ours.mean(dtype=np.float64) / halves.mean(dtype=np.float64))
        sides.append((relative_error(ours, halves), brightness, len(ours)))
    (error, brightness, count), (before, brightness_before, _) = sides
    return {
        "error": error,
        "at_rest": before,
        "brightness": brightness,
        "brightness_at_rest": brightness_before,
        "pixels": count,
    }


def newly_near(rest: Frame, frame: Frame) -> np.ndarray:
    """(n,) bool: pixels that show skin with skin near before it, which was not at rest."""
    if frame.asset.kind == "fiber":
        return np.zeros(len(frame.seen.ray), bool)
    near = NEAR * frame.asset.radius
    side, element = (~frame.seen.front).astype(int), frame.seen.element
    return np.asarray((frame.gaps[side, element] < near) & (rest.gaps[side, element] >= near))


def by_stretch(rest: Frame, frames: Sequence[Frame]) -> list[Row]:
    """Errors over those of the same elements at rest, all frames together, by their stretch."""
    stretch = [frame.asset.stretch() for frame in frames]
    rows = []
    for low, high in pairwise(STRETCHES):
        bins = [(s >= low) & (s < high) for s in stretch]
        now = [(frame, frame.rows(b)) for frame, b in zip(frames, bins, strict=True)]
        compared = over_rest(now, [(rest, rest.rows(b)) for b in bins])
        if compared is not None:
            rows.append({"where": "stretch", "low": low, **compared})
    return rows


def times(rows: list[Row], asset: str, where: str) -> dict[float, float]:
    """Angle -> error over that of the same elements at rest."""
    chosen = [row for row in rows if row["asset"] == asset and row["where"] == where]
    return {row["angle_deg"]: row["error"] / row["at_rest"] for row in chosen}


def judge(rows: list[Row]) -> Verdict:
    told, passed = [], True
    for asset in dict.fromkeys(values(rows, "asset")):
        rise = times(rows, asset, "moved")
        if asset in JUDGED:
            passed &= rise[AT_DEG] <= MOST
        told.append(f"{asset} " + ", ".join(f"{value:.2f}" for value in rise.values()))
    told += [f"{asset} not measured" for asset in JUDGED if asset not in values(rows, "asset")]
    at = ", ".join(f"{angle:g}" for angle in ANGLES)
    return Verdict(passed, f"times the error at rest, at {at} degrees: {'; '.join(told)}")


def draw(figure: FigureBase, rows: list[Row]) -> None:
    by_turn, by_length = figure.subplots(1, 2, sharey=True)
    for asset in dict.fromkeys(values(rows, "asset")):
        rise = {0.0: 1.0} | times(rows, asset, "moved")
        by_turn.plot(list(rise), list(rise.values()), "o-", label=asset)
        of_stretch = [r for r in rows if r["asset"] == asset and r["where"] == "stretch"]
        ratio = [row["error"] / row["at_rest"] for row in of_stretch]
        by_length.plot([row["low"] for row in of_stretch], ratio, "o-", label=asset)
    for axes in (by_turn, by_length):
        axes.axhline(MOST, color="0.6", lw=0.8)
        axes.set_yscale("log", base=2)
        axes.yaxis.set_major_formatter("{x:g}")
    by_turn.set_xlabel("angle, degrees")
    by_turn.set_ylabel("error of what moved / at rest")
    by_length.set_xlabel("stretch, from")
    by_turn.legend()


CASE = Case(
    name="motion",
    title="Motion",
    varies="a figure with joints, a bending slab, a flag and a ponytail, by angle and stretch; the "
    "suite's own assets",
    mark=f"at 30 degrees the moved part of figure and slab has at most {MOST} times its error at "
    "rest",
    advice="Light between parts, and inside what bends, is that of the rest pose.",
    measure=measure,
    judge=judge,
    draw=draw,
)

"""Shapes that bend: each point is asked where it was at rest, its own shadows are those of now."""

from __future__ import annotations

from dataclasses import dataclass
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
MOVED_DEG = 2.0  # from which a triangle counts as moved
_FEW = 200  # pixels, below which no error is told

CAPTURES: dict[str, dict[str, int]] = {
    "figure": {"lights": 500, "rays": 4096, "samples": 4},
    "slab": {"lights": 400, "rays": 2048, "samples": 4},
    "flag": {"lights": 250, "rays": 2048, "samples": 4},
}


@dataclass(frozen=True)
class Frame:
    """An asset in one frame: what its images say, and how its elements have moved.

    halves: (2, n, 3), of Cycles, in the order of `seen`.
    """

    asset: MovedAsset
    seen: Seen
    halves: np.ndarray

    def error(self, triangles: np.ndarray) -> tuple[float, float, int] | None:
        """Error, brightness over Cycles' and number of the pixels that show these, (t,) bool.

        None where there are few.
        """
        rows = triangles[self.seen.element]
        ours, halves = self.seen.radiance[rows], self.halves[:, rows]
        if len(ours) < _FEW:
            return None
        brightness = float(ours.mean(dtype=np.float64) / halves.mean(dtype=np.float64))
        return relative_error(ours, halves), brightness, len(ours)


def measure(fixtures: Fixtures) -> list[Row]:
    return [row for name in CAPTURES for row in rows_of(fixtures, name)]


def rows_of(fixtures: Fixtures, name: str) -> list[Row]:
    """The rows of one of the suite's assets."""
    package = fixtures.package_of(capture(fixtures, name))
    frames = [1, *(1 + int(angle) for angle in ANGLES)]
    found = references(fixtures, name, ASSETS / "motion" / f"{name}.py", package, frames)
    views = Views.around([found[f"{frame}-positions"] for frame in frames])
    shown = [shade(package, views, found, frame) for frame in frames]
    rest, moved = shown[0], dict(zip(ANGLES, shown[1:], strict=True))
    rows = [row for angle, frame in moved.items() for row in by_angle(rest, frame, angle)]
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
    whole = joined(seen, views.pixels)
    kept = found[f"{frame}-alpha"][whole.ray] > 0.999
    rows = {name: getattr(whole, name)[kept] for name in Seen.__dataclass_fields__}
    return Frame(asset, Seen(**rows), found[f"{frame}-halves"][:, rows["ray"]])


def by_angle(rest: Frame, frame: Frame, angle: float) -> list[Row]:
    """Errors of what has moved, and of all, over those of the same triangles at rest."""
    turned, rows = frame.asset.turned_deg(), []
    for where, least in (("moved", MOVED_DEG), ("whole", -1.0)):
        now, before = frame.error(turned > least), rest.error(turned > least)
        if now is not None and before is not None:
            row = {"angle_deg": angle, "where": where, "error": now[0], "at_rest": before[0]}
            row |= {"brightness": now[1], "brightness_at_rest": before[1], "pixels": now[2]}
            rows.append(row)
    return rows


def times(rows: list[Row], asset: str) -> dict[float, float]:
    """Angle -> error of what moved, over that of the same triangles at rest."""
    chosen = [row for row in rows if row["asset"] == asset and row["where"] == "moved"]
    return {row["angle_deg"]: row["error"] / row["at_rest"] for row in chosen}


def judge(rows: list[Row]) -> Verdict:
    told, passed = [], True
    for asset in dict.fromkeys(values(rows, "asset")):
        rise = times(rows, asset)
        if asset in JUDGED:
            passed &= rise[AT_DEG] <= MOST
        told.append(f"{asset} " + ", ".join(f"{value:.2f}" for value in rise.values()))
    at = ", ".join(f"{angle:g}" for angle in ANGLES)
    return Verdict(passed, f"times the error at rest, at {at} degrees: {'; '.join(told)}")


def draw(figure: FigureBase, rows: list[Row]) -> None:
    axes = figure.subplots()
    for asset in dict.fromkeys(values(rows, "asset")):
        rise = {0.0: 1.0} | times(rows, asset)
        axes.plot(list(rise), list(rise.values()), "o-", label=asset)
    axes.axhline(MOST, color="0.6", lw=0.8)
    axes.set_yscale("log", base=2)
    axes.yaxis.set_major_formatter("{x:g}")
    axes.set_xlabel("angle, degrees")
    axes.set_ylabel("error of what moved / at rest")
    axes.legend()


CASE = Case(
    name="motion",
    title="Motion",
    varies="a figure with joints, a bending slab and a flag, by angle; the suite's own assets",
    mark=f"at 30 degrees the moved part of figure and slab has at most {MOST} times its error at "
    "rest",
    advice="Light between parts, and inside what bends, is that of the rest pose.",
    measure=measure,
    judge=judge,
    draw=draw,
)

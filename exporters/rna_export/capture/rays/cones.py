"""Cones of directions: towards spheres, and few instead of many."""

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from rna_sdk.package import Cone
from rna_sdk.package.limits import MAX_CONES
from rna_sdk.package.manifest.manifest_fields import Region


@dataclass(frozen=True)
class Cap:
    """Directions within an angle of an axis.

    axis: (3,) unit. half_angle: radians; pi and more is all directions.
    """

    axis: np.ndarray
    half_angle: float

    def angle_to(self, other: "Cap") -> float:
        """Between the axes, radians."""
        # arccos would lose small angles.
        apart = np.linalg.norm(np.cross(self.axis, other.axis))
        return float(np.arctan2(apart, self.axis @ other.axis))

    def holds(self, other: "Cap") -> bool:
        """Whether all directions of another are among these."""
        angle = self.angle_to(other) + other.half_angle
        return self.half_angle >= min(angle, np.pi) - 1e-9


EVERYWHERE = Cap(np.array([0.0, 1.0, 0.0]), np.pi)


def cap_towards(centre: np.ndarray, radius: float) -> Cap:
    """Directions from any point of a ball about the origin to any point of another, (3,) away.

    radius: the sum of both.
    """
    distance = float(np.linalg.norm(centre))
    if distance <= radius:
        return EVERYWHERE
    return Cap(centre / distance, float(np.arcsin(radius / distance)))


def merged(caps: Iterable[Cap], margin: float) -> Region:
    """All the caps' directions, and those `margin` (radians) around, as few cones of a domain."""
    result: list[Cap] = []
    for cap in caps:
        wide = Cap(cap.axis, cap.half_angle + margin)
        if any(one.holds(wide) for one in result):
            continue
        result = [one for one in result if not wide.holds(one)] + [wide]
        if len(result) > MAX_CONES:
            result = _with_one_less(result)
    if not result or any(cap.half_angle >= np.pi for cap in result):
        return "sphere"
    return tuple(
        Cone(axis=tuple(cap.axis.tolist()), half_angle=float(cap.half_angle)) for cap in result
    )


def around_both(a: Cap, b: Cap) -> Cap:
    """The smallest cap that holds two."""
    if a.holds(b) or b.holds(a):
        return a if a.holds(b) else b
    between = a.angle_to(b)
    half_angle = (between + a.half_angle + b.half_angle) / 2.0
    if half_angle >= np.pi:
        return EVERYWHERE
    # From a's axis towards b's.
    turn = half_angle - a.half_angle
    side = b.axis - (b.axis @ a.axis) * a.axis
    if np.linalg.norm(side) < 1e-9:  # opposite axes: any way around
        side = np.cross(a.axis, np.eye(3)[np.argmin(np.abs(a.axis))])
    side = side / np.linalg.norm(side)
    return Cap(np.cos(turn) * a.axis + np.sin(turn) * side, half_angle)


def _with_one_less(caps: list[Cap]) -> list[Cap]:
    """The cones with one pair merged: the one with the smallest enclosing cone."""
    pairs = [(around_both(a, b), a, b) for a, b in combinations(caps, 2)]
    smallest, first, second = min(pairs, key=lambda pair: pair[0].half_angle)
    rest = [cap for cap in caps if cap is not first and cap is not second]
    return [cap for cap in rest if not smallest.holds(cap)] + [smallest]

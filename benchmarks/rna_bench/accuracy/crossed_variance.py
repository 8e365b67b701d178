"""Mean squares of a residual that depends on a point, a view of it and a light, by what it needs.

r = a(point) + b(point, view) + c(point, light) + d(point, view, light), whose parts have mean 0 and
are uncorrelated: an analysis of variance with views nested in points and crossed with lights.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class CrossedParts(NamedTuple):
    """Mean squares of the parts of a residual; they add up to that of the residual itself."""

    point: float
    point_and_view: float
    point_and_light: float
    all_three: float

    @property
    def total(self) -> float:
        """Mean square of the residual."""
        return sum(self)


def crossed_parts(one: np.ndarray, other: np.ndarray) -> CrossedParts:
    """The parts of a residual, of two measurements with independent noise.

    one, other: (points, views, lights). A product of both has no noise in its mean. Estimates of
    parts that are not there may be below 0.
    """
    _, v, n = one.shape
    means: list[tuple[int, ...]] = [(), (2,), (1,), (1, 2)]
    found = [float((one.mean(axis=m) * other.mean(axis=m)).mean()) for m in means]
    # What is left of each part in the mean over nothing, lights, views, and both.
    left = [
        [1.0, 1.0, 1.0, 1.0],
        [1.0, 1.0, 1.0 / n, 1.0 / n],
        [1.0, 1.0 / v, 1.0, 1.0 / v],
        [1.0, 1.0 / v, 1.0 / n, 1.0 / (v * n)],
    ]
    return CrossedParts(*np.linalg.solve(left, found).tolist())

"""Directions, colours and densities that several lights share."""

import numpy as np

from rna_sdk.machine.compiled import compiled
from rna_trace.vectors import Vector, along

# Rec. ITU-R BT.709-6, item 3.2: luminance of linear RGB.
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])

# Densities above this leave float32 when they are squared; what is so unlikely to be found by
# chance is as good as not there.
MAX_PDF = 1e18


Axes = Vector | np.ndarray
"""Three numbers."""


def luminance(rgb: np.ndarray) -> np.ndarray:
    """(...) float64 of linear RGB, (..., 3)."""
    return np.asarray(np.asarray(rgb, np.float64) @ LUMINANCE)


def facing_frame(
    position: tuple[float, float, float],
    look_at: tuple[float, float, float],
    up: tuple[float, float, float] | None = None,
) -> np.ndarray:
    """Rotation and place of something at `position` whose +z points to `look_at`.

    up: where +y points to as nearly as it can; anywhere if None. Returns (4, 4) float64.
    """
    forward = unit(np.subtract(look_at, position))
    if up is None:
        up = np.eye(3)[np.argmin(np.abs(forward))]
    right = unit(np.cross(up, forward))
    matrix = np.eye(4)
    matrix[:3] = np.stack([right, np.cross(forward, right), forward, position], axis=1)
    return matrix


def unit(vector: Axes) -> np.ndarray:
    """The vector, (3,), at length one: (3,) float64."""
    vector = np.asarray(vector, np.float64)
    return np.asarray(vector / np.linalg.norm(vector))


@compiled(fastmath=())
def cone_direction(
    x: float, y: float, z: float, one_minus_cosine: float, u1: float, u2: float
) -> Vector:
    """A direction within a cone about the unit axis (x, y, z), uniform for u in [0, 1)^2.

    one_minus_cosine: of the angle from the axis to the rim. It comes as a difference because
    narrow cones, such as the sun's, would lose it to the rounding of the cosine.
    """
    height = u1 * one_minus_cosine
    sin_theta = np.sqrt(max(0.0, height * (2.0 - height)))
    cos_theta, phi = 1.0 - height, 2.0 * np.pi * u2
    return along((x, y, z), sin_theta * np.cos(phi), sin_theta * np.sin(phi), cos_theta)


@compiled(fastmath=())
def flat_pdf(
    point: Axes, normal: Axes, both_sides: bool, per_area: float, x: Axes, d: Axes
) -> float:
    """Density per steradian of the direction d, seen from x, of points of a plane.

    point, normal: of the plane, normal unit. per_area: density of the points per m^2. d: unit.
    0 where d does not meet the plane's front, or either side if both_sides is True.
    """
    cosine, height = 0.0, 0.0
    for axis in range(3):
        cosine -= d[axis] * normal[axis]
        height += (x[axis] - point[axis]) * normal[axis]
    if both_sides and height < 0.0:
        cosine, height = -cosine, -height
    if not (cosine > 0.0 and height > 0.0):
        return 0.0
    t = height / cosine
    pdf = per_area * t * t / cosine
    return pdf if pdf < MAX_PDF else 0.0

"""Light from far away: from one direction, or from a small disk of the sky as the sun's."""

from __future__ import annotations

import numpy as np

from rna_render.lights.base import InfiniteLight, Light
from rna_render.lights.directions import cone_direction, luminance, unit
from rna_render.lights.kinds import DIRECTIONAL, SUN, light_row, row_places
from rna_render.scene.light_models import DirectionalModel
from rna_sdk.compiled import compiled
from rna_trace.vectors import Vector

# Radians from the axis to the rim. Below it float32 directions no longer tell the rim apart.
MIN_ANGLE = 1e-5

_DIRECTION = row_places("directional")["axis"]
_AXIS, _ONE_MINUS_COSINE = (row_places("sun")[name] for name in ("axis", "one_minus_cosine"))


def directional_light(model: DirectionalModel) -> Light:
    """A DirectionalLight, or a SunLight where the model has an angular diameter."""
    large = np.radians(model.angular_diameter_deg) / 2.0 >= MIN_ANGLE
    return SunLight(model) if large else DirectionalLight(model)


class DirectionalLight(Light):
    """Irradiance from one direction."""

    delta = True

    def __init__(self, model: DirectionalModel) -> None:
        self.group = model.group
        self._irradiance = np.asarray(model.irradiance, np.float32)
        self.row = light_row(DIRECTIONAL, self._irradiance, axis=unit(model.direction))

    def power(self, scene_radius: float) -> float:
        return float(np.pi * scene_radius**2 * luminance(self._irradiance))


class SunLight(InfiniteLight):
    """Equal radiance from all directions within an angle of an axis; no camera sees it.

    A plane that faces it gets the model's irradiance: the cone's projected solid angle about its
    axis is pi sin^2 of the angle from the axis to the rim.
    """

    delta = False
    visible_to_camera = False

    def __init__(self, model: DirectionalModel) -> None:
        self.group = model.group
        angle = np.radians(model.angular_diameter_deg) / 2.0
        one_minus_cosine = 2.0 * np.sin(angle / 2.0) ** 2
        self._irradiance = np.asarray(model.irradiance, np.float64)
        radiance = self._irradiance / (np.pi * np.sin(angle) ** 2)
        cone = {"axis": unit(model.direction), "one_minus_cosine": one_minus_cosine}
        self.row = light_row(SUN, radiance, **cone)

    def power(self, scene_radius: float) -> float:
        return float(np.pi * scene_radius**2 * luminance(self._irradiance))


@compiled(fastmath=())
def sample_directional(numbers: np.ndarray) -> tuple[Vector, Vector]:
    """Direction and irradiance."""
    wi = numbers[_DIRECTION], numbers[_DIRECTION + 1], numbers[_DIRECTION + 2]
    return wi, (numbers[0], numbers[1], numbers[2])


@compiled(fastmath=())
def _sun(numbers: np.ndarray) -> tuple[Vector, float]:
    """Axis, and 1 - cos of the angle to the rim."""
    axis = numbers[_AXIS], numbers[_AXIS + 1], numbers[_AXIS + 2]
    return axis, numbers[_ONE_MINUS_COSINE]


@compiled(fastmath=())
def sample_sun(numbers: np.ndarray, u1: float, u2: float) -> tuple[Vector, Vector, float]:
    """Direction, radiance and density."""
    axis, one_minus_cosine = _sun(numbers)
    wi = cone_direction(axis[0], axis[1], axis[2], one_minus_cosine, u1, u2)
    return wi, (numbers[0], numbers[1], numbers[2]), 1.0 / (2.0 * np.pi * one_minus_cosine)


@compiled(fastmath=())
def look_up_sun(numbers: np.ndarray, d: Vector) -> tuple[Vector, float]:
    """Radiance from d, and the density of `sample_sun`."""
    # |d - axis|^2 = 2 (1 - cos), without the rounding of a cosine near 1.
    axis, one_minus_cosine = _sun(numbers)
    x, y, z = d[0] - axis[0], d[1] - axis[1], d[2] - axis[2]
    if x * x + y * y + z * z > 2.0 * one_minus_cosine:
        return (0.0, 0.0, 0.0), 0.0
    return (numbers[0], numbers[1], numbers[2]), 1.0 / (2.0 * np.pi * one_minus_cosine)

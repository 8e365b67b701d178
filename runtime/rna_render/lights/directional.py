"""Light from far away: from one direction, or from a small disk of the sky as the sun's."""

from __future__ import annotations

import numpy as np
from numba import prange

from rna_render.lights.base import InfiniteLight, Light, LightSamples
from rna_render.lights.directions import cone_direction, luminance, unit
from rna_render.lights.models import DirectionalModel
from rna_sdk.compiled import compiled

# Radians from the axis to the rim. Below it float32 directions no longer tell the rim apart.
MIN_ANGLE = 1e-5


def directional_light(model: DirectionalModel) -> Light:
    """A DirectionalLight, or a SunLight where the model has an angular diameter."""
    large = np.radians(model.angular_diameter_deg) / 2.0 >= MIN_ANGLE
    return SunLight(model) if large else DirectionalLight(model)


class DirectionalLight(Light):
    """Irradiance from one direction."""

    delta = True

    def __init__(self, model: DirectionalModel) -> None:
        self.group = model.group
        self._wi_world = unit(model.direction).astype(np.float32)
        self._irradiance = np.asarray(model.irradiance, np.float32)

    def power(self, scene_radius: float) -> float:
        return float(np.pi * scene_radius**2 * luminance(self._irradiance))

    def sample(self, x_world: np.ndarray, u: np.ndarray) -> LightSamples:
        n = len(x_world)
        return LightSamples(
            wi_world=np.tile(self._wi_world, (n, 1)),
            distance=np.full(n, np.inf, np.float32),
            radiance=np.tile(self._irradiance, (n, 1)),
            pdf=np.ones(n, np.float32),
        )


class SunLight(InfiniteLight):
    """The same radiance from all directions within an angle of an axis; no camera sees it.

    A plane that faces it gets the model's irradiance: the cone's projected solid angle about its
    axis is pi sin^2 of the angle from the axis to the rim.
    """

    delta = False
    visible_to_camera = False

    def __init__(self, model: DirectionalModel) -> None:
        self.group = model.group
        angle = np.radians(model.angular_diameter_deg) / 2.0
        self._axis = unit(model.direction)
        self._one_minus_cosine = 2.0 * np.sin(angle / 2.0) ** 2
        self._pdf = 1.0 / (2.0 * np.pi * self._one_minus_cosine)
        self._irradiance = np.asarray(model.irradiance, np.float64)
        self._radiance = (self._irradiance / (np.pi * np.sin(angle) ** 2)).astype(np.float32)

    def power(self, scene_radius: float) -> float:
        return float(np.pi * scene_radius**2 * luminance(self._irradiance))

    def sample(self, x_world: np.ndarray, u: np.ndarray) -> LightSamples:
        n = len(x_world)
        wi_world = np.empty((n, 3), np.float32)
        _sample_cone(self._axis, self._one_minus_cosine, u, wi_world)
        return LightSamples(
            wi_world=wi_world,
            distance=np.full(n, np.inf, np.float32),
            radiance=np.tile(self._radiance, (n, 1)),
            pdf=np.full(n, self._pdf, np.float32),
        )

    def escaped(self, d_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        # |d - axis|^2 = 2 (1 - cos), without the rounding of a cosine near 1.
        chord = np.sum((d_world.astype(np.float64) - self._axis) ** 2, axis=1)
        inside = chord <= 2.0 * self._one_minus_cosine
        pdf = np.where(inside, np.float32(self._pdf), np.float32(0.0))
        return np.where(inside[:, None], self._radiance, np.float32(0.0)), pdf


@compiled(parallel=True, fastmath=())
def _sample_cone(axis, one_minus_cosine, u, wi_world):
    for i in prange(len(wi_world)):
        wi = cone_direction(axis[0], axis[1], axis[2], one_minus_cosine, u[i, 0], u[i, 1])
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = wi

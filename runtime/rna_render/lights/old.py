"""Lights: where their light comes from at a surface point, and what it is worth.

Each light gives, for a batch of points, one direction a point and the weight that the asset's
transport T has in the estimate: irradiance for a light from one direction, L / pdf for a sampled
one. T contains the cosine, so there is none here.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numba import njit, prange

from rna_render.sampling import sample_sphere_mixture, sphere_mixture_pdf
from rna_render.scene_model import DirectionalModel, EnvironmentModel, LightModel, PointModel


@dataclass(frozen=True, slots=True)
class LightSamples:
    """One direction towards a light from each of n points.

    wi_world: (n, 3) float32, unit. distance: (n,) float32, to the light, maybe infinite.
    weight: (n, 3) float32 or (3,), RGB that multiplies T.
    """

    wi_world: np.ndarray
    distance: np.ndarray
    weight: np.ndarray


class Light(Protocol):
    """A light of the scene."""

    delta: bool
    """Whether all its light at a point comes from one direction, so nothing is left to chance."""

    def sample(
        self, x_world: np.ndarray, n_world: np.ndarray, u: np.ndarray | None
    ) -> LightSamples:
        """Directions for points x and normals n, (n, 3) float32.

        u: (n, 2) in [0, 1), or None for a delta light.
        """
        ...


class DirectionalLight:
    """Irradiance from one direction."""

    delta = True

    def __init__(self, model: DirectionalModel) -> None:
        direction = np.asarray(model.direction, np.float64)
        self._wi_world = (direction / np.linalg.norm(direction)).astype(np.float32)
        self._irradiance = np.asarray(model.irradiance, np.float32)

    def sample(self, x_world: np.ndarray, n_world: np.ndarray, u: None) -> LightSamples:
        wi_world = np.tile(self._wi_world, (len(x_world), 1))
        distance = np.full(len(x_world), np.inf, np.float32)
        return LightSamples(wi_world, distance, self._irradiance)


class PointLight:
    """Intensity I from one point: irradiance I / r^2 at distance r."""

    delta = True

    def __init__(self, model: PointModel) -> None:
        self._position = np.asarray(model.position, np.float64)
        self._intensity = np.asarray(model.intensity, np.float64)

    def sample(self, x_world: np.ndarray, n_world: np.ndarray, u: None) -> LightSamples:
        wi_world, weight = np.empty_like(x_world), np.empty_like(x_world)
        distance = np.empty(len(x_world), np.float32)
        _towards(self._position, self._intensity, x_world, wi_world, distance, weight)
        return LightSamples(wi_world, distance, weight)


class EnvironmentLight:
    """The same radiance from everywhere, sampled over the whole sphere."""

    delta = False

    def __init__(self, model: EnvironmentModel) -> None:
        self._radiance = np.asarray(model.radiance, np.float64)

    def sample(self, x_world: np.ndarray, n_world: np.ndarray, u: np.ndarray) -> LightSamples:
        wi_world = sample_sphere_mixture(n_world, u)
        pdf = sphere_mixture_pdf(n_world, wi_world)
        weight = (self._radiance / pdf[:, None]).astype(np.float32)
        return LightSamples(wi_world, np.full(len(pdf), np.inf, np.float32), weight)


def make_light(model: LightModel) -> Light:
    """The light that a scene file describes."""
    if isinstance(model, DirectionalModel):
        return DirectionalLight(model)
    if isinstance(model, PointModel):
        return PointLight(model)
    return EnvironmentLight(model)


@njit(cache=True, parallel=True)
def _towards(position, intensity, x_world, wi_world, distance, weight):
    for i in prange(len(x_world)):
        dx = position[0] - x_world[i, 0]
        dy = position[1] - x_world[i, 1]
        dz = position[2] - x_world[i, 2]
        squared = dx * dx + dy * dy + dz * dz
        # A light that stands on the surface lights nothing: its direction does not exist.
        r = np.sqrt(squared)
        scale = 1.0 / r if r > 0.0 else 0.0
        distance[i] = r
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = dx * scale, dy * scale, dz * scale
        for channel in range(3):
            weight[i, channel] = intensity[channel] * scale * scale

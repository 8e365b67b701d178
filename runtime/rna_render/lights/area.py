"""What lights of one shape and one radiance have in common."""

from __future__ import annotations

from abc import abstractmethod

import numpy as np

from rna_render.lights.base import LightSamples, PlacedLight
from rna_render.lights.directions import luminance
from rna_render.lights.models import DiskModel, RectangleModel, SphereModel
from rna_render.rays import vectors
from rna_render.tracing import ClosestHits


class AreaLight(PlacedLight):
    """The same radiance from every point of one side of a shape, to every direction.

    area: m^2, of the side that shines.
    """

    delta = False

    def __init__(self, model: RectangleModel | DiskModel | SphereModel, area: float) -> None:
        self.group = model.group
        self.visible_to_camera = model.visible_to_camera
        self.area = area
        self._radiance = np.asarray(model.radiance, np.float32)

    def power(self, scene_radius: float) -> float:
        return float(np.pi * self.area * luminance(self._radiance))

    def sample(self, x_world: np.ndarray, u: np.ndarray) -> LightSamples:
        x_world = vectors("x_world", x_world)
        n = len(x_world)
        wi_world = np.empty((n, 3), np.float32)
        distance, pdf = np.empty(n, np.float32), np.empty(n, np.float32)
        self._sample(x_world, u, wi_world, distance, pdf)
        return LightSamples(wi_world, distance, self._where_seen(pdf), pdf)

    def met(
        self, x_world: np.ndarray, d_world: np.ndarray, hits: ClosestHits, ng_world: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        x_world = vectors("x_world", x_world)
        pdf = np.empty(len(x_world), np.float32)
        self._pdf(x_world, vectors("d_world", d_world, len(x_world)), pdf)
        return self._where_seen(pdf), pdf

    def _where_seen(self, pdf: np.ndarray) -> np.ndarray:
        return np.where((pdf > 0.0)[:, None], self._radiance, np.float32(0.0))

    @abstractmethod
    def _sample(
        self,
        x_world: np.ndarray,
        u: np.ndarray,
        wi_world: np.ndarray,
        distance: np.ndarray,
        pdf: np.ndarray,
    ) -> None:
        """Write the last three, as in LightSamples."""

    @abstractmethod
    def _pdf(self, x_world: np.ndarray, d_world: np.ndarray, pdf: np.ndarray) -> None:
        """Write the density of directions that meet the shape, 0 where they meet its dark side.

        For the wi of `_sample` it is the pdf of `_sample`, to the bit.
        """

"""What lights of one shape and one radiance have in common."""

from __future__ import annotations

from typing import Any

import numpy as np

from rna_render.lights.base import PlacedLight
from rna_render.lights.directions import luminance
from rna_render.lights.kinds import light_row
from rna_render.scene.light_models import DiskModel, RectangleModel, SphereModel
from rna_trace.embree.tracing import ClosestHits
from rna_trace.rays import vectors


class AreaLight(PlacedLight):
    """Equal radiance from every point of one side of a shape, to every direction.

    area: m^2, of the side that shines. kind, shape: of its row.
    """

    delta = False

    def __init__(
        self,
        model: RectangleModel | DiskModel | SphereModel,
        area: float,
        kind: int,
        **shape: Any,
    ) -> None:
        self.group = model.group
        self.visible_to_camera = model.visible_to_camera
        self.area = area
        self._radiance = np.asarray(model.radiance, np.float32)
        self.row = light_row(kind, self._radiance, **shape)

    def power(self, scene_radius: float) -> float:
        return float(np.pi * self.area * luminance(self._radiance))

    def eval_hit(
        self, x_world: np.ndarray, d_world: np.ndarray, hits: ClosestHits, ng_world: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        from rna_render.lights.table import eval_hit_batch

        x_world = vectors("x_world", x_world)
        radiance, pdf = np.empty_like(x_world), np.empty(len(x_world), np.float32)
        lines = x_world, vectors("d_world", d_world, len(x_world))
        eval_hit_batch(self.row.kind, self.row.numbers, *lines, radiance, pdf)
        return radiance, pdf

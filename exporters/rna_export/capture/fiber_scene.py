"""Strands as capture sees them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_export.capture.asset_scene import AssetScene
from rna_export.capture.directions import around
from rna_render import fiber
from rna_render.fiber import tangents
from rna_render.parts_scene import PartsScene
from rna_sdk.package import Curves
from rna_sdk.runtime import offset_across


@dataclass(frozen=True)
class FiberPoints:
    """Where rays met the strands; every array has one row a ray, rows without a hit are zero."""

    hit: np.ndarray  # (n,) bool
    segment: np.ndarray  # (n,) int32, place in `Curves.segments()`
    position: np.ndarray  # (n, 3) float32
    geometric_normal: np.ndarray  # (n, 3) float32, of the round cone
    tangent: np.ndarray  # (n, 3) float32, root to tip
    h: np.ndarray  # (n,) float32, offset of the ray from the axis, in radii

    def sample_fields(self) -> dict[str, np.ndarray]:
        """See `ShadePoints`."""
        return {"position": self.position, "tangent": self.tangent, "h": self.h}


class FiberScene(AssetScene):
    """Ray queries against strands."""

    def __init__(self, curves: Curves):
        self.curves = curves
        self._scene = PartsScene([curves])
        self._first = curves.segments()
        root, tip = curves.points[self._first], curves.points[self._first + 1]
        length = np.linalg.norm(tip.astype(np.float64) - root, axis=1)
        area = length * (curves.radii[self._first] + curves.radii[self._first + 1])
        self._area_cdf = np.cumsum(area) / area.sum()
        low, high = curves.points.min(axis=0), curves.points.max(axis=0)
        self.centre = ((low + high) / 2).astype(np.float32)
        reach = np.linalg.norm(curves.points - self.centre, axis=1) + curves.radii
        self.radius = float(reach.max())

    def distance(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        return self._scene.intersect(origins, directions).t

    def shade_points(self, origins: np.ndarray, directions: np.ndarray) -> FiberPoints:
        hits = self._scene.intersect(origins, directions)
        hit = hits.part >= 0
        mask, segment = hit[:, None], np.where(hit, hits.primitive, 0).astype(np.int32)
        at = self._scene.points(0, segment, hits.u, hits.v, hits.normals)
        h = offset_across(hits.normals, at.tangent, -directions)
        return FiberPoints(hit, segment, at.x * mask, hits.normals, at.tangent * mask, h * hit)

    def sample_points(self, n: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        segment = np.minimum(
            np.searchsorted(self._area_cdf, rng.random(n)), len(self._area_cdf) - 1
        )
        first = self._first[segment]
        along = rng.random((n, 1)).astype(np.float32)
        axis = (1.0 - along) * self.curves.points[first] + along * self.curves.points[first + 1]
        radius = (1.0 - along) * self.curves.radii[first, None]
        radius = radius + along * self.curves.radii[first + 1, None]
        tangent = tangents(self.curves.points, self._first, segment.astype(np.int32))
        normals = around(tangent, np.zeros(n), 2.0 * np.pi * rng.random(n))
        return axis + radius * normals, normals

    def highlight_views(
        self, points: FiberPoints, wi: np.ndarray, rng: np.random.Generator
    ) -> tuple[np.ndarray, np.ndarray]:
        """About the cone of wi's mirror images (Marschner et al. 2003): all azimuths.

        Inclinations spread by 0.02 to 0.5 in their sine.
        """
        rows = np.flatnonzero(points.hit)
        spread = 0.02 * 25.0 ** rng.random(len(rows)) * rng.standard_normal(len(rows))
        sine = np.clip(-(points.tangent[rows] @ wi) + spread, -0.999, 0.999)
        return rows, around(points.tangent[rows], sine, 2.0 * np.pi * rng.random(len(rows)))

    def visible(self, points: FiberPoints, wi: np.ndarray) -> np.ndarray:
        at = points.position, points.geometric_normal, points.tangent, points.segment
        return self._scene.visible(0, fiber.FiberPoints(*at), wi)

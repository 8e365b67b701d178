"""A mesh as capture sees it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import trimesh

from rna_export.capture.asset_scene import AssetScene
from rna_export.capture.directions import around, reflect
from rna_export.capture.settings import SHARPEST
from rna_render.parts_scene import PartsScene
from rna_render.surface import SurfacePoints, geometric_normals
from rna_sdk.package import Mesh

_WIDEST = 0.8  # alpha of GGX


@dataclass(frozen=True)
class SurfaceHits:
    """Where rays met the mesh; every array has one row a ray, rows without a hit are zero."""

    hit: np.ndarray  # (n,) bool
    at: SurfacePoints

    @property
    def position(self) -> np.ndarray:
        """(n, 3) float32."""
        return self.at.x

    @property
    def normal(self) -> np.ndarray:
        """(n, 3) float32, interpolated corner normals."""
        return self.at.n

    @property
    def geometric_normal(self) -> np.ndarray:
        """(n, 3) float32."""
        return self.at.ng

    def sample_fields(self) -> dict[str, np.ndarray]:
        """See `ShadePoints`."""
        return {"position": self.position, "normal": self.normal}


class SurfaceScene(AssetScene):
    """Ray queries against one mesh.

    sharpest: roughness of the smoothest material whose highlights views are to find.
    """

    def __init__(self, mesh: Mesh, sharpest: float = SHARPEST):
        self.mesh = mesh
        self._narrowest = sharpest**2  # alpha of GGX
        self._scene = PartsScene([mesh])
        area = trimesh.triangles.area(mesh.positions[mesh.triangles].astype(np.float64))
        self._area_cdf = np.cumsum(area) / area.sum()
        every = np.arange(len(mesh.triangles), dtype=np.int32)
        self._geometric = geometric_normals(mesh.positions, mesh.triangles, every)
        low, high = mesh.positions.min(axis=0), mesh.positions.max(axis=0)
        self.centre = ((low + high) / 2).astype(np.float32)
        self.radius = float(np.linalg.norm(mesh.positions - self.centre, axis=1).max())

    def distance(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        return self._scene.intersect(origins, directions).t

    def shade_points(self, origins: np.ndarray, directions: np.ndarray) -> SurfaceHits:
        hits = self._scene.intersect(origins, directions)
        hit = hits.part >= 0
        triangle = np.where(hit, hits.primitive, 0)
        at = self._scene.points(0, triangle, hits.u, hits.v, hits.normals)
        for rows in (at.x, at.n, at.ng, at.lift):
            rows[~hit] = 0.0
        return SurfaceHits(hit, at)

    def sample_points(self, n: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        triangle = np.minimum(
            np.searchsorted(self._area_cdf, rng.random(n)), len(self._area_cdf) - 1
        )
        root, v = np.sqrt(rng.random(n)), rng.random(n)
        weights = np.stack([1.0 - root, root * (1.0 - v), root * v], axis=1).astype(np.float32)
        corners = self.mesh.positions[self.mesh.triangles[triangle]]
        return np.einsum("nc,nck->nk", weights, corners), self._geometric[triangle]

    def highlight_views(
        self, points: SurfaceHits, wi: np.ndarray, rng: np.random.Generator
    ) -> tuple[np.ndarray, np.ndarray]:
        """Mirrors of wi about half vectors of GGX, alpha from that of the sharpest lobe to 0.8."""
        lit = np.flatnonzero(points.hit & (points.normal @ wi > 0.02))
        width = self._narrowest * (_WIDEST / self._narrowest) ** rng.random(len(lit))
        u = rng.random(len(lit))
        cosine = np.sqrt((1.0 - u) / (1.0 + (width**2 - 1.0) * u))
        h = around(points.normal[lit], cosine, 2.0 * np.pi * rng.random(len(lit)))
        return lit, reflect(np.broadcast_to(wi, h.shape), h)

    def visible(self, points: SurfaceHits, wi: np.ndarray) -> np.ndarray:
        return self._scene.visible(0, points.at, wi)

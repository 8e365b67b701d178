"""The exported geometry in Embree: the very intersection code that the renderer uses."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import trimesh

from rna_render.embree import TriangleScene
from rna_render.surface import (
    geometric_normals,
    interpolate_normals,
    interpolate_positions,
    visible,
)
from rna_sdk.package import Mesh


@dataclass(frozen=True)
class SurfacePoints:
    """Where rays met the asset; every array has one row a ray, rows without a hit are zero."""

    hit: np.ndarray  # (n,) bool
    position: np.ndarray  # (n, 3) float32
    normal: np.ndarray  # (n, 3) float32, interpolated corner normals
    geometric_normal: np.ndarray  # (n, 3) float32
    uv: np.ndarray  # (n, 2) float32, zero where the mesh has none


class AssetScene:
    """Ray queries against one mesh."""

    def __init__(self, mesh: Mesh):
        self.mesh = mesh
        self._scene = TriangleScene([(mesh.positions, mesh.triangles)])
        area = trimesh.triangles.area(mesh.positions[mesh.triangles].astype(np.float64))
        self._area_cdf = np.cumsum(area) / area.sum()
        every = np.arange(len(mesh.triangles), dtype=np.int32)
        self._geometric = geometric_normals(mesh.positions, mesh.triangles, every)
        low, high = mesh.positions.min(axis=0), mesh.positions.max(axis=0)
        self.centre = ((low + high) / 2).astype(np.float32)
        self.radius = float(np.linalg.norm(mesh.positions - self.centre, axis=1).max())

    def hit_mask(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """Which rays hit, (n,) bool."""
        return self._scene.intersect(origins, directions).geometry >= 0

    def shade_points(self, origins: np.ndarray, directions: np.ndarray) -> SurfacePoints:
        """First hits of rays (n, 3), with everything that a sample records."""
        mesh, hits = self.mesh, self._scene.intersect(origins, directions)
        hit = hits.geometry >= 0
        triangle = np.where(hit, hits.triangle, 0)
        at = (mesh.triangles, triangle, hits.u, hits.v)
        mask = hit[:, None]
        uv = np.zeros((len(origins), 2), np.float32)
        if mesh.uvs is not None:
            corner = mesh.uvs[mesh.triangles[triangle]]
            weights = np.stack([1.0 - hits.u - hits.v, hits.u, hits.v], axis=1)
            uv = np.einsum("nc,nck->nk", weights, corner).astype(np.float32) * mask
        return SurfacePoints(
            hit,
            np.where(mask, interpolate_positions(mesh.positions, *at), 0.0).astype(np.float32),
            np.where(mask, interpolate_normals(mesh.normals, *at), 0.0).astype(np.float32),
            self._geometric[triangle] * mask,
            uv,
        )

    def sample_points(self, n: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """n points uniform by area and their geometric normals, (n, 3) float32 each."""
        triangle = np.minimum(
            np.searchsorted(self._area_cdf, rng.random(n)), len(self._area_cdf) - 1
        )
        root, v = np.sqrt(rng.random(n)), rng.random(n)
        weights = np.stack([1.0 - root, root * (1.0 - v), root * v], axis=1).astype(np.float32)
        corners = self.mesh.positions[self.mesh.triangles[triangle]]
        return np.einsum("nc,nck->nk", weights, corners), self._geometric[triangle]

    def free_distance(self, points: np.ndarray, normals: np.ndarray, wo: np.ndarray) -> np.ndarray:
        """How far a ray leaves points (n, 3) along wo before it meets the asset; inf: never."""
        lift = np.float32(1e-4 * self.radius)
        return self._scene.intersect(points + lift * normals, wo).t

    def visible(self, points: SurfacePoints, wi: np.ndarray) -> np.ndarray:
        """Whether wi (n, 3) is free of the asset itself at each point, (n,) bool."""
        return visible(self._scene, points.position, points.geometric_normal, wi)

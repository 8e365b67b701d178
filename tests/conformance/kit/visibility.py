"""The visibility rays of RNA-1.0, 7, in float64 against every triangle and every segment."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_sdk.package import Curves, Mesh
from tests.conformance.kit.blocks import dot, unit
from tests.render.round_cones import depths, entries

STEP, SMOOTH_BELOW = 2.0**-18, 0.1


@dataclass(frozen=True)
class MeshHits:
    """n points of a mesh and directions: triangle (n,), b1, b2 (n,) float32, wi (n, 3) float32."""

    triangle: np.ndarray
    b1: np.ndarray
    b2: np.ndarray
    wi: np.ndarray

    def records(self) -> bytes:
        """32 bytes each: u32 triangle, float32 b1, b2, wi[3], 8 zero bytes."""
        rows = np.zeros((len(self.triangle), 8), np.uint32)
        rows[:, 0] = self.triangle
        numbers = np.column_stack([self.b1, self.b2, self.wi]).astype(np.float32)
        rows[:, 1:6] = numbers.view(np.uint32)
        return rows.astype("<u4").tobytes()

    def take(self, rows: np.ndarray) -> MeshHits:
        return MeshHits(self.triangle[rows], self.b1[rows], self.b2[rows], self.wi[rows])

    def normals(self, mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
        """n and n_g, (n, 3) float64."""
        corners = mesh.triangles[self.triangle]
        shading = unit(self._at(mesh.normals[corners]))
        v = mesh.positions[corners].astype(np.float64)
        across = np.cross(v[:, 1] - v[:, 0], v[:, 2] - v[:, 0])
        size = np.linalg.norm(across, axis=1, keepdims=True)
        return shading, across / np.where(size > 0, size, 1)

    def visible(self, mesh: Mesh, moves: np.random.Generator | None = None) -> np.ndarray:
        """(n,) bool; moves: shifts the ray by a little more than float32 rounds off."""
        corners = mesh.triangles[self.triangle]
        v, n_v = (a[corners].astype(np.float64) for a in (mesh.positions, mesh.normals))
        x, wi, extent = self._at(v), self.wi.astype(np.float64), np.abs(mesh.positions).max()
        if moves is not None:
            x = x + moves.uniform(-1, 1, x.shape) * 2.0**-20 * extent
            wi = unit(wi + moves.uniform(-1, 1, wi.shape) * 3e-6)
        n, n_g = self.normals(mesh)
        plane = dot(n_g, wi)
        side = np.where(plane < 0, -1.0, 1.0)
        smooth = (dot(n, wi) > 0) & (dot(n, n_g) > 0) & (plane < SMOOTH_BELOW)
        height = np.maximum(0, np.sum((v - x[:, None]) * n_v, axis=2))
        s = np.where(smooth, 1 - np.maximum(0, plane) / SMOOTH_BELOW, 0.0)
        side = np.where(smooth, 1.0, side)
        lift = s[:, None] * self._at(height[..., None] * n_v)
        origin = x + lift + (side * STEP * extent)[:, None] * n_g
        return ~_meets(mesh, origin, wi)

    def _at(self, values: np.ndarray) -> np.ndarray:
        b1, b2 = self.b1.astype(np.float64), self.b2.astype(np.float64)
        weights = np.stack([1 - b1 - b2, b1, b2], axis=1)
        return np.sum(weights[..., None] * values, axis=1)


def _meets(mesh: Mesh, origin: np.ndarray, wi: np.ndarray) -> np.ndarray:
    """(n,) whether a ray meets any triangle, from either side. By signed volumes."""
    a, b, c = (mesh.positions[mesh.triangles[:, k]].astype(np.float64) for k in range(3))
    area = np.cross(b - a, c - a)
    o, d = origin[:, None], wi[:, None]
    facing = np.sum(area * d, axis=2)
    beside = [
        np.sum(np.cross(p - o, q - o) * d, axis=2) * np.sign(facing)
        for p, q in ((a, b), (b, c), (c, a))
    ]
    far = np.sum((a - o) * area, axis=2) * np.sign(facing)
    return ((facing != 0) & (np.min(beside, axis=0) >= 0) & (far >= 0)).any(axis=1)


@dataclass(frozen=True)
class FiberHits:
    """n points of strands and directions: segment (n,), x, wi (n, 3) float32."""

    segment: np.ndarray
    x: np.ndarray
    wi: np.ndarray

    def records(self) -> bytes:
        """32 bytes each: u32 segment, float32 position[3], wi[3], 4 zero bytes."""
        rows = np.zeros((len(self.segment), 8), np.uint32)
        rows[:, 0] = self.segment
        rows[:, 1:7] = np.column_stack([self.x, self.wi]).astype(np.float32).view(np.uint32)
        return rows.astype("<u4").tobytes()

    def take(self, rows: np.ndarray) -> FiberHits:
        return FiberHits(self.segment[rows], self.x[rows], self.wi[rows])

    def visible(self, curves: Curves, moves: np.random.Generator | None = None) -> np.ndarray:
        x, wi = self.x.astype(np.float64), self.wi.astype(np.float64)
        if moves is not None:
            x = x + moves.uniform(-1, 1, x.shape) * 3e-6
            wi = unit(wi + moves.uniform(-1, 1, wi.shape) * 3e-5)
        strand = strands(curves)
        t = entries(curves, x, wi)  # (n, m)
        t[strand == strand[self.segment][:, None]] = np.inf
        shadowed = np.zeros(len(x), bool)
        for row, segment in zip(*np.nonzero(np.isfinite(t)), strict=True):
            at = depths(curves, (x[row] + t[row, segment] * wi[row])[None])[0]
            near = [k for k in (segment - 1, segment + 1) if 0 <= k < len(strand)]
            inside = any(at[k] > 0 for k in near if strand[k] == strand[segment])
            shadowed[row] |= not inside
        return ~shadowed


def strands(curves: Curves) -> np.ndarray:
    """(m,) the strand of each segment."""
    counts = np.diff(curves.offsets.astype(int)) - 1
    return np.repeat(np.arange(len(counts)), counts)


def stable(hits: MeshHits | FiberHits, geometry: Mesh | Curves, times: int = 12) -> np.ndarray:
    """(n,) the rows whose pick no small move of the ray changes."""
    exact = hits.visible(geometry)  # type: ignore[arg-type]
    moves = np.random.default_rng(0)
    same = [hits.visible(geometry, moves) == exact for _ in range(times)]  # type: ignore[arg-type]
    return np.flatnonzero(np.all(same, axis=0))

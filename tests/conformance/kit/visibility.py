"""The visibility rays of spec/RNA.md, 7.1, in float64 against every triangle and every segment."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rna_sdk.package import Curves, Mesh, Transmittance
from tests.conformance.kit.blocks import dot, unit
from tests.conformance.kit.passing import tau
from tests.render.round_cones import depths, entries

STEP, SMOOTH_BELOW = 2.0**-18, 0.1
LARGEST_CHANGE = 2e-4
"""Largest change of a visibility by moves of the ray as large as rounding."""


@dataclass(frozen=True)
class Body:
    """The geometry of a part, and what it lets through."""

    geometry: Mesh | Curves
    records: Sequence[Transmittance] = ()


@dataclass(frozen=True)
class Rays:
    """n rays, float64; strand: (n,) the one of part `part` that each starts on, if it is fibers."""

    origin: np.ndarray
    wi: np.ndarray
    part: int
    strand: np.ndarray | None = None


def visibility(bodies: Sequence[Body], rays: Rays) -> np.ndarray:
    """(n, 3) float64: what the parts leave of the light along each ray."""
    v = np.ones((len(rays.wi), 3))
    for part, body in enumerate(bodies):
        if isinstance(body.geometry, Mesh):
            v *= _through_triangles(body.geometry, body.records, rays)
        else:
            start_strand = rays.strand if part == rays.part else None
            v *= ~_enters_strands(body.geometry, rays, start_strand)[:, None]
    return v


def extent(bodies: Sequence[Body]) -> float:
    """The largest absolute coordinate; of curves, with the point's radius."""
    return float(
        max(
            np.abs(g.positions).max()
            if isinstance(g := body.geometry, Mesh)
            else (np.abs(g.points).max(axis=1) + g.radii).max()
            for body in bodies
        )
    )


@dataclass(frozen=True)
class MeshHits:
    """n points of a mesh and directions: triangle (n,), b1, b2 (n,) float32, wi (n, 3) float32."""

    triangle: np.ndarray
    b1: np.ndarray
    b2: np.ndarray
    wi: np.ndarray

    def records(self, part: int) -> bytes:
        """32 bytes each: u32 triangle, float32 b1, b2, wi[3], 4 zero bytes, u32 part."""
        rows = np.zeros((len(self.triangle), 8), np.uint32)
        rows[:, 0], rows[:, 7] = self.triangle, part
        numbers = np.column_stack([self.b1, self.b2, self.wi]).astype(np.float32)
        rows[:, 1:6] = numbers.view(np.uint32)
        return rows.astype("<u4").tobytes()

    def take(self, rows: np.ndarray) -> "MeshHits":
        return MeshHits(self.triangle[rows], self.b1[rows], self.b2[rows], self.wi[rows])

    def normals(self, mesh: Mesh) -> tuple[np.ndarray, np.ndarray]:
        """n and n_g, (n, 3) float64."""
        corners = mesh.triangles[self.triangle]
        shading = unit(self._at(mesh.normals[corners]))
        v = mesh.positions[corners].astype(np.float64)
        across = np.cross(v[:, 1] - v[:, 0], v[:, 2] - v[:, 0])
        size = np.linalg.norm(across, axis=1, keepdims=True)
        return shading, across / np.where(size > 0, size, 1)

    def x(self, mesh: Mesh) -> np.ndarray:
        """(n, 3) float64."""
        return self._at(mesh.positions[mesh.triangles[self.triangle]].astype(np.float64))

    def rays(
        self, bodies: Sequence[Body], part: int, moves: np.random.Generator | None = None
    ) -> Rays:
        """moves: shifts each ray by a little more than float32 rounds off."""
        mesh, size = bodies[part].geometry, extent(bodies)
        corners = mesh.triangles[self.triangle]
        v, n_v = (a[corners].astype(np.float64) for a in (mesh.positions, mesh.normals))
        x, wi = self._at(v), self.wi.astype(np.float64)
        if moves is not None:
            x = x + moves.uniform(-1, 1, x.shape) * 2.0**-20 * size
            wi = unit(wi + moves.uniform(-1, 1, wi.shape) * 3e-6)
        n, n_g = self.normals(mesh)
        plane = dot(n_g, wi)
        wound_right = dot(n, n_g) > 0
        side = np.where(np.where(wound_right, dot(n, wi), plane) < 0, -1.0, 1.0)
        smooth = wound_right & (dot(n, wi) > 0) & (plane < SMOOTH_BELOW)
        height = np.maximum(0, np.sum((v - x[:, None]) * n_v, axis=2))
        s = np.where(smooth, 1 - np.maximum(0, plane) / SMOOTH_BELOW, 0.0)
        lift = s[:, None] * self._at(height[..., None] * n_v)
        return Rays(x + lift + (side * STEP * size)[:, None] * n_g, wi, part)

    def _at(self, values: np.ndarray) -> np.ndarray:
        b1, b2 = self.b1.astype(np.float64), self.b2.astype(np.float64)
        weights = np.stack([1 - b1 - b2, b1, b2], axis=1)
        return np.sum(weights[..., None] * values, axis=1)


def _through_triangles(mesh: Mesh, records: Sequence[Transmittance], rays: Rays) -> np.ndarray:
    """(n, 3) product of what the triangles that each ray meets let through. By signed volumes."""
    a, b, c = (mesh.positions[mesh.triangles[:, k]].astype(np.float64) for k in range(3))
    area = np.cross(b - a, c - a)
    o, d = rays.origin[:, None], rays.wi[:, None]
    facing = np.sum(area * d, axis=2)
    beside = np.array(
        [
            np.sum(np.cross(p - o, q - o) * d, axis=2) * np.sign(facing)
            for p, q in ((b, c), (c, a), (a, b))
        ]
    )
    far = np.sum((a - o) * area, axis=2) * np.sign(facing)
    met = (facing != 0) & (beside.min(axis=0) >= 0) & (far >= 0)
    passed = np.zeros((*met.shape, 3))
    row, triangle = np.nonzero(met)
    weights = beside[:, row, triangle] / beside[:, row, triangle].sum(axis=0)
    passed[row, triangle] = tau(mesh, records, triangle, weights.T, rays.wi[row])
    return np.where(met[..., None], passed, 1.0).prod(axis=1)


@dataclass(frozen=True)
class FiberHits:
    """n points of strands and directions: segment (n,), x, wi (n, 3) float32."""

    segment: np.ndarray
    position: np.ndarray
    wi: np.ndarray

    def records(self, part: int) -> bytes:
        """32 bytes each: u32 segment, float32 position[3], wi[3], u32 part."""
        rows = np.zeros((len(self.segment), 8), np.uint32)
        rows[:, 0], rows[:, 7] = self.segment, part
        numbers = np.column_stack([self.position, self.wi]).astype(np.float32)
        rows[:, 1:7] = numbers.view(np.uint32)
        return rows.astype("<u4").tobytes()

    def take(self, rows: np.ndarray) -> "FiberHits":
        return FiberHits(self.segment[rows], self.position[rows], self.wi[rows])

    def x(self, curves: Curves) -> np.ndarray:
        """(n, 3) float64."""
        return self.position.astype(np.float64)

    def rays(
        self, bodies: Sequence[Body], part: int, moves: np.random.Generator | None = None
    ) -> Rays:
        """moves: shifts each ray by more than float32 rounds off."""
        x, wi = self.position.astype(np.float64), self.wi.astype(np.float64)
        if moves is not None:
            x = x + moves.uniform(-1, 1, x.shape) * 3e-6
            wi = unit(wi + moves.uniform(-1, 1, wi.shape) * 3e-5)
        return Rays(x, wi, part, strands(bodies[part].geometry)[self.segment])


def _enters_strands(curves: Curves, rays: Rays, start_strand: np.ndarray | None) -> np.ndarray:
    """(n,) whether each ray enters a strand from outside; start_strand: the one that it passes."""
    strand = strands(curves)
    t = entries(curves, rays.origin, rays.wi)  # (n, m)
    if start_strand is not None:
        t[strand == start_strand[:, None]] = np.inf
    row, segment = np.nonzero(np.isfinite(t))
    at = depths(curves, rays.origin[row] + t[row, segment][:, None] * rays.wi[row])
    inside_others = np.zeros(len(row), bool)
    for beside in (segment - 1, segment + 1):
        near = np.clip(beside, 0, len(strand) - 1)
        of_strand = (near == beside) & (strand[near] == strand[segment])
        inside_others |= of_strand & (at[np.arange(len(row)), near] > 0)
    result = np.zeros(len(t), bool)
    result[row[~inside_others]] = True
    return result


def strands(curves: Curves) -> np.ndarray:
    """(m,) the strand of each segment."""
    counts = np.diff(curves.offsets.astype(int)) - 1
    return np.repeat(np.arange(len(counts)), counts)


def stable(
    hits: MeshHits | FiberHits, bodies: Sequence[Body], part: int, times: int = 12
) -> np.ndarray:
    """(n,) the rows whose visibility no small move of the ray changes."""
    exact = visibility(bodies, hits.rays(bodies, part))
    moves = np.random.default_rng(0)
    change = np.zeros(len(exact))
    for _ in range(times):
        moved = visibility(bodies, hits.rays(bodies, part, moves))
        change = np.maximum(change, np.abs(moved - exact).max(axis=1))
    return np.flatnonzero(change < LARGEST_CHANGE)

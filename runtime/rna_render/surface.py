"""Points on a mesh: interpolation at a hit, and rays that leave the surface.

The hit point comes from the barycentrics, in float64 and rounded once, so its error is half a
unit in the last place of its coordinates, however far the ray came from.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numba import prange

from rna_render.rays import check_numbers, vectors
from rna_sdk.compiled import compiled
from rna_sdk.errors import QueryError

# An origin moves off the surface by this part of the largest coordinate in its space: some thirty
# times the rounding of the point and of Embree's robust test, which are a few 2^-24 each.
OFFSET = 2.0**-18

# Cosine of a direction to the triangle's normal below which rays begin to start from the smooth
# surface; below 0 they do. Cycles' "shadow terminator geometry offset", at its default.
SMOOTH_BELOW = 0.1


class Mesh(Protocol):
    """What is read of a mesh; arrays as in rna_sdk.package.Mesh."""

    positions: np.ndarray
    normals: np.ndarray
    triangles: np.ndarray


def interpolate_positions(
    positions: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
) -> np.ndarray:
    """The points at barycentrics (u, v) of the given triangles: (n, 3) float32.

    positions: (v, 3) float32. triangles: (t, 3) uint32. triangle: (n,) int32, each within
    [0, t). u, v: (n,) float32. Raises QueryError for other shapes, or a triangle out of range.
    """
    return _at_hits(positions, triangles, triangle, u, v, normalise=False)


def interpolate_normals(
    normals: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
) -> np.ndarray:
    """Unit shading normals, interpolated from the corners' (v, 3) float32: (n, 3) float32.

    Other arguments and errors are those of `interpolate_positions`. They are not turned towards
    the viewer. Corner normals that cancel give (0, 0, 0).
    """
    return _at_hits(normals, triangles, triangle, u, v, normalise=True)


def geometric_normals(
    positions: np.ndarray, triangles: np.ndarray, triangle: np.ndarray
) -> np.ndarray:
    """Unit normals of the flat triangles, counter-clockwise side: (n, 3) float32.

    Arguments and errors are those of `interpolate_positions`; a triangle without area gives
    (0, 0, 0).
    """
    check_numbers("triangle", triangle, len(triangles))
    result = np.empty((len(triangle), 3), np.float32)
    _geometric_normals(positions, triangles, triangle, result)
    return result


def lifts(
    positions: np.ndarray,
    normals: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
) -> np.ndarray:
    """From points at (u, v) onto the smooth surface that the triangles stand for: (n, 3) float32.

    The mean, by barycentrics, of the ways onto the tangent planes of the corners that the point is
    below; zero on flat shaded triangles. Hanika, "Hacking the Shadow Terminator" (Ray Tracing
    Gems II, chapter 4). normals: (v, 3) float32, unit. The other arguments and errors are those of
    `interpolate_positions`.
    """
    _check_hits(triangles, triangle, u, v)
    result = np.empty((len(triangle), 3), np.float32)
    _lifts(positions, normals, triangles, triangle, u, v, result)
    return result


@dataclass(frozen=True, slots=True)
class SurfacePoints:
    """Points of a mesh, (m, 3) float32 each, as the functions above give them.

    x: positions. n: shading normals. ng: geometric normals. lift: from x onto the smooth surface.
    """

    x: np.ndarray
    n: np.ndarray
    ng: np.ndarray
    lift: np.ndarray

    @classmethod
    def of(cls, mesh: Mesh, triangle: np.ndarray, u: np.ndarray, v: np.ndarray) -> SurfacePoints:
        """The points at barycentrics (u, v) of the given triangles."""
        at = mesh.triangles, triangle, u, v
        return cls(
            interpolate_positions(mesh.positions, *at),
            interpolate_normals(mesh.normals, *at),
            geometric_normals(mesh.positions, mesh.triangles, triangle),
            lifts(mesh.positions, mesh.normals, *at),
        )

    def __len__(self) -> int:
        return len(self.x)

    def checked(self) -> SurfacePoints:
        """The same, contiguous. Raises QueryError for another dtype or shape."""
        count = len(self)
        return SurfacePoints(
            *(vectors(name, getattr(self, name), count) for name in SurfacePoints.__slots__)
        )

    def take(self, row: np.ndarray) -> SurfacePoints:
        """The given rows."""
        return SurfacePoints(*(a.take(row, axis=0) for a in (self.x, self.n, self.ng, self.lift)))


def leaving_origins(points: SurfacePoints, directions: np.ndarray, extent: float) -> np.ndarray:
    """Origins of rays that leave surface points and must not hit the surface there: (m, 3) float32.

    Each point moves along its geometric normal, to the side its direction is on (the normal's
    own side if it is on neither), by OFFSET * extent. Waechter and Binder, "A Fast and Robust
    Method for Avoiding Self-Intersection" (Ray Tracing Gems, chapter 6), scale the step by the
    point's own coordinates; that fails near the origin of large triangles, whose corners bring
    the rounding errors. So `extent` is the largest absolute coordinate of the whole scene.

    A direction above the smooth surface, but near the triangle's plane or below it, starts from
    the smooth surface: the facets would block light that is seen in Cycles, which does the same.

    directions: (m, 3) float32, unit.
    """
    result = np.empty_like(directions)
    at = points.x, points.n, points.ng, points.lift
    _leave(*at, directions, OFFSET * extent, result)
    return result


def _at_hits(values, triangles, triangle, u, v, normalise):
    _check_hits(triangles, triangle, u, v)
    result = np.empty((len(triangle), 3), np.float32)
    _interpolate(values, triangles, triangle, u, v, normalise, result)
    return result


def _check_hits(triangles, triangle, u, v):
    check_numbers("triangle", triangle, len(triangles))
    if not len(triangle) == len(u) == len(v):
        raise QueryError(f"{len(triangle)} triangles, but {len(u)} u and {len(v)} v")


@compiled(parallel=True, fastmath=())
def _interpolate(values, triangles, triangle, u, v, normalise, result):
    for i in prange(len(triangle)):
        a, b, c = triangles[triangle[i]]
        fu, fv = np.float64(u[i]), np.float64(v[i])
        x = (1.0 - fu - fv) * values[a, 0] + fu * values[b, 0] + fv * values[c, 0]
        y = (1.0 - fu - fv) * values[a, 1] + fu * values[b, 1] + fv * values[c, 1]
        z = (1.0 - fu - fv) * values[a, 2] + fu * values[b, 2] + fv * values[c, 2]
        length = np.sqrt(x * x + y * y + z * z) if normalise else 1.0
        scale = 1.0 / length if length > 0.0 else 0.0
        result[i, 0], result[i, 1], result[i, 2] = x * scale, y * scale, z * scale


@compiled(parallel=True, fastmath=())
def _geometric_normals(positions, triangles, triangle, result):
    for i in prange(len(triangle)):
        a, b, c = triangles[triangle[i]]
        e1x, e2x = np.float64(positions[b, 0]) - positions[a, 0], positions[c, 0] - positions[a, 0]
        e1y, e2y = np.float64(positions[b, 1]) - positions[a, 1], positions[c, 1] - positions[a, 1]
        e1z, e2z = np.float64(positions[b, 2]) - positions[a, 2], positions[c, 2] - positions[a, 2]
        x = e1y * e2z - e1z * e2y
        y = e1z * e2x - e1x * e2z
        z = e1x * e2y - e1y * e2x
        length = np.sqrt(x * x + y * y + z * z)
        scale = 1.0 / length if length > 0.0 else 0.0
        result[i, 0], result[i, 1], result[i, 2] = x * scale, y * scale, z * scale


@compiled(parallel=True, fastmath=())
def _lifts(positions, normals, triangles, triangle, u, v, result):
    for i in prange(len(triangle)):
        corners = triangles[triangle[i]]
        fu, fv = np.float64(u[i]), np.float64(v[i])
        weights = (1.0 - fu - fv, fu, fv)
        result[i] = 0.0
        for k in range(3):
            corner, height = corners[k], 0.0
            for axis in range(3):
                x = 0.0
                for j in range(3):
                    x += weights[j] * positions[corners[j], axis]
                height += (x - positions[corner, axis]) * normals[corner, axis]
            for axis in range(3):
                result[i, axis] -= weights[k] * min(height, 0.0) * normals[corner, axis]


@compiled(parallel=True, fastmath=())
def _leave(x, n, ng, lift, directions, step, result):
    for i in prange(len(x)):
        above, above_plane, alike = np.float64(0.0), np.float64(0.0), np.float64(0.0)
        for axis in range(3):
            above += np.float64(n[i, axis]) * directions[i, axis]
            above_plane += np.float64(ng[i, axis]) * directions[i, axis]
            alike += np.float64(n[i, axis]) * ng[i, axis]
        smooth, signed = 0.0, -step if above_plane < 0.0 else step
        if above > 0.0 and alike > 0.0 and above_plane < SMOOTH_BELOW:
            smooth, signed = 1.0 - max(above_plane, 0.0) / SMOOTH_BELOW, step
        for axis in range(3):
            result[i, axis] = x[i, axis] + smooth * lift[i, axis] + signed * ng[i, axis]

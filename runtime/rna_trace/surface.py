"""Points on a mesh: interpolation at a hit, and rays that leave the surface.

The hit point comes from the barycentrics, in float64 and rounded once, so its error is half a
unit in the last place of its coordinates, however far the ray came from.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from rna_sdk.arrays import check_numbers, vectors
from rna_sdk.errors import QueryError
from rna_sdk.machine.compiled import compiled
from rna_trace.normal_maps import NormalMaps
from rna_trace.vectors import Vector, cross, dot, unit, vector_at

# Within an asset an origin moves off the surface by this part of its largest coordinate: some
# thirty times the rounding of the point and of Embree's robust test, which are a few 2^-24 each.
# spec/RNA.md, 7.1.
OFFSET = 2.0**-18

# Cosine of a direction to the triangle's normal below which rays begin to start from the smooth
# surface; below 0 they do. Cycles' "shadow terminator geometry offset", at its default.
SMOOTH_BELOW = 0.1


class Mesh(Protocol):
    """The members of a mesh that are read; arrays as in rna_sdk.package.Mesh."""

    @property
    def positions(self) -> np.ndarray: ...

    @property
    def normals(self) -> np.ndarray: ...

    @property
    def triangles(self) -> np.ndarray: ...


def interpolate(
    values: np.ndarray, triangles: np.ndarray, triangle: np.ndarray, u: np.ndarray, v: np.ndarray
) -> np.ndarray:
    """An attribute of vertices at barycentrics (u, v) of the given triangles: (n, k) float32.

    values: (v, k) float32. triangles: (t, 3) uint32. triangle: (n,) int32, each within
    [0, t). u, v: (n,) float32 or float64. Raises QueryError for other shapes, or a triangle out of
    range.
    """
    return _at_hits(_interpolate, values, triangles, triangle, u, v)


def interpolate_normals(
    normals: np.ndarray, triangles: np.ndarray, triangle: np.ndarray, u: np.ndarray, v: np.ndarray
) -> np.ndarray:
    """Unit shading normals, interpolated from the corners' (v, 3) float32: (n, 3) float32.

    Other arguments and errors are those of `interpolate`. They are not turned towards
    the viewer. Corner normals that cancel give (0, 0, 0).
    """
    return _at_hits(_interpolate_normals, normals, triangles, triangle, u, v)


def geometric_normals(
    positions: np.ndarray, triangles: np.ndarray, triangle: np.ndarray
) -> np.ndarray:
    """Unit normals of the flat triangles, counter-clockwise side: (n, 3) float32.

    Arguments and errors are those of `interpolate`; a triangle without area gives
    (0, 0, 0).
    """
    check_numbers("triangle", triangle, len(triangles))
    result = np.empty((len(triangle), 3), np.float32)
    _geometric_normals(positions, triangles, triangle, result)
    return result


@dataclass(frozen=True, slots=True)
class SurfacePoints:
    """Points of a mesh, (m, 3) float32 each, as the functions above give them.

    x: positions. n: interpolated normals. ng: geometric normals. lift: from x onto the smooth
    surface. mapped: n with the relief of normal maps, where the mesh has any.
    """

    x: np.ndarray
    n: np.ndarray
    ng: np.ndarray
    lift: np.ndarray
    mapped: np.ndarray

    @classmethod
    def of(
        cls,
        mesh: Mesh,
        triangle: np.ndarray,
        u: np.ndarray,
        v: np.ndarray,
        maps: NormalMaps | None = None,
    ) -> SurfacePoints:
        """The points at barycentrics (u, v) of the given triangles."""
        _check_hits(triangles=mesh.triangles, triangle=triangle, u=u, v=v)
        x, n, ng, lift = (np.empty((len(triangle), 3), np.float32) for _ in range(4))
        _points_at_hits(
            mesh.positions, mesh.normals, mesh.triangles, triangle, u, v, x, n, ng, lift
        )
        return cls(x, n, ng, lift, n if maps is None else maps.at(n, triangle, u, v))

    def __len__(self) -> int:
        return len(self.x)

    def checked(self) -> SurfacePoints:
        """The array, contiguous. Raises QueryError for another dtype or shape."""
        count = len(self)
        return SurfacePoints(
            *(vectors(name, getattr(self, name), count) for name in SurfacePoints.__slots__)
        )

    def take(self, row: np.ndarray) -> SurfacePoints:
        """The given rows."""
        return SurfacePoints(
            *(getattr(self, name).take(row, axis=0) for name in SurfacePoints.__slots__)
        )


def leaving_origins(
    points: SurfacePoints, directions: np.ndarray, extent: float, row: np.ndarray | None = None
) -> np.ndarray:
    """Origins of rays that leave surface points and must not hit the surface there: (k, 3) float32.

    Each point moves along its geometric normal, to the side of the smooth surface that its
    direction is on (the normal's own side if it is on neither), by OFFSET * extent. Triangles wound
    against their normals have the side of the geometric normal. Waechter and Binder, "A Fast and
    Robust Method for Avoiding Self-Intersection" (Ray Tracing Gems, chapter 6), scale the step by
    the point's own coordinates; that fails near the origin of large triangles, whose corners bring
    the rounding errors. So `extent` is the largest absolute coordinate of the whole scene.

    A direction above the smooth surface, but near the triangle's plane or below it, starts from
    the smooth surface: the facets would block light that is seen in Cycles, which does the same.
    One below the smooth surface, but above the triangle's plane, starts behind the triangle and
    meets it: the facets would show as teeth of light beyond the terminator.

    directions: (k, 3) float32, unit. row: (k,) which points they leave; None for all, in order.
    """
    result = np.empty_like(directions)
    row = np.arange(len(points)) if row is None else row
    _leave(points.x, points.n, points.ng, points.lift, row, directions, OFFSET * extent, result)
    return result


def _at_hits(
    kernel: Callable[..., None],
    values: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
) -> np.ndarray:
    _check_hits(triangles, triangle, u, v)
    result = np.empty((len(triangle), values.shape[1]), np.float32)
    u, v = np.asarray(u, np.float64), np.asarray(v, np.float64)
    kernel(values, triangles, triangle, u, v, result)
    return result


def _check_hits(triangles: np.ndarray, triangle: np.ndarray, u: np.ndarray, v: np.ndarray) -> None:
    check_numbers("triangle", triangle, len(triangles))
    if not len(triangle) == len(u) == len(v):
        raise QueryError(f"{len(triangle)} triangles, but {len(u)} u and {len(v)} v")


@compiled(fastmath=())
def mixed_at(values: np.ndarray, corners: np.ndarray, u: float, v: float) -> Vector:
    """The corners' rows of (v, 3) float32 at barycentrics (u, v): three float64."""
    x, y = component_at(values, corners, 0, u, v), component_at(values, corners, 1, u, v)
    return x, y, component_at(values, corners, 2, u, v)


@compiled(inline=True, fastmath=())
def component_at(values: np.ndarray, corners: np.ndarray, k: int, u: float, v: float) -> float:
    """Column k of the corners' rows at barycentrics (u, v): float64."""
    a, b, c = values[corners[0], k], values[corners[1], k], values[corners[2], k]
    return float((1.0 - u - v) * a + u * b + v * c)


@compiled(fastmath=())
def lift_at(
    positions: np.ndarray, normals: np.ndarray, corners: np.ndarray, x: tuple[float, float, Vector]
) -> Vector:
    """Offset from a point at (u, v) to the smooth surface that the mesh stands for: three float64.

    x: u, v, and the point. The mean, by barycentrics, of the ways onto the tangent planes of the
    corners that the point is below; zero on flat shaded triangles. Hanika, "Hacking the Shadow
    Terminator" (Ray Tracing Gems II, chapter 4).
    """
    u, v, point = x
    weights = (1.0 - u - v, u, v)
    dx, dy, dz = 0.0, 0.0, 0.0
    for k in range(3):
        p, n = vector_at(positions, corners[k]), vector_at(normals, corners[k])
        height = dot((point[0] - p[0], point[1] - p[1], point[2] - p[2]), n)
        step = weights[k] * min(height, 0.0)
        dx, dy, dz = dx - step * n[0], dy - step * n[1], dz - step * n[2]
    return dx, dy, dz


@compiled(fastmath=())
def smooth_share(n: Vector, ng: Vector, d: Vector) -> tuple[float, bool]:
    """Fraction of the lift applied to a ray along d, and whether its step is along ng: see
    `leaving_origins`."""
    above_plane = dot(ng, d)
    if not dot(n, ng) > 0.0:
        return 0.0, above_plane >= 0.0
    above = dot(n, d)
    if above > 0.0 and above_plane < SMOOTH_BELOW:
        return 1.0 - max(above_plane, 0.0) / SMOOTH_BELOW, True
    return 0.0, above >= 0.0


@compiled(rows="triangle u v result", fastmath=())
def _interpolate(
    values: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    result: np.ndarray,
) -> None:
    for i in range(len(triangle)):
        for k in range(values.shape[1]):
            result[i, k] = component_at(values, triangles[triangle[i]], k, u[i], v[i])


@compiled(rows="triangle u v result", fastmath=())
def _interpolate_normals(
    normals: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    result: np.ndarray,
) -> None:
    for i in range(len(triangle)):
        normal = unit(mixed_at(normals, triangles[triangle[i]], u[i], v[i]))
        result[i, 0], result[i, 1], result[i, 2] = normal


@compiled(fastmath=())
def _geometric_normal(positions: np.ndarray, corners: np.ndarray) -> Vector:
    p, q = vector_at(positions, corners[0]), vector_at(positions, corners[1])
    r = vector_at(positions, corners[2])
    e1, e2 = (q[0] - p[0], q[1] - p[1], q[2] - p[2]), (r[0] - p[0], r[1] - p[1], r[2] - p[2])
    return unit(cross(e1, e2))


@compiled(rows="triangle result", fastmath=())
def _geometric_normals(
    positions: np.ndarray, triangles: np.ndarray, triangle: np.ndarray, result: np.ndarray
) -> None:
    for i in range(len(triangle)):
        normal = _geometric_normal(positions, triangles[triangle[i]])
        result[i, 0], result[i, 1], result[i, 2] = normal


@compiled(rows="triangle u v x n ng lift", fastmath=())
def _points_at_hits(
    positions: np.ndarray,
    normals: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    x: np.ndarray,
    n: np.ndarray,
    ng: np.ndarray,
    lift: np.ndarray,
) -> None:
    """Results of the functions above, in one pass over the hits."""
    for i in range(len(triangle)):
        corners = triangles[triangle[i]]
        fu, fv = np.float64(u[i]), np.float64(v[i])
        at = mixed_at(positions, corners, fu, fv)
        x[i, 0], x[i, 1], x[i, 2] = at
        n[i, 0], n[i, 1], n[i, 2] = unit(mixed_at(normals, corners, fu, fv))
        ng[i, 0], ng[i, 1], ng[i, 2] = _geometric_normal(positions, corners)
        lift[i, 0], lift[i, 1], lift[i, 2] = lift_at(positions, normals, corners, (fu, fv, at))


@compiled(rows="row directions result", fastmath=())
def _leave(
    x: np.ndarray,
    n: np.ndarray,
    ng: np.ndarray,
    lift: np.ndarray,
    row: np.ndarray,
    directions: np.ndarray,
    step: float,
    result: np.ndarray,
) -> None:
    for i in range(len(row)):
        at = row[i]
        g = vector_at(ng, at)
        smooth, along = smooth_share(vector_at(n, at), g, vector_at(directions, i))
        signed = step if along else -step
        for axis in range(3):
            result[i, axis] = x[at, axis] + smooth * lift[at, axis] + signed * g[axis]

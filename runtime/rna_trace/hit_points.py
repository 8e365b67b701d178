"""Points of triangles that rays have hit, and how far off them rays start.

Embree finds hits in float32, with barycentrics that are right to 2^-24 of the triangle: millimetres
on a floor of 40 km. So the ray is cut with the triangle's plane once more, in float64, and the
point is rounded once, in the world.

A ray that leaves the point must not meet the triangle again, where Embree rounds once more. An
origin moves off the triangle by what this can come to at that point of that triangle, so nothing
elsewhere in the scene counts. The step of an origin was 2^-18 of the largest coordinate of its
instance, and far geometry then took the shadows of what is near. Waechter and Binder, "A Fast and
Robust Method for Avoiding Self-Intersection" (Ray Tracing Gems, chapter 6), scale it by the point's
own coordinates, which fails near the origin of large triangles; Pharr, Jakob and Humphreys,
Physically Based Rendering (section 6.8), bound the error of the point.
"""

from typing import NamedTuple

import numpy as np

from rna_sdk.machine.compiled import compiled
from rna_trace.vectors import Vector, cross, dot, minus, plus, unit, vector_at

# Rounding errors of 2^-24 that a step makes up for, in units of the two sizes below. Of 0.8 million
# rays off random triangles, of 1 mm to 10,000 km, level, tilted and slivers, placed anywhere, none
# met its triangle again from 6 on.
ROUNDING = 16.0 * 2.0**-24

# What is exact still has a step, this share of another one: a ray that starts in a plane meets it.
_LEAST = 2.0**-24

# A point may lie so far beyond its triangle's edges, in barycentrics, which are right to some 2^-24
# where rays decide between the two triangles of a floor.
_BEYOND = 2.0**-20


class Frames(NamedTuple):
    """Where k instances stand: x_world = scale rotation x + place, float64.

    rotations: (k, 3, 3). scales: (k,). places: (k, 3).
    """

    rotations: np.ndarray
    scales: np.ndarray
    places: np.ndarray


class Lines(NamedTuple):
    """Rays that have hit instances: origins and directions, (m, 3) float32 each, world space.

    instance: (m,) int32, rows of `frames`.
    """

    origins: np.ndarray
    directions: np.ndarray
    instance: np.ndarray
    frames: Frames

    def rows(self, row: slice | np.ndarray) -> "Lines":
        """The given rays."""
        return Lines(self.origins[row], self.directions[row], self.instance[row], self.frames)


class HitPoints(NamedTuple):
    """Points of triangles that m rays have hit.

    x, x_world: (m, 3) float32, in object space and in the world. u, v: (m,) float64, barycentrics.
    step: (m,) float32, how far along the triangle's normal rays from here start, world units.
    """

    x: np.ndarray
    x_world: np.ndarray
    u: np.ndarray
    v: np.ndarray
    step: np.ndarray


def hit_points(
    positions: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    lines: Lines,
) -> HitPoints:
    """Where the lines meet the planes of the triangles that they have hit, no more than a rounding
    error beyond these.

    positions: (v, 3) float32. triangles: (t, 3) uint32. triangle: (m,) int32, each within [0, t).
    u, v: (m,) float32, barycentrics as Embree has them, for a line along the plane.
    """
    m = len(triangle)
    x, x_world = np.empty((m, 3), np.float32), np.empty((m, 3), np.float32)
    result = HitPoints(x, x_world, np.empty(m), np.empty(m), np.empty(m, np.float32))
    origins, directions, instance, frames = lines
    _meet(positions, triangles, triangle, u, v, origins, directions, instance, *frames, *result)
    return result


def stepped(
    x: np.ndarray,
    normals: np.ndarray,
    step: np.ndarray,
    directions: np.ndarray,
    row: np.ndarray | None = None,
) -> np.ndarray:
    """Origins of rays off surfaces, on the side of their directions: (k, 3) float32.

    x, normals: (m, 3) float32. step: (m,) float32. directions: (k, 3) float32. row: (k,) which
    points they leave; None for all, in order.
    """
    result = np.empty_like(directions)
    _step_off(x, normals, step, np.arange(len(x)) if row is None else row, directions, result)
    return result


@compiled(rows="triangle u v origins directions instance x_object x_world us vs step", fastmath=())
def _meet(
    positions: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    origins: np.ndarray,
    directions: np.ndarray,
    instance: np.ndarray,
    rotations: np.ndarray,
    scales: np.ndarray,
    places: np.ndarray,
    x_object: np.ndarray,
    x_world: np.ndarray,
    us: np.ndarray,
    vs: np.ndarray,
    step: np.ndarray,
) -> None:
    for i in range(len(triangle)):
        k = instance[i]
        rotation, scale, place = rotations[k], scales[k], vector_at(places, k)
        corners = triangles[triangle[i]]
        p = vector_at(positions, corners[0])
        e1 = minus(vector_at(positions, corners[1]), p)
        e2 = minus(vector_at(positions, corners[2]), p)
        way = minus(_turned_back(rotation, minus(vector_at(origins, i), place), scale), p)
        d = _turned_back(rotation, vector_at(directions, i), 1.0)
        b1, b2 = _barycentrics(e1, e2, way, d, np.float64(u[i]), np.float64(v[i]))
        x = plus(plus(p, b1, e1), b2, e2)
        at = _placed(rotation, scale, place, x)
        us[i], vs[i] = b1, b2
        rounded = scale * _uncertain(e1, e2) + _reach(rotation, place, at, unit(cross(e1, e2)))
        step[i] = ROUNDING * rounded
        for axis in range(3):
            x_object[i, axis], x_world[i, axis] = x[axis], at[axis]


@compiled(fastmath=())
def _barycentrics(
    e1: Vector, e2: Vector, way: Vector, d: Vector, u: float, v: float
) -> tuple[float, float]:
    """Where way + t d meets the plane of the edges, moved to the triangle; else u and v."""
    n = cross(e1, e2)
    along = dot(n, d)
    if along != 0.0:
        at = plus(way, -dot(n, way) / along, d)
        area = dot(n, n)
        u, v = dot(cross(at, e2), n) / area, dot(cross(e1, at), n) / area
    u = min(max(u, -_BEYOND), 1.0 + _BEYOND)
    return u, min(max(v, -_BEYOND), 1.0 - u + _BEYOND)


@compiled(fastmath=())
def _uncertain(e1: Vector, e2: Vector) -> float:
    """By how many roundings rays miss the plane of a triangle of these edges, whatever its place.

    Their distance is a corner's, which reaches as far as the triangle, along its normal, each
    component of which is a difference of products of edges: the volume of the triangle's box over
    twice its area. 0 for a triangle across an axis, about its size for another, more for a sliver.
    """
    volume, longest = 1.0, 0.0
    for axis in range(3):
        low, high = min(e1[axis], e2[axis], 0.0), max(e1[axis], e2[axis], 0.0)
        volume *= high - low
        longest = max(longest, high - low)
    n = cross(e1, e2)
    area = np.sqrt(dot(n, n))
    return _LEAST * longest + (volume / area if area > 0.0 else 0.0)


@compiled(fastmath=())
def _reach(rotation: np.ndarray, place: Vector, x: Vector, n: Vector) -> float:
    """Magnitude of the numbers that are rounded when a point x of the world goes to object space
    and back, along its normal n: 0 at any distance along a level plane through the origin."""
    result = 0.0
    for row in range(3):
        size = 0.0
        for axis in range(3):
            size += abs(rotation[axis, row]) * (abs(x[axis]) + abs(place[axis]))
        result += (abs(n[row]) + _LEAST) * size
    return result


@compiled(fastmath=())
def _turned_back(rotation: np.ndarray, a: Vector, scale: float) -> Vector:
    r = rotation
    return (
        (r[0, 0] * a[0] + r[1, 0] * a[1] + r[2, 0] * a[2]) / scale,
        (r[0, 1] * a[0] + r[1, 1] * a[1] + r[2, 1] * a[2]) / scale,
        (r[0, 2] * a[0] + r[1, 2] * a[1] + r[2, 2] * a[2]) / scale,
    )


@compiled(fastmath=())
def _placed(rotation: np.ndarray, scale: float, place: Vector, a: Vector) -> Vector:
    r = rotation
    return (
        scale * (r[0, 0] * a[0] + r[0, 1] * a[1] + r[0, 2] * a[2]) + place[0],
        scale * (r[1, 0] * a[0] + r[1, 1] * a[1] + r[1, 2] * a[2]) + place[1],
        scale * (r[2, 0] * a[0] + r[2, 1] * a[1] + r[2, 2] * a[2]) + place[2],
    )


@compiled(rows="row directions result", fastmath=())
def _step_off(
    points: np.ndarray,
    normals: np.ndarray,
    step: np.ndarray,
    row: np.ndarray,
    directions: np.ndarray,
    result: np.ndarray,
) -> None:
    for i in range(len(row)):
        at = row[i]
        toward = np.float64(0.0)
        for axis in range(3):
            toward += np.float64(normals[at, axis]) * directions[i, axis]
        signed = -step[at] if toward < 0.0 else step[at]
        for axis in range(3):
            result[i, axis] = points[at, axis] + signed * normals[at, axis]

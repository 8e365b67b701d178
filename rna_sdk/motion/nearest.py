"""The nearest place on a mesh within a reach, by a grid of its triangles; compiled."""

import math

import numpy as np
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled
from rna_sdk.runtime.kernels.rotations import combined, difference, direction
from rna_sdk.runtime.kernels.vectors import Vector, cross, dot

Float64 = NDArray[np.float64]
Int64 = NDArray[np.int64]

_MOST_CELLS = 96
"""Cells of the grid along its longest side."""

_TIE = 1e-3
"""Surfaces whose distance differs by less than this share of the reach are told apart: a triangle
with a corner there goes before one that only touches the place, then by normals, as those of a
mouth that is closed."""

_CORNER = 1.0 - 1e-6
"""Weight from which on a place is a corner of its triangle."""


def nearest_places(
    points: NDArray[np.float32],
    normals: NDArray[np.float32] | None,
    positions: Float64,
    triangles: Int64,
    reach: float,
) -> tuple[Int64, Float64, Float64]:
    """Where on a mesh the points are: triangles (n,) int64, weights of corners and distances.

    points: (n, 3). normals: (n, 3), to choose between surfaces that touch; or None. positions,
    triangles: of the mesh. reach: distance beyond which a point is nowhere: its triangle is -1, and
    its distance that to the nearest vertex.
    """
    low, high = positions.min(axis=0), positions.max(axis=0)
    count = max(1, min(_MOST_CELLS, math.isqrt(len(triangles))))
    cell = max(float((high - low).max()) / count, reach, 1e-300)
    shape = np.maximum(1, np.int64(np.ceil((high - low) / cell + 1e-9)))
    starts, members = _grid(positions, triangles, low, cell, shape)
    result = np.full(len(points), -1, np.int64)
    weights, distance = np.zeros((len(points), 3)), np.full(len(points), np.inf)
    facing = np.zeros_like(points) if normals is None else normals
    grid = low, cell, shape, starts, members
    _search(points, facing, positions, triangles, grid, reach, result, weights, distance)
    lost = np.flatnonzero(result < 0)
    used = np.unique(triangles)
    for k in lost[:: max(1, len(lost) // 100)]:  # enough for a message
        distance[k] = np.linalg.norm(positions[used] - points[k], axis=1).min()
    distance[lost[np.isinf(distance[lost])]] = 0.0
    return result, weights, distance


def _grid(
    positions: Float64, triangles: Int64, low: Float64, cell: float, shape: Int64
) -> tuple[Int64, Int64]:
    """The triangles of each cell, by their boxes: where each cell's begin, and their numbers."""
    counts = np.zeros(int(shape.prod()) + 1, np.int64)
    _fill(positions, triangles, low, cell, shape, counts, np.zeros(0, np.int64))
    starts = np.concatenate([[0], np.cumsum(counts[:-1])])
    members = np.empty(starts[-1], np.int64)
    _fill(positions, triangles, low, cell, shape, starts[:-1].copy(), members)
    return starts, members


@compiled()
def _cell(x: float, low: float, cell: float, count: int) -> int:
    return min(max(math.floor((x - low) / cell), 0), count - 1)


@compiled()
def _fill(
    positions: Float64,
    triangles: Int64,
    low: Float64,
    cell: float,
    shape: Int64,
    next_place: Int64,
    members: Int64,
) -> None:
    """Count the triangles of each cell, or put their numbers where `next_place` says."""
    first, last = np.zeros(3, np.int64), np.zeros(3, np.int64)
    for t in range(len(triangles)):
        for axis in range(3):
            a, b = positions[triangles[t, 0], axis], positions[triangles[t, 1], axis]
            c = positions[triangles[t, 2], axis]
            first[axis] = _cell(min(a, b, c), low[axis], cell, shape[axis])
            last[axis] = _cell(max(a, b, c), low[axis], cell, shape[axis])
        for i in range(first[0], last[0] + 1):
            for j in range(first[1], last[1] + 1):
                for k in range(first[2], last[2] + 1):
                    at = (i * shape[1] + j) * shape[2] + k
                    if len(members):
                        members[next_place[at]] = t
                    next_place[at] += 1


@compiled()
def _corner(positions: Float64, triangles: Int64, t: int, k: int) -> Vector:
    v = triangles[t, k]
    return positions[v, 0], positions[v, 1], positions[v, 2]


@compiled()
def _place(p: Vector, a: Vector, b: Vector, c: Vector) -> Vector:
    """Barycentric weights of the point of a triangle that is nearest to p.

    Ericson, Real-Time Collision Detection (2005), section 5.1.5.
    """
    ab, ac, ap = difference(b, a), difference(c, a), difference(p, a)
    d1, d2 = dot(ab, ap), dot(ac, ap)
    if d1 <= 0.0 and d2 <= 0.0:
        return 1.0, 0.0, 0.0
    bp = difference(p, b)
    d3, d4 = dot(ab, bp), dot(ac, bp)
    if d3 >= 0.0 and d4 <= d3:
        return 0.0, 1.0, 0.0
    vc = d1 * d4 - d3 * d2
    if vc <= 0.0 and d1 >= 0.0 and d3 <= 0.0:
        v = d1 / (d1 - d3)
        return 1.0 - v, v, 0.0
    cp = difference(p, c)
    d5, d6 = dot(ab, cp), dot(ac, cp)
    if d6 >= 0.0 and d5 <= d6:
        return 0.0, 0.0, 1.0
    vb = d5 * d2 - d1 * d6
    if vb <= 0.0 and d2 >= 0.0 and d6 <= 0.0:
        w = d2 / (d2 - d6)
        return 1.0 - w, 0.0, w
    va = d3 * d6 - d5 * d4
    if va <= 0.0 and d4 - d3 >= 0.0 and d5 - d6 >= 0.0:
        w = (d4 - d3) / ((d4 - d3) + (d5 - d6))
        return 0.0, 1.0 - w, w
    total = va + vb + vc
    return va / total, vb / total, vc / total


@compiled(rows="points normals result weights distance", step=64)
def _search(
    points: NDArray[np.float32],
    normals: NDArray[np.float32],
    positions: Float64,
    triangles: Int64,
    grid: tuple[Float64, float, Int64, Int64, Int64],
    reach: float,
    result: Int64,
    weights: Float64,
    distance: Float64,
) -> None:
    low, cell, shape, starts, members = grid
    for row in range(len(points)):
        p = np.float64(points[row, 0]), np.float64(points[row, 1]), np.float64(points[row, 2])
        n = np.float64(normals[row, 0]), np.float64(normals[row, 1]), np.float64(normals[row, 2])
        best = np.inf
        i0, i1 = (
            _cell(p[0] - reach, low[0], cell, shape[0]),
            _cell(p[0] + reach, low[0], cell, shape[0]),
        )
        j0, j1 = (
            _cell(p[1] - reach, low[1], cell, shape[1]),
            _cell(p[1] + reach, low[1], cell, shape[1]),
        )
        k0, k1 = (
            _cell(p[2] - reach, low[2], cell, shape[2]),
            _cell(p[2] + reach, low[2], cell, shape[2]),
        )
        for i in range(i0, i1 + 1):
            for j in range(j0, j1 + 1):
                for k in range(k0, k1 + 1):
                    at = (i * shape[1] + j) * shape[2] + k
                    for m in range(starts[at], starts[at + 1]):
                        t = members[m]
                        a = _corner(positions, triangles, t, 0)
                        b = _corner(positions, triangles, t, 1)
                        c = _corner(positions, triangles, t, 2)
                        w = _place(p, a, b, c)
                        way = difference(combined(a, b, c, w[0], w[1], w[2]), p)
                        length = math.sqrt(dot(way, way))
                        ng = direction(cross(difference(b, a), difference(c, a)))
                        unlike = 1.0 - dot(n, ng) - (max(w) > _CORNER)
                        score = length + _TIE * reach * unlike
                        lower = score < best or (score == best and t < result[row])
                        if length <= reach and lower:
                            best = score
                            result[row], distance[row] = t, length
                            weights[row, 0], weights[row, 1], weights[row, 2] = w

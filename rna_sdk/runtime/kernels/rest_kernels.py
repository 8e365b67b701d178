"""Rest points of hits, normals of deformed meshes and rotations along strands, compiled.

`rna_sdk.runtime.deformation` describes the results. Arrays are C-contiguous; `result` arrays are
filled.
"""

import numpy as np
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled
from rna_sdk.runtime.kernels.rotations import (
    Matrix,
    combined,
    difference,
    direction,
    matrix_of,
    minimal_quaternion,
    product,
    quaternion_product,
    transposed,
    triangle_rotation,
    turned_by,
)
from rna_sdk.runtime.kernels.vectors import Rows, Vector, dot, vector

_FAR = 1e-3
"""Weight of a strand's middle and tip in the rotation of its root."""

Corners = NDArray[np.uint32]
Numbers = NDArray[np.int32]


@compiled(fastmath=())
def deformed_normals(
    rest: Rows,
    normals: Rows,
    triangles: Corners,
    weights: NDArray[np.float32],
    group: NDArray[np.int64],
    deformed: Rows,
    sums: NDArray[np.float64],
    result: Rows,
) -> None:
    """result[v]: normals[v], turned by the mean rotation of the triangles around it.

    weights: (t, 3) float32 of corners. group: (v,) int64, vertices at one place with one normal.
    sums: (groups, 3) float64, 0.
    """
    for k in range(len(triangles)):
        rotation, known = triangle_rotation(rest, deformed, triangles[k])
        if known:
            for c in range(3):
                corner = triangles[k, c]
                n = turned_by(rotation, vector(normals, corner))
                for axis in range(3):
                    sums[group[corner], axis] += weights[k, c] * n[axis]
    for v in range(len(normals)):
        at = group[v]
        n = direction((sums[at, 0], sums[at, 1], sums[at, 2]))
        if dot(n, n) == 0.0:
            n = vector(normals, v)
        result[v, 0], result[v, 1], result[v, 2] = n


@compiled(fastmath=())
def _mixed(values: Rows, corners: Corners, u: float, v: float) -> Vector:
    a, b, c = (vector(values, corners[0]), vector(values, corners[1]), vector(values, corners[2]))
    return combined(a, b, c, 1.0 - u - v, u, v)


@compiled(fastmath=())
def _store(rotation: Matrix, i: int, result: NDArray[np.float32]) -> None:
    for row in range(3):
        result[i, row, 0], result[i, row, 1], result[i, row, 2] = rotation[row]


@compiled(rows="triangle u v positions normals rotations", fastmath=())
def surface_rest_points(
    mesh: tuple[Rows, Rows, Corners],
    deformed: tuple[Rows, Rows],
    triangle: Numbers,
    u: NDArray[np.float32],
    v: NDArray[np.float32],
    positions: Rows,
    normals: Rows,
    rotations: NDArray[np.float32],
) -> None:
    """Fills the last three. mesh: rest positions, normals, triangles; deformed: the first two."""
    for i in range(len(triangle)):
        corners = mesh[2][triangle[i]]
        fu, fv = np.float64(u[i]), np.float64(v[i])
        positions[i, 0], positions[i, 1], positions[i, 2] = _mixed(mesh[0], corners, fu, fv)
        n = direction(_mixed(mesh[1], corners, fu, fv))
        normals[i, 0], normals[i, 1], normals[i, 2] = n
        rotation, _ = triangle_rotation(mesh[0], deformed[0], corners)
        back = transposed(rotation)
        bent = turned_by(back, direction(_mixed(deformed[1], corners, fu, fv)))
        if dot(n, n) > 0.0 and dot(bent, bent) > 0.0:
            back = product(matrix_of(minimal_quaternion(bent, n)), back)
        _store(back, i, rotations)


@compiled(rows="places", step=64, fastmath=())
def root_covariances(
    rest: Rows,
    deformed: Rows,
    first: NDArray[np.int64],
    count: NDArray[np.int64],
    order: NDArray[np.int64],
    places: NDArray[np.int64],
    reach: int,
    result: NDArray[np.float64],
) -> None:
    """(s, 3, 3): sums of deformed x rest vectors about the root of each strand.

    The vectors: the first segments of the strand and of its neighbours, of unit length, and the
    ways to the neighbours' roots by the rest's length; nearer ones weigh more. With little weight
    the ways to the strand's own middle and tip, for a curved strand that stands alone.

    first, count: (s,) roots, and numbers of points. order: (s,) strands, neighbours in space
    beside each other; `reach` on either side. places: of `order`, those to do.
    """
    for k in range(len(places)):
        place = places[k]
        strand = order[place]
        root = first[strand]
        near = np.inf
        start, stop = max(place - reach, 0), min(place + reach + 1, len(order))
        for other in range(start, stop):
            way = difference(vector(rest, first[order[other]]), vector(rest, root))
            square = dot(way, way)
            near = square if 0.0 < square < near else near
        for other in range(start, stop):
            beside = first[order[other]]
            way = difference(vector(rest, beside), vector(rest, root))
            square = dot(way, way)
            weight = near / square if square > near else 1.0
            _add(rest, deformed, beside, beside + 1, weight, result[strand])
            _add(rest, deformed, root, beside, weight, result[strand])
        for along in (count[strand] // 2, count[strand] - 1):
            _add(rest, deformed, root, root + along, _FAR, result[strand])


@compiled(fastmath=())
def _add(
    rest: Rows, deformed: Rows, a: int, b: int, weight: float, total: NDArray[np.float64]
) -> None:
    """total += weight d' d^T / |d|^2, d the way from point a to b at rest and d' deformed."""
    d, d1 = difference(vector(rest, b), vector(rest, a)), (0.0, 0.0, 0.0)
    d1 = difference(vector(deformed, b), vector(deformed, a))
    square = dot(d, d)
    scale = weight / square if square > 0.0 else 0.0
    for row in range(3):
        for column in range(3):
            total[row, column] += scale * d1[row] * d[column]


@compiled(rows="first stop segment roots", step=64, fastmath=())
def strand_rotations(
    rest: Rows,
    deformed: Rows,
    first: NDArray[np.int64],
    stop: NDArray[np.int64],
    segment: NDArray[np.int64],
    roots: NDArray[np.float64],
    result: NDArray[np.float32],
) -> None:
    """result: (m, 4) float32, the rotation of each segment from rest, as a quaternion.

    first, stop, segment: (s,), of each strand the first point, the one behind its last, and the
    first segment. roots: (s, 4) float64, of each strand's root. From there on the rotation of a
    segment is the rotation of the one before it, turned by the smallest angle that takes tangent to
    tangent.
    """
    for strand in range(len(first)):
        q = roots[strand, 0], roots[strand, 1], roots[strand, 2], roots[strand, 3]
        for a in range(first[strand], stop[strand] - 1):
            t = direction(difference(vector(rest, a + 1), vector(rest, a)))
            t1 = direction(difference(vector(deformed, a + 1), vector(deformed, a)))
            if dot(t1, t1) > 0.0:
                q = quaternion_product(minimal_quaternion(turned_by(matrix_of(q), t), t1), q)
            at = segment[strand] + a - first[strand]
            for k in range(4):
                result[at, k] = q[k]


@compiled(rows="segment u n positions tangents rotations", fastmath=())
def fiber_rest_points(
    curves: tuple[Rows, NDArray[np.float32], NDArray[np.uint32]],
    quaternions: NDArray[np.float32],
    segment: Numbers,
    u: NDArray[np.float32],
    n: Rows,
    positions: Rows,
    tangents: Rows,
    rotations: NDArray[np.float32],
) -> None:
    """Fills the last three. curves: rest points, radii, first points of segments."""
    for i in range(len(segment)):
        at = curves[2][segment[i]]
        q = quaternions[segment[i]]
        back = transposed(
            matrix_of((np.float64(q[0]), np.float64(q[1]), np.float64(q[2]), np.float64(q[3])))
        )
        fu = np.float64(u[i])
        a, b = vector(curves[0], at), vector(curves[0], at + 1)
        radius = (1.0 - fu) * curves[1][at] + fu * curves[1][at + 1]
        x = combined(a, b, turned_by(back, vector(n, i)), 1.0 - fu, fu, radius)
        positions[i, 0], positions[i, 1], positions[i, 2] = x
        tangents[i, 0], tangents[i, 1], tangents[i, 2] = direction(difference(b, a))
        _store(back, i, rotations)


@compiled(rows="values row result", fastmath=())
def turn_rows(
    rotations: NDArray[np.float32],
    inverse: bool,
    values: Rows,
    row: NDArray[np.int64],
    result: Rows,
) -> None:
    """result[i] = rotations[row[i]] values[i], or the inverse rotation."""
    for i in range(len(values)):
        m = rotations[row[i]]
        for k in range(3):
            total = 0.0
            for j in range(3):
                total += np.float64(m[j, k] if inverse else m[k, j]) * values[i, j]
            result[i, k] = total

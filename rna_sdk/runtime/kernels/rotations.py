"""Rotations of deformed triangles and segments, in compiled code: matrices by rows, quaternions.

A quaternion is (w, x, y, z); all calculations are in float64.
"""

import math

import numpy as np
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled
from rna_sdk.runtime.kernels.vectors import Rows, Vector, cross, dot, vector

Quaternion = tuple[float, float, float, float]
Matrix = tuple[Vector, Vector, Vector]

_FLAT = 1e-12
"""A triangle whose height is below this part of its longest edge, squared, has no frame."""


@compiled()
def difference(a: Vector, b: Vector) -> Vector:
    """a - b."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@compiled()
def direction(a: Vector) -> Vector:
    """a at unit length; (0, 0, 0) where it has none."""
    square = dot(a, a)
    scale = 1.0 / math.sqrt(square) if square > 0.0 else 0.0
    return a[0] * scale, a[1] * scale, a[2] * scale


@compiled()
def turned_by(m: Matrix, a: Vector) -> Vector:
    """m a."""
    return dot(m[0], a), dot(m[1], a), dot(m[2], a)


@compiled()
def combined(a: Vector, b: Vector, c: Vector, x: float, y: float, z: float) -> Vector:
    """x a + y b + z c."""
    return (
        x * a[0] + y * b[0] + z * c[0],
        x * a[1] + y * b[1] + z * c[1],
        x * a[2] + y * b[2] + z * c[2],
    )


@compiled()
def product(a: Matrix, b: Matrix) -> Matrix:
    """a b."""
    return (
        combined(b[0], b[1], b[2], a[0][0], a[0][1], a[0][2]),
        combined(b[0], b[1], b[2], a[1][0], a[1][1], a[1][2]),
        combined(b[0], b[1], b[2], a[2][0], a[2][1], a[2][2]),
    )


@compiled()
def identity() -> Matrix:
    """The rotation that turns nothing."""
    return (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


@compiled()
def minimal_quaternion(a: Vector, b: Vector) -> Quaternion:
    """The rotation by the smallest angle from a to b, unit vectors; about any axis across a if
    they are opposite."""
    w = 1.0 + dot(a, b)
    if w < 1e-9:
        across = cross(a, (1.0, 0.0, 0.0)) if abs(a[0]) < 0.7 else cross(a, (0.0, 1.0, 0.0))
        x, y, z = direction(across)
        return 0.0, x, y, z
    x, y, z = cross(a, b)
    scale = 1.0 / math.sqrt(w * w + x * x + y * y + z * z)
    return w * scale, x * scale, y * scale, z * scale


@compiled()
def quaternion_product(p: Quaternion, q: Quaternion) -> Quaternion:
    """The rotation q, then p; of unit length again."""
    w = p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3]
    x = p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2]
    y = p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1]
    z = p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]
    scale = 1.0 / math.sqrt(w * w + x * x + y * y + z * z)
    return w * scale, x * scale, y * scale, z * scale


@compiled()
def matrix_of(q: Quaternion) -> Matrix:
    """The matrix of a unit quaternion."""
    w, x, y, z = q
    return (
        (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)),
        (2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)),
        (2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)),
    )


@compiled()
def transposed(m: Matrix) -> Matrix:
    """The inverse rotation."""
    a, b, c = m
    return (a[0], b[0], c[0]), (a[1], b[1], c[1]), (a[2], b[2], c[2])


@compiled()
def triangle_frame(
    positions: Rows, corners: NDArray[np.uint32]
) -> tuple[Vector, Vector, Vector, Vector, bool]:
    """Unit vectors along the first edge, across it in the plane, and normal; the edges' lengths.

    The last: (length of the first edge, the second edge along it, and across it). False for a
    triangle without area, or with values that are not finite.
    """
    p, q = vector(positions, corners[0]), vector(positions, corners[1])
    e1, e2 = difference(q, p), difference(vector(positions, corners[2]), p)
    t, n = direction(e1), direction(cross(e1, e2))
    b = cross(n, t)
    sizes = math.sqrt(dot(e1, e1)), dot(e2, t), dot(e2, b)
    longest = max(dot(e1, e1), dot(e2, e2))
    height = sizes[0] * sizes[2]
    return t, b, n, sizes, height * height > _FLAT * longest * longest


@compiled()
def triangle_rotation(
    rest: Rows, deformed: Rows, corners: NDArray[np.uint32]
) -> tuple[Matrix, bool]:
    """The rotation of a triangle from rest: the polar factor of its deformation gradient.

    The gradient F takes edges to edges and the unit normal to the unit normal, so it is a map
    [[a, b], [0, d]] of the plane, in the two triangles' own axes, whose nearest rotation has a
    closed form. False, and no rotation, where either triangle has no area.
    """
    t, b, n, size, known = triangle_frame(rest, corners)
    t1, b1, n1, size1, known1 = triangle_frame(deformed, corners)
    if not (known and known1):
        return identity(), False
    along = size1[0] / size[0]
    shear = (size1[1] - along * size[1]) / size[2]
    c, s = along + size1[2] / size[2], -shear
    scale = 1.0 / math.sqrt(c * c + s * s)  # a, d > 0
    c, s = c * scale, s * scale
    x = combined(t1, b1, n1, c, s, 0.0)  # images of the rest axes
    y = combined(t1, b1, n1, -s, c, 0.0)
    return (
        combined(t, b, n, x[0], y[0], n1[0]),
        combined(t, b, n, x[1], y[1], n1[1]),
        combined(t, b, n, x[2], y[2], n1[2]),
    ), True

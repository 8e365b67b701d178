"""Vectors of three float64 in compiled code, and the frame that a surface scatters in."""

import numpy as np

from rna_sdk.machine.compiled import compiled

Vector = tuple[float, float, float]

# A shading normal that faces away from the viewer, as interpolated ones do at silhouettes, is
# tilted until its cosine with wo is this.
MIN_COSINE = 1e-4


@compiled(fastmath=())
def vector_at(vectors: np.ndarray, i: int) -> Vector:
    return np.float64(vectors[i, 0]), np.float64(vectors[i, 1]), np.float64(vectors[i, 2])


@compiled(fastmath=())
def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@compiled(fastmath=())
def cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@compiled(fastmath=())
def minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@compiled(fastmath=())
def plus(a: Vector, s: float, b: Vector) -> Vector:
    """a + s b"""
    return a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]


@compiled(fastmath=())
def unit(a: Vector) -> Vector:
    length = np.sqrt(dot(a, a))
    scale = 1.0 / length if length > 0.0 else 0.0
    return a[0] * scale, a[1] * scale, a[2] * scale


@compiled(fastmath=())
def turned_normal(n: Vector, ng: Vector, o: Vector) -> Vector:
    """The unit shading normal on wo's side of the surface, with at least MIN_COSINE to wo."""
    side = dot(ng, o)
    m = n if dot(n, n) > 0.0 else ng
    m = unit(m) if dot(m, m) > 0.0 else o
    away = dot(m, ng) * side if side != 0.0 else dot(m, o)
    if away < 0.0:
        m = (-m[0], -m[1], -m[2])
    missing = MIN_COSINE - dot(m, o)
    if missing > 0.0:
        m = unit((m[0] + missing * o[0], m[1] + missing * o[1], m[2] + missing * o[2]))
    return m


@compiled(fastmath=())
def half_cosines(m: Vector, o: Vector, i: Vector) -> tuple[float, float]:
    """Cosines of the half vector with the normal and with wo; (0, 0) where there is none."""
    h = (o[0] + i[0], o[1] + i[1], o[2] + i[2])
    length = np.sqrt(dot(h, h))
    if length < 1e-12:
        return 0.0, 0.0
    return min(dot(m, h) / length, 1.0), dot(o, h) / length


@compiled(fastmath=())
def tangents_of(n: Vector) -> tuple[Vector, Vector]:
    """Two unit vectors across n: Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1),
    2017)."""
    x, y, z = n
    sign = np.copysign(1.0, z)
    c = -1.0 / (sign + z)
    d = x * y * c
    return (1.0 + sign * x * x * c, sign * d, -sign * x), (d, sign + y * y * c, -y)


@compiled(inline=True, fastmath=())
def along(axis: Vector, a: float, b: float, c: float) -> Vector:
    """a, b along the unit vectors across the unit `axis`, and c along it."""
    s, t = tangents_of(axis)
    return (
        a * s[0] + b * t[0] + c * axis[0],
        a * s[1] + b * t[1] + c * axis[1],
        a * s[2] + b * t[2] + c * axis[2],
    )

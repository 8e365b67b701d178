"""Vectors of kernels: three components, float64 or lanes (`dot` and `cross`)."""

import math

import numpy as np
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled

Rows = NDArray[np.float32]
Vector = tuple[float, float, float]


@compiled()
def vector(vectors: Rows, i: int) -> Vector:
    """Row i."""
    return np.float64(vectors[i, 0]), np.float64(vectors[i, 1]), np.float64(vectors[i, 2])


@compiled()
def unit(vectors: Rows, i: int) -> Vector:
    """Row i at unit length; NaN in a component where the vector has no direction."""
    x, y, z = vector(vectors, i)
    square = x * x + y * y + z * z
    scale = 1.5 - 0.5 * square  # 1 / sqrt(square) to 4e-11 where square is within 1e-5 of 1
    if not abs(square - 1.0) < 1e-5:
        scale = 1.0 / math.sqrt(square)
    return x * scale, y * scale, z * scale


@compiled()
def dot(a: Vector, b: Vector) -> float:
    """a . b."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@compiled()
def cross(a: Vector, b: Vector) -> Vector:
    """a x b."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


@compiled()
def clamped(x: float) -> float:
    """x, moved into [-1, 1]."""
    return min(max(x, -1.0), 1.0)

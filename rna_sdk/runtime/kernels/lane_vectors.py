"""Compiled arithmetic of the query kernel on lanes; a vector is three of them."""

import math
from typing import Any

from rna_sdk.machine.compiled import compiled
from rna_sdk.runtime.kernels.lanes import (
    everywhere,
    exponent_and_mantissa,
    narrow,
    power_of_two,
    sqrt,
    where,
    whole,
)
from rna_sdk.runtime.kernels.vectors import dot

_LOG_SCALE = 2.0 / math.log(2.0)
_LOG2_E = 1.0 / math.log(2.0)
_LN2_HIGH = 0.693359375  # 9 bits: times a whole number exact in float32
_LN2_LOW = math.log(2.0) - _LN2_HIGH


@compiled()
def unit(v: Any) -> Any:
    """float64 vectors at unit length, as float32; NaN where a vector has no direction."""
    square = dot(v, v)
    # 1 / sqrt(square) to 4e-11 where square is within 1e-5 of 1, as it mostly is.
    scale, near = 1.5 - 0.5 * square, absolute(square - 1.0) < 1e-5
    if not everywhere(near):
        scale = where(near, scale, 1.0 / sqrt(square))
    return narrowed((v[0] * scale, v[1] * scale, v[2] * scale))


@compiled()
def narrowed(v: Any) -> Any:
    """float64 vectors as float32."""
    return narrow(v[0]), narrow(v[1]), narrow(v[2])


@compiled()
def total(v: Any) -> Any:
    """Sum of the components."""
    return v[0] + v[1] + v[2]


@compiled()
def absolute(x: Any) -> Any:
    return where(x < 0.0, 0.0 - x, x)


@compiled()
def largest(v: Any) -> Any:
    """The largest absolute component of a vector."""
    x, y, z = absolute(v[0]), absolute(v[1]), absolute(v[2])
    xy = where(x > y, x, y)
    return where(xy > z, xy, z)


@compiled()
def length(v: Any) -> Any:
    return sqrt(dot(v, v))


@compiled()
def between(x: Any, low: float, high: float) -> Any:
    """x, moved into [low, high]; `low` for NaN."""
    above = where(x > low, x, low)
    return where(above < high, above, high)


@compiled()
def clamped(x: Any) -> Any:
    """x, moved into [-1, 1]."""
    return between(x, -1.0, 1.0)


@compiled()
def log2(x: Any) -> Any:
    """log2 of positive normal numbers to 1e-7.

    x = 2^e m with m within sqrt(2) of 1. With s = (m - 1) / (m + 1),
    log2 m = 2 / ln 2 (s + s^3 / 3 + s^5 / 5 + ...).
    """
    e, m = exponent_and_mantissa(x)
    s = (m - 1.0) / (m + 1.0)
    q = s * s
    series = 1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0)))
    return e + _LOG_SCALE * s * series


@compiled()
def exp(x: Any) -> Any:
    """exp of float32 numbers from 0 to 100, to 1.2e-7 of it; infinity where float32 ends.

    x = k ln 2 + r with k whole and |r| at most ln 2 / 2, of which the series of exp is taken.
    """
    k = whole(x * _LOG2_E + 0.5)
    r = x - k * _LN2_HIGH - k * _LN2_LOW
    series = 1.0 / 120.0 + r * (1.0 / 720.0 + r * (1.0 / 5040.0))
    series = 1.0 + r * (1.0 / 2.0 + r * (1.0 / 6.0 + r * (1.0 / 24.0 + r * series)))
    half = whole(k * 0.5)  # 2^k in two factors: k may be more than float32's exponent holds
    return (1.0 + r * series) * power_of_two(half) * power_of_two(k - half)

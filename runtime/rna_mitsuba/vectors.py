"""Vectors in Dr.Jit, in float32, with the functions of the input blocks' formulas (spec, 6.3)."""

import drjit as dr
import mitsuba as mi

cross, dot, log2, where, at_least = dr.cross, dr.dot, dr.log2, dr.select, dr.maximum

_TINY = (127 - 60) << 23
"""The bits of 2^-60."""


def is_zero(v: mi.Vector3f) -> mi.Bool:
    """Whether all components are 0. By their bits: kernels take subnormal numbers for 0."""
    bits = [_magnitude(v[k]) for k in range(3)]
    return (bits[0] | bits[1] | bits[2]) == 0


def unit(v: mi.Vector3f) -> mi.Vector3f:
    """v at length 1; 0 where it is 0. Two steps: squares of large and small numbers overflow."""
    tiny = [_magnitude(v[k]) < _TINY for k in range(3)]
    v = dr.select(tiny[0] & tiny[1] & tiny[2], mi.Vector3f(*(_enlarged(v[k]) for k in range(3))), v)
    largest = dr.max(dr.abs(v))
    v = v * dr.select(largest > 2.0**60, 2.0**-100, 1)  # divisors whose inverse is subnormal
    largest = dr.max(dr.abs(v))
    v = v / dr.select(largest > 0, dr.detach(largest), 1)
    square = dr.dot(v, v)
    return v / dr.sqrt(dr.select(square > 0, square, 1))


def _magnitude(x: mi.Float) -> mi.UInt32:
    """The bits of |x|."""
    return dr.reinterpret_array(mi.UInt32, x) & 0x7FFFFFFF


def _enlarged(x: mi.Float) -> mi.Float:
    """2^149 x for |x| below 2^-60; a subnormal number is its mantissa times 2^-149."""
    bits = _magnitude(x)
    size = dr.select(bits < 1 << 23, mi.Float(bits), dr.abs(x) * 2.0**100 * 2.0**49)
    return dr.select(dr.reinterpret_array(mi.UInt32, x) >> 31 != 0, -size, size)


def length(v: mi.Vector3f) -> mi.Float:
    """|v|, whose derivative is 0 at 0."""
    return sqrt(dr.dot(v, v))


def sqrt(x: mi.Float) -> mi.Float:
    """The square root, 0 of negative numbers, whose derivative is 0 at 0."""
    return dr.select(x > 0, dr.sqrt(dr.select(x > 0, x, 1)), 0)


def largest(v: mi.Vector3f) -> mi.Float:
    """The largest absolute component; a constant to derivatives, as a scale."""
    return dr.detach(dr.max(dr.abs(v)))


def clamped(x: mi.Float) -> mi.Float:
    """x, moved into [-1, 1]."""
    return dr.clip(x, -1, 1)


def numbers(value: mi.Float | mi.Vector3f) -> list[mi.Float]:
    """The components of a vector, or the number."""
    return [value] if dr.depth_v(value) == 1 else [value[k] for k in range(3)]

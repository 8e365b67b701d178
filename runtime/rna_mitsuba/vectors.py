"""Vectors in Dr.Jit, in float32 and without lost digits (spec/RNA.md, 6.3, "In float32")."""

from __future__ import annotations

import drjit as dr
import mitsuba as mi

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
    square = dr.dot(v, v)
    return dr.select(square > 0, dr.sqrt(dr.select(square > 0, square, 1)), 0)


def half_vector(wo: mi.Vector3f, wi: mi.Vector3f) -> mi.Vector3f:
    """Unit, halfway of wo and wi; 0 where they are opposite."""
    s, e = wi + wo, wi - wo
    nearly_opposite = dr.dot(s, s) < dr.dot(e, e)
    e2 = dr.select(nearly_opposite, dr.dot(e, e), 1)
    s = dr.select(nearly_opposite, s - e * (dr.dot(s, e) / e2), s)
    size = length(s)
    return dr.select(size < 1e-6, 0, s / dr.select(size < 1e-6, 1, size))


def components(*vectors: mi.Vector3f) -> list[mi.Float]:
    """x, y and z of each."""
    return [v[k] for v in vectors for k in range(3)]

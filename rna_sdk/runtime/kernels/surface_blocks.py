"""Compiled: the input blocks of surfaces alone, of a normal and two directions of length 1.

In float32 lanes, by the formulas of spec/RNA.md, "In float32", which lose no digits.
"""

from __future__ import annotations

from typing import Any

from rna_sdk.compiled import compiled
from rna_sdk.runtime.kernels.lane_vectors import largest, log2
from rna_sdk.runtime.kernels.lanes import sqrt, where
from rna_sdk.runtime.kernels.vectors import cross, dot

BEND = 0.1
"""How far a feature of 1 moves the end of the normal: spec/RNA.md, Input blocks."""

SHORTEST = 1e-6
"""Length below which a sum of directions has none itself."""


@compiled()
def halfway(wo: Any, wi: Any) -> tuple[Any, Any]:
    """m, the unit vector along wi + wo, and where they are opposite: m is 0 there.

    Zero answers n.m and wi.m as the vector across n and wo does that 6.3 has there.
    """
    s = (wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2])
    e = (wi[0] - wo[0], wi[1] - wo[1], wi[2] - wo[2])
    square = dot(e, e)
    part = where(dot(s, s) < square, dot(s, e) / square, 0.0)
    s = (s[0] - e[0] * part, s[1] - e[1] * part, s[2] - e[2] * part)
    square = dot(s, s)
    opposite = square < SHORTEST * SHORTEST
    scale = where(opposite, 0.0, 1.0 / sqrt(square))
    return (s[0] * scale, s[1] * scale, s[2] * scale), opposite


@compiled()
def half_vector(n: Any, wo: Any, wi: Any, m: Any, opposite: Any) -> tuple[Any, ...]:
    """n.m, log2(1 - min(n.m, 1) + 1e-4) / 6, n.wi, n.wo, wi.m; m, opposite: of `halfway`."""
    return dot(n, m), _log_gap(n, m, opposite), dot(n, wi), dot(n, wo), dot(wi, m)


@compiled()
def highlight(n: Any, m: Any, opposite: Any) -> Any:
    """log2(|n x m|^2 + 1e-8) / 12: tells angles between n and m down to 0.006 degrees."""
    aside = cross(n, m)
    return log2(where(opposite, 1.0, dot(aside, aside)) + 1e-8) * (1.0 / 12.0)


@compiled()
def learned_normal(n: Any, bend: Any, m: Any, opposite: Any) -> tuple[Any, Any]:
    """q.m and log2(1 - min(q.m, 1) + 1e-4) / 6; bend: of `bent`; m, opposite: of `halfway`."""
    q, _ = bent(n, bend)
    return dot(q, m), _log_gap(q, m, opposite)


@compiled()
def bent(n: Any, bend: Any) -> tuple[Any, Any]:
    """q, along n + BEND bend; and the length of that sum, below SHORTEST where q is n.

    bend: the first three features.
    """
    q = (n[0] + BEND * bend[0], n[1] + BEND * bend[1], n[2] + BEND * bend[2])
    top = largest(q)  # the square of a large feature leaves float32
    top = where(top > 0.0, top, 1.0)
    q = (q[0] / top, q[1] / top, q[2] / top)
    length = sqrt(dot(q, q))
    none = length * top < SHORTEST
    q = (
        where(none, n[0], q[0] / length),
        where(none, n[1], q[1] / length),
        where(none, n[2], q[2] / length),
    )
    return q, length * top


@compiled()
def _log_gap(n: Any, m: Any, opposite: Any) -> Any:
    """log2(1 - min(n.m, 1) + 1e-4) / 6, which resolves angles down to 0.8 degrees."""
    d = (n[0] - m[0], n[1] - m[1], n[2] - m[2])
    return log2(where(opposite, 1.0, 0.5 * dot(d, d)) + 1e-4) * (1.0 / 6.0)

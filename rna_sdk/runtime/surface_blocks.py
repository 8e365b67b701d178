"""Compiled: the input blocks of surfaces alone, of a normal and two directions of length 1."""

from __future__ import annotations

import math

from rna_sdk.compiled import compiled
from rna_sdk.runtime.vectors import Vector, cross, dot, log2

BEND = 0.1
"""How far a feature of 1 moves the end of the normal: spec/RNA.md, Input blocks."""


@compiled()
def half_vector(n: Vector, wo: Vector, wi: Vector) -> tuple[float, ...]:
    """n.h, log2(1 - min(n.h, 1) + 1e-4) / 6, n.wi, n.wo, wi.h, with h halfway of wi and wo."""
    h = (wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2])
    square = dot(h, h)
    scale = 1.0 / math.sqrt(square)
    if square < 1e-12:  # opposite directions have no half vector
        h, scale = n, 1.0
    n_h = dot(n, h) * scale
    return n_h, _log_gap(n_h), dot(n, wi), dot(n, wo), dot(wi, h) * scale


@compiled()
def highlight(n: Vector, wo: Vector, wi: Vector) -> tuple[float, ...]:
    """log2(|n x h|^2 + 1e-8) / 12: tells angles between n and h down to 0.006 degrees."""
    h = (wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2])
    square = dot(h, h)
    aside = cross(n, h)
    sine = 0.0 if square < 1e-12 else dot(aside, aside) / square
    return (log2(sine + 1e-8) / 12.0,)


@compiled()
def learned_normal(n: Vector, bend: Vector, wo: Vector, wi: Vector) -> tuple[float, ...]:
    """q.h and log2(1 - min(q.h, 1) + 1e-4) / 6, with q along n + BEND bend.

    bend: the first three features.
    """
    q = (n[0] + BEND * bend[0], n[1] + BEND * bend[1], n[2] + BEND * bend[2])
    if dot(q, q) < 1e-12:
        q = n
    h = (wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2])
    square = dot(h, h)
    q_h = 1.0 if square < 1e-12 else dot(q, h) / math.sqrt(dot(q, q) * square)
    return q_h, _log_gap(q_h)


@compiled()
def _log_gap(cosine: float) -> float:
    """log2(1 - min(cosine, 1) + 1e-4) / 6: resolves angles down to 0.8 degrees."""
    return log2(1.0 - min(cosine, 1.0) + 1e-4) / 6.0

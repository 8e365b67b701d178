"""Compiled: the input blocks of surfaces alone, `half_vector` and `highlight`."""

from __future__ import annotations

import math

from rna_sdk.runtime.compiled import compiled
from rna_sdk.runtime.vectors import Vector, cross, dot, log2


@compiled()
def half_vector(n: Vector, wo: Vector, wi: Vector) -> tuple[float, ...]:
    """n.h, log2(1 - min(n.h, 1) + 1e-4) / 6, n.wi, n.wo, wi.h, with h halfway of wi and wo."""
    h = (wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2])
    square = dot(h, h)
    scale = 1.0 / math.sqrt(square)
    if square < 1e-12:  # opposite directions have no half vector
        h, scale = n, 1.0
    n_h = dot(n, h) * scale
    log_gap = log2(1.0 - min(n_h, 1.0) + 1e-4) / 6.0
    return n_h, log_gap, dot(n, wi), dot(n, wo), dot(wi, h) * scale


@compiled()
def highlight(n: Vector, wo: Vector, wi: Vector) -> tuple[float, ...]:
    """log2(|n x h|^2 + 1e-8) / 12: tells angles between n and h down to 0.006 degrees."""
    h = (wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2])
    square = dot(h, h)
    aside = cross(n, h)
    sine = 0.0 if square < 1e-12 else dot(aside, aside) / square
    return (log2(sine + 1e-8) / 12.0,)

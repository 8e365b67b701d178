"""Compiled: the input blocks of fibers alone, `fiber_angles` and `fiber_lobes`.

Longitudinal angles, measured from the plane across the fiber, come as sines (s) and cosines (c);
phi is the angle around the tangent from wo to wi. Angles come as cosine and sine: no
trigonometry.
"""

from __future__ import annotations

import math

from rna_sdk.compiled import compiled
from rna_sdk.runtime.vectors import Vector, clamped, cross, dot, log2

ETA = 1.55
"""Index of refraction of hair (Marschner et al. 2003, Light Scattering from Human Hair Fibers)."""

_PARALLEL = 1e-6
"""Product of cosines below which there is no telling phi: a direction is along the fiber."""


@compiled()
def fiber_blocks(
    t: Vector, h: float, wo: Vector, wi: Vector
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """The values of `fiber_angles` and of `fiber_lobes`, for unit t, wo, wi and h in [-1, 1]."""
    s_o, s_i = dot(t, wo), dot(t, wi)
    cone = s_i + s_o  # 0 where wi is on the cone that a smooth cylinder reflects wo into
    log_cone = log2(cone * cone + 1e-3) / 6.0
    c_o, cos_phi, sin_phi = _azimuth(t, wo, wi)
    lobes = _lobes(cos_phi, sin_phi, s_o, c_o, h)
    return (s_i, s_o, cone, log_cone, cos_phi, sin_phi), lobes


@compiled()
def _azimuth(t: Vector, wo: Vector, wi: Vector) -> Vector:
    """c_o, cos(phi) and sin(phi).

    In products with t the component along t is gone, and so t x wo and t x wi are wo and wi seen
    along the fiber, turned a quarter: of lengths c_o and c_i, with phi between them.
    """
    o, i = cross(t, wo), cross(t, wi)
    square = dot(o, o)
    d = math.sqrt(square * dot(i, i))
    if d < _PARALLEL:
        return math.sqrt(square), 1.0, 0.0
    return math.sqrt(square), clamped(dot(o, i) / d), clamped(dot(t, cross(wo, wi)) / d)


@compiled()
def _lobes(cos_phi: float, sin_phi: float, s_o: float, c_o: float, h: float) -> Vector:
    """cos(phi - Phi_p), Phi_p = 2 g_o - 2 p g_t - p pi, for p = 0, 1, 2: R, TT and TRT.

    Phi_p is where a ray that meets the fiber at offset h leaves a smooth glass cylinder after p
    segments inside (Marschner et al. 2003, section 4.2); sin g_o = h, and g_t is refracted with
    Bravais' index for the cross-section, eta' = sqrt(eta^2 - s_o^2) / c_o.
    """
    sin_t = h * c_o / math.sqrt(ETA * ETA - s_o * s_o)
    reflected = _doubled(h)  # 2 g_o
    inside = _doubled(sin_t)
    segment = -inside[0], inside[1]  # each segment inside adds -2 g_t - pi
    once = _turned(reflected, segment)
    twice = _turned(once, segment)
    return (
        cos_phi * reflected[0] + sin_phi * reflected[1],
        cos_phi * once[0] + sin_phi * once[1],
        cos_phi * twice[0] + sin_phi * twice[1],
    )


@compiled()
def _doubled(sine: float) -> tuple[float, float]:
    """Cosine and sine of twice the angle within 90 degrees that has this sine."""
    square = sine * sine
    return 1.0 - 2.0 * square, 2.0 * sine * math.sqrt(1.0 - square)


@compiled()
def _turned(a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
    """Cosine and sine of the sum of two angles: the product of two complex numbers."""
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]

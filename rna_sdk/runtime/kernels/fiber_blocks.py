"""Compiled: the input blocks of fibers alone, `fiber_angles` and `fiber_lobes`.

Longitudinal angles, measured from the plane across the fiber, come as sines (s) and cosines (c);
phi is the angle around the tangent from wo to wi. Angles come as cosine and sine: no
trigonometry. In float32 lanes, by the formulas of spec/RNA.md, "In float32", which lose no digits.
"""

from __future__ import annotations

from typing import Any

from rna_sdk.compiled import compiled
from rna_sdk.runtime.kernels.lane_vectors import clamped, log2
from rna_sdk.runtime.kernels.lanes import sqrt, where
from rna_sdk.runtime.kernels.vectors import cross, dot

ETA = 1.55
"""Index of refraction of hair (Marschner et al. 2003, Light Scattering from Human Hair Fibers)."""

_PARALLEL = 1e-6
"""Product of cosines below which there is no telling phi: a direction is along the fiber."""


@compiled()
def fiber_blocks(t: Any, h: Any, wo: Any, wi: Any) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
    """The values of `fiber_angles` and of `fiber_lobes`, for unit t, wo, wi and h in [-1, 1]."""
    s_o, s_i = dot(t, wo), dot(t, wi)
    cone = s_i + s_o  # 0 where wi is on the cone that a smooth cylinder reflects wo into
    log_cone = log2(cone * cone + 1e-3) * (1.0 / 6.0)
    c_o, cos_phi, sin_phi = _azimuth(t, wo, wi)
    lobes = _lobes(cos_phi, sin_phi, s_o, c_o, h)
    return (s_i, s_o, cone, log_cone, cos_phi, sin_phi), lobes


@compiled()
def _azimuth(t: Any, wo: Any, wi: Any) -> tuple[Any, Any, Any]:
    """c_o, cos(phi) and sin(phi).

    In products with t the component along t is gone, and so t x wo and t x wi are wo and wi seen
    along the fiber, turned a quarter: of lengths c_o and c_i, with phi between them.
    """
    o, i = cross(t, wo), cross(t, wi)
    c_o = sqrt(dot(o, o))
    d = c_o * sqrt(dot(i, i))
    along = d < _PARALLEL
    cos_phi, sin_phi = clamped(dot(o, i) / d), clamped(dot(t, cross(o, i)) / d)
    return c_o, where(along, 1.0, cos_phi), where(along, 0.0, sin_phi)


@compiled()
def _lobes(cos_phi: Any, sin_phi: Any, s_o: Any, c_o: Any, h: Any) -> tuple[Any, Any, Any]:
    """cos(phi - Phi_p), Phi_p = 2 g_o - 2 p g_t - p pi, for p = 0, 1, 2: R, TT and TRT.

    Phi_p is where a ray that meets the fiber at offset h leaves a smooth glass cylinder after p
    segments inside (Marschner et al. 2003, section 4.2); sin g_o = h, and g_t is refracted with
    Bravais' index for the cross-section, eta' = sqrt(eta^2 - s_o^2) / c_o.
    """
    sin_t = h * c_o / sqrt(ETA * ETA - s_o * s_o)
    reflected = _doubled(h)  # 2 g_o
    inside = _doubled(sin_t)
    segment = 0.0 - inside[0], inside[1]  # each segment inside adds -2 g_t - pi
    once = _turned(reflected, segment)
    twice = _turned(once, segment)
    return (
        cos_phi * reflected[0] + sin_phi * reflected[1],
        cos_phi * once[0] + sin_phi * once[1],
        cos_phi * twice[0] + sin_phi * twice[1],
    )


@compiled()
def _doubled(sine: Any) -> tuple[Any, Any]:
    """Cosine and sine of twice the angle within 90 degrees that has this sine."""
    cosine = sqrt((1.0 - sine) * (1.0 + sine))
    return 1.0 - 2.0 * sine * sine, 2.0 * sine * cosine


@compiled()
def _turned(a: tuple[Any, Any], b: tuple[Any, Any]) -> tuple[Any, Any]:
    """Cosine and sine of the sum of two angles: the product of two complex numbers."""
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]

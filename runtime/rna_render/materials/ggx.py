"""The GGX microfacet surface: its distribution, its masking, and samples of it.

Walter et al., Microfacet Models for Refraction through Rough Surfaces (EGSR 2007); Heitz,
Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs (JCGT 3(2), 2014).
Directions are local: the normal is +z. Scalars are float64.
"""

from pathlib import Path

import numpy as np

from rna_sdk.machine.compiled import compiled

# Rougher than a mirror by so much that no sample's density leaves float32 (peak 1/(pi alpha^2)).
MIN_ALPHA = 1e-3

# Rows of roughness and columns of sqrt(cosine) of the albedo's table.
TABLE_SIZE = 96

ALBEDO_FILE = Path(__file__).with_name("ggx_albedo.npy")
"""The table of `ggx_albedo`, (96, 96, 2) float32, as `ggx_quadrature` makes it: 0.3 s less at each
start."""


@compiled(fastmath=())
def distribution(alpha: float, nh: float) -> float:
    """D of the half vector's cosine nh > 0, per steradian of half vectors."""
    a2 = alpha * alpha
    spread = (1.0 - nh * nh) + a2 * nh * nh
    return a2 / (np.pi * spread * spread)


@compiled(fastmath=())
def root(alpha: float, cosine: float) -> float:
    """The square root in Smith's masking of a direction at that cosine to the normal."""
    return float(np.sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine))


@compiled(fastmath=())
def visibility(alpha: float, cos_o: float, cos_i: float) -> float:
    """G / (4 cos_o cos_i) with Smith's height-correlated G; cosines of at least 0, not both 0."""
    return 0.5 / (cos_i * root(alpha, cos_o) + cos_o * root(alpha, cos_i))


@compiled(fastmath=())
def reflected_density(alpha: float, cos_o: float, nh: float) -> float:
    """Density of the directions that `sample_reflection` finds, per steradian.

    G1(wo) D / (4 cos_o), below the horizon too.
    """
    return distribution(alpha, nh) / (2.0 * (cos_o + root(alpha, cos_o)))


@compiled(fastmath=())
def sample_reflection(
    alpha: float, ox: float, oy: float, oz: float, u1: float, u2: float
) -> tuple[float, float, float]:
    """Reflection of wo at a normal out of those that wo sees; maybe below the horizon.

    Dupuy and Benyoub, Sampling Visible GGX Normals with Spherical Caps (HPG 2023), listing 3.
    """
    sx, sy, sz = alpha * ox, alpha * oy, oz
    length = np.sqrt(sx * sx + sy * sy + sz * sz)
    sx, sy, sz = sx / length, sy / length, sz / length
    phi = 2.0 * np.pi * u1
    z = (1.0 - u2) * (1.0 + sz) - sz
    radius = np.sqrt(max(0.0, 1.0 - z * z))
    hx = alpha * (radius * np.cos(phi) + sx)
    hy = alpha * (radius * np.sin(phi) + sy)
    hz = z + sz
    length = np.sqrt(hx * hx + hy * hy + hz * hz)
    if length > 0.0:
        hx, hy, hz = hx / length, hy / length, hz / length
    else:
        hx, hy, hz = 0.0, 0.0, 1.0
    twice = 2.0 * (ox * hx + oy * hy + oz * hz)
    return twice * hx - ox, twice * hy - oy, twice * hz - oz


@compiled(fastmath=())
def schlick(cosine: float) -> float:
    """(1 - cosine)^5, the weight of grazing reflectance."""
    x = 1.0 - min(max(cosine, 0.0), 1.0)
    return x * x * x * x * x

"""The GGX microfacet surface: its distribution, its masking, samples of it, and what it reflects.

Walter et al., Microfacet Models for Refraction through Rough Surfaces (EGSR 2007); Heitz,
Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs (JCGT 3(2), 2014).
Directions are local: the normal is +z. Scalars are float64.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
from numba import carray  # type: ignore[attr-defined]

from rna_render.memory import pointer_f64
from rna_sdk.compiled import compiled

# Rougher than a mirror by so much that no sample's density leaves float32 (peak 1/(pi alpha^2)).
MIN_ALPHA = 1e-3

# Rows of roughness and columns of sqrt(cosine) of the albedo's table.
TABLE_SIZE = 96

ALBEDO_FILE = Path(__file__).with_name("ggx_albedo.npy")
"""The table, (96, 96, 2) float32, as `ggx_quadrature` makes it: 0.3 s less at each start."""


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


@cache
def albedo_table() -> tuple[np.ndarray, np.ndarray]:
    """Terms A and B of the directional albedo for light along wo: r0 * A + B.

    r0 is the reflectance straight on, and Schlick's Fresnel term makes it 1 at grazing angles.

    Returns (96, 96, 2) float64, A and B by roughness (uniform in sqrt(alpha), first row
    MIN_ALPHA) and by wo (uniform in sqrt(cosine)); and (96, 2) float64, their means over wo,
    weighted by 2 cosine. Look both up with `albedo_terms` and `mean_albedo_terms`.
    """
    table = np.load(ALBEDO_FILE).astype(np.float64)
    # The mean of the interpolated table itself, so that what it takes and gives adds up to 1.
    fine = (np.arange(4096) + 0.5) / 4096
    nodes = np.linspace(0, 1, TABLE_SIZE)
    mean = np.empty((TABLE_SIZE, 2))
    for row in range(TABLE_SIZE):
        for term in range(2):
            value = np.interp(np.sqrt(fine), nodes, table[row, :, term])
            mean[row, term] = np.mean(2.0 * fine * value)
    return table, mean


@cache
def albedo_addresses() -> np.ndarray:
    """Addresses of the arrays of `albedo_table`, (2,) uint64, for `albedo_views`."""
    return np.array([array.ctypes.data for array in albedo_table()], np.uint64)


@compiled(fastmath=())
def albedo_views(addresses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The arrays of `albedo_table`, without the reference count that each call which passes an
    array on would raise and lower: 30 ns a sample of a material."""
    table = carray(pointer_f64(addresses[0]), (TABLE_SIZE, TABLE_SIZE, 2))
    return table, carray(pointer_f64(addresses[1]), (TABLE_SIZE, 2))


@compiled(fastmath=())
def _place(value: float, size: int) -> tuple[int, float]:
    """Cell of a table's axis, and the place in it; value in [0, 1], or not a number."""
    place = value * (size - 1)
    cell = min(int(place), size - 2) if place > 0.0 else 0
    return cell, place - cell


@compiled(fastmath=())
def albedo_terms(table: np.ndarray, alpha: float, cosine: float) -> tuple[float, float]:
    """A and B of `albedo_table`, bilinear."""
    row, s = _place(np.sqrt(min(alpha, 1.0)), len(table))
    column, t = _place(np.sqrt(min(max(cosine, 0.0), 1.0)), len(table))
    a, b = 0.0, 0.0
    for i in range(2):
        for j in range(2):
            weight = (s if i else 1.0 - s) * (t if j else 1.0 - t)
            a += weight * table[row + i, column + j, 0]
            b += weight * table[row + i, column + j, 1]
    return a, b


@compiled(fastmath=())
def mean_albedo_terms(mean: np.ndarray, alpha: float) -> tuple[float, float]:
    """Means of A and B over wo, linear."""
    row, s = _place(np.sqrt(min(alpha, 1.0)), len(mean))
    a = (1.0 - s) * mean[row, 0] + s * mean[row + 1, 0]
    b = (1.0 - s) * mean[row, 1] + s * mean[row + 1, 1]
    return a, b

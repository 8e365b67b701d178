"""The directional albedo of a GGX surface, as a table that compiled code reads by address."""

import numpy as np
from numba import carray  # type: ignore[attr-defined]

from rna_render.materials.ggx import ALBEDO_FILE, TABLE_SIZE
from rna_sdk.machine.compiled import compiled
from rna_trace.memory import pointer_f64


def _means(table: np.ndarray) -> np.ndarray:
    """Means of an albedo table over wo, weighted by 2 cosine: (96, 2) float64.

    Of the interpolated table itself, so that what it takes and gives adds up to 1.
    """
    count = 4096
    cosine = (np.arange(count) + 0.5) / count
    place = np.sqrt(cosine) * (TABLE_SIZE - 1)
    cell = place.astype(np.int64)
    part, weight = place - cell, 2.0 * cosine / count
    nodes = np.bincount(cell, weight * (1.0 - part), TABLE_SIZE)
    nodes += np.bincount(cell + 1, weight * part, TABLE_SIZE)
    means: np.ndarray = np.einsum("rct,c->rt", table, nodes)
    return means


ALBEDO_TABLE = np.load(ALBEDO_FILE).astype(np.float64)
"""Terms A and B of the directional albedo for light along wo, r0 * A + B: (96, 96, 2) float64.

By roughness (uniform in sqrt(alpha), first row MIN_ALPHA) and by wo (uniform in sqrt(cosine)). r0
is the reflectance straight on, and Schlick's Fresnel term makes it 1 at grazing angles. Looked up
by `albedo_terms`.
"""

ALBEDO_MEANS = _means(ALBEDO_TABLE)
"""Means of A and B over wo: (96, 2) float64, looked up by `mean_albedo_terms`."""

# Kernels read both arrays by address, in all threads: they are made with the module and stay.
ALBEDO_ADDRESSES = np.array([ALBEDO_TABLE.ctypes.data, ALBEDO_MEANS.ctypes.data], np.uint64)
"""Addresses of ALBEDO_TABLE and ALBEDO_MEANS, (2,) uint64, for `albedo_views`."""


@compiled(fastmath=())
def albedo_views(addresses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """ALBEDO_TABLE and ALBEDO_MEANS, without the reference count that each call which passes an
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
    """A and B of ALBEDO_TABLE, bilinear."""
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

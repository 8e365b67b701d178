"""Albedo of a GGX surface, by quadrature.

    python -m rna_render.materials.ggx_quadrature

writes the table anew that `ggx_albedo` reads.
"""

import numpy as np

from rna_render.materials.ggx import (
    ALBEDO_FILE,
    MIN_ALPHA,
    TABLE_SIZE,
    root,
    sample_reflection,
    schlick,
    visibility,
)
from rna_sdk.machine.compiled import compiled

# Samples of each entry: half a turn, and outward. With the size of the table they keep it within
# 1.5e-3 of the integral.
TURN_SAMPLES, OUTWARD_SAMPLES = 24, 48


def fill_albedo(table: np.ndarray) -> None:
    """Entries of `ggx_albedo.ALBEDO_TABLE`, by quadrature, into (n, n, 2) float64."""
    _fill_rows(np.arange(len(table)), table)


@compiled(rows="rows table", step=1, fastmath=())
def _fill_rows(rows: np.ndarray, table: np.ndarray) -> None:
    size = table.shape[1]
    for row in range(len(rows)):
        alpha = max(MIN_ALPHA, (rows[row] / (size - 1)) ** 2)
        for column in range(size):
            cos_o = (column / (size - 1)) ** 2
            a, b = _quadrature(alpha, cos_o)
            table[row, column, 0], table[row, column, 1] = a, b


@compiled(fastmath=())
def _quadrature(alpha: float, cos_o: float) -> tuple[float, float]:
    sin_o = np.sqrt(1.0 - cos_o * cos_o)
    all_light, grazing = 0.0, 0.0
    for i in range(TURN_SAMPLES):
        for j in range(OUTWARD_SAMPLES):
            # Denser towards u2 = 1, where the steepest facets are; wo's plane is a mirror.
            rest = 1.0 - (j + 0.5) / OUTWARD_SAMPLES
            u1, u2 = 0.5 * (i + 0.5) / TURN_SAMPLES, 1.0 - rest * rest
            x, _, z = sample_reflection(alpha, sin_o, 0.0, cos_o, u1, u2)
            if z > 0.0:
                # D cancels in f cos / pdf, and leaves G2 / G1.
                weight = 2.0 * visibility(alpha, cos_o, z) * z * (cos_o + root(alpha, cos_o))
                weight *= 2.0 * rest
                oh = np.sqrt(max(0.0, 0.5 * (1.0 + sin_o * x + cos_o * z)))
                all_light += weight
                grazing += weight * schlick(oh)
    count = TURN_SAMPLES * OUTWARD_SAMPLES
    return (all_light - grazing) / count, grazing / count


if __name__ == "__main__":
    entries = np.empty((TABLE_SIZE, TABLE_SIZE, 2))
    fill_albedo(entries)
    np.save(ALBEDO_FILE, entries.astype(np.float32))

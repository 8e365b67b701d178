"""The compiled kernels of `Transform` and `offset_across`: one result for each row."""

import math

import numpy as np
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled
from rna_sdk.runtime.kernels.vectors import Rows, clamped, cross, dot, unit


@compiled()
def map_rows(
    values: NDArray[np.float32],
    linear: NDArray[np.float64],
    before: NDArray[np.float64],
    after: NDArray[np.float64],
    result: NDArray[np.float32],
) -> None:
    """result[i] = linear @ (values[i] - before) + after."""
    for i in range(len(values)):
        x, y, z = values[i, 0] - before[0], values[i, 1] - before[1], values[i, 2] - before[2]
        for k in range(3):
            total = linear[k, 0] * x + linear[k, 1] * y + linear[k, 2] * z
            result[i, k] = np.float32(total + after[k])


@compiled()
def fill_offsets(normals: Rows, tangents: Rows, wo: Rows, h: NDArray[np.float32]) -> None:
    """h[i] as `offset_across` has it."""
    for i in range(len(h)):
        across = cross(unit(tangents, i), unit(wo, i))
        length = math.sqrt(dot(across, across))
        offset = dot(unit(normals, i), across)
        known = length > 1e-6 and offset - offset == 0.0  # false for any NaN
        h[i] = clamped(offset / length) if known else 0.0

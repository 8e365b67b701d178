"""The compiled kernel that hands a decoder's output to the caller, with its promises kept."""

from __future__ import annotations

import numba
import numpy as np
from numpy.typing import NDArray

from rna_sdk.compiled import compiled

_LARGEST = np.float32(np.finfo(np.float32).max)


@compiled(
    numba.types.Array(numba.types.float32, 2, "C", readonly=True),
    numba.types.intp,
    numba.types.boolean[::1],
    numba.types.float32[:, ::1],
)
def write_colours(
    output: NDArray[np.float32],
    column: int,
    valid: NDArray[np.bool_],
    colours: NDArray[np.float32],
) -> None:
    """Write three columns of a decoder's output, from `column` on, to `colours`.

    output: (m, k), m >= n; valid: (n,); colours: (n, 3), written. Negative values and NaN become
    0, values too large the largest float32, rows that are not valid 0.
    """
    zero = np.float32(0.0)
    for i in range(len(colours)):
        for k in range(3):
            value = output[i, column + k]
            # NaN fails the comparison.
            colours[i, k] = min(value, _LARGEST) if valid[i] and value > zero else zero

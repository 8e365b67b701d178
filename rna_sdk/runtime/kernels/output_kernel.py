"""The compiled kernel that hands a decoder's output to the caller, with its promises kept."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numba
import numpy as np
from numpy.typing import NDArray

from rna_sdk.compiled import compiled

_LARGEST = np.float32(np.finfo(np.float32).max)


@cache
def result_kernel(columns: int, signed: tuple[int, ...] = ()) -> Callable[..., None]:
    """The kernel for results of so many columns; signed: those that may be negative.

    Its arguments:
        output   (m, k) float32, m >= n, of a decoder
        column   int, the first of this result
        valid    (n,) bool
        results  (n, columns) float32, written: NaN becomes 0, values too large the largest
                 float32, negative ones 0 but in signed columns, rows that are not valid 0
    """
    lowest = tuple(-_LARGEST if k in signed else np.float32(0) for k in range(columns))

    @compiled(
        numba.types.Array(numba.types.float32, 2, "C", readonly=True),
        numba.types.intp,
        numba.types.boolean[::1],
        numba.types.float32[:, ::1],
    )
    def write_results(
        output: NDArray[np.float32],
        column: int,
        valid: NDArray[np.bool_],
        results: NDArray[np.float32],
    ) -> None:
        for i in range(len(results)):
            for k in range(columns):
                value, least = output[i, column + k], lowest[k]
                if valid[i] and value > least:
                    results[i, k] = min(value, _LARGEST)
                elif valid[i] and value <= least:
                    results[i, k] = least
                else:  # NaN fails both comparisons
                    results[i, k] = np.float32(0.0)

    return write_results

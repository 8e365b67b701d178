"""The compiled kernel that copies a decoder's output to the caller: finite, not negative."""

from __future__ import annotations

from typing import Any

import numba
import numpy as np
from numpy.typing import NDArray

from rna_sdk.compiled import compiled

_LARGEST = np.float32(np.finfo(np.float32).max)

OUTPUT = numba.types.Array(numba.types.float32, 2, "C", readonly=True)


@compiled()
def sanitised(value: Any) -> Any:
    """A decoder's value as results have it: 0 for NaN and what is negative, and never infinite."""
    return min(value, _LARGEST) if value > 0.0 else np.float32(0.0)  # NaN fails the comparison


@compiled(
    OUTPUT,
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
    """One result of a decoder.

    output: (m, k) float32, m >= n. column: its first. valid: (n,) bool. results: (n, 3) float32,
    written; rows that are not valid are 0.
    """
    for i in range(len(results)):
        for k in range(3):
            results[i, k] = sanitised(output[i, column + k]) if valid[i] else np.float32(0.0)

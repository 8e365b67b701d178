"""The compiled kernel that copies a decoder's output to the caller: finite, not negative."""

import math
from typing import Any

import numba
import numpy as np
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled

_LARGEST = np.float32(np.finfo(np.float32).max)

OUTPUT = numba.types.Array(numba.types.float32, 2, "C", readonly=True)


@compiled()
def sanitised(value: Any) -> Any:
    """A decoder's value as results have it: 0 for NaN and negative values, never infinite."""
    return min(value, _LARGEST) if value > 0.0 else np.float32(0.0)  # NaN fails the comparison


@compiled(OUTPUT, numba.types.intp, numba.types.boolean[::1], numba.types.float32[:, ::1])
def write_results(
    output: NDArray[np.float32], column: int, valid: NDArray[np.bool_], results: NDArray[np.float32]
) -> None:
    """One result of a decoder.

    output: (m, k) float32, m >= n. column: its first. valid: (n,) bool. results: (n, 3) float32,
    written; rows that are not valid are 0.
    """
    for i in range(len(results)):
        for k in range(3):
            results[i, k] = sanitised(output[i, column + k]) if valid[i] else np.float32(0.0)


@compiled(OUTPUT, OUTPUT, numba.types.boolean[::1], numba.types.float32[:, ::1])
def mix_sets(
    output: NDArray[np.float32],
    nearby: NDArray[np.float32],
    valid: NDArray[np.bool_],
    mixed: NDArray[np.float32],
) -> None:
    """The first of a decoder's sets of columns, plus the others times nearby light.

    output: (m, k) float32, m >= n. nearby: (n, sets - 1), below 0 as 0. valid: (n,) bool, cleared
    in rows whose nearby light has NaN or infinity. mixed: (n, columns of a set) float32, written.
    """
    rows, columns = mixed.shape
    for i in range(rows):
        for c in range(columns):
            mixed[i, c] = output[i, c]
        for k in range(nearby.shape[1]):
            share = max(nearby[i, k], np.float32(0.0))
            valid[i] &= math.isfinite(nearby[i, k])
            for c in range(columns):
                mixed[i, c] += share * output[i, columns * (k + 1) + c]


@compiled(
    OUTPUT,
    numba.types.intp,
    numba.types.intp,
    OUTPUT,
    numba.types.boolean[::1],
    numba.types.float32[:, ::1],
)
def write_sums(
    output: NDArray[np.float32],
    column: int,
    factor: int,
    base_color: NDArray[np.float32],
    valid: NDArray[np.bool_],
    results: NDArray[np.float32],
) -> None:
    """One result of a decoder with factors: the output, and another times the base colour.

    factor: the first column of the other. base_color: (n, 3); the rest as for `write_results`. A
    row whose base colour has NaN or infinity is 0.
    """
    for i in range(len(results)):
        a, b, c = base_color[i, 0], base_color[i, 1], base_color[i, 2]
        known = valid[i] and math.isfinite(a) and math.isfinite(b) and math.isfinite(c)
        for k in range(3):
            total = output[i, column + k] + base_color[i, k] * output[i, factor + k]
            results[i, k] = sanitised(total) if known else np.float32(0.0)

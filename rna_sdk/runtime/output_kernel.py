"""The compiled kernel that hands a decoder's output to the caller, with its promises kept."""

from __future__ import annotations

import numba
import numpy as np
from numpy.typing import NDArray

from rna_sdk.compiled import compiled

_ROWS = numba.types.float32[:, ::1]
_LARGEST = np.float32(np.finfo(np.float32).max)


@compiled(
    numba.types.Array(numba.types.float32, 2, "C", readonly=True),
    numba.types.boolean[::1],
    _ROWS,
    _ROWS,
)
def split_transport(
    transport: NDArray[np.float32],
    valid: NDArray[np.bool_],
    visible: NDArray[np.float32],
    shadowed: NDArray[np.float32],
) -> None:
    """Write columns 0 to 2 of `transport` to `visible` and 3 to 5 to `shadowed`.

    transport: (m, 6), m >= n; valid: (n,); visible, shadowed: (n, 3), written. Negative values
    and NaN become 0, values too large the largest float32, rows that are not valid 0.
    """
    zero = np.float32(0.0)
    for i in range(len(visible)):
        for k in range(3):
            a, b = transport[i, k], transport[i, k + 3]
            # NaN fails the comparison.
            visible[i, k] = min(a, _LARGEST) if valid[i] and a > zero else zero
            shadowed[i, k] = min(b, _LARGEST) if valid[i] and b > zero else zero

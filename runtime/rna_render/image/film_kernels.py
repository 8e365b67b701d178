"""Sums of a film, by all threads."""

from __future__ import annotations

import numpy as np
from numba import prange

from rna_sdk.compiled import compiled


@compiled(parallel=True, fastmath=())
def add(total: np.ndarray, values: np.ndarray) -> None:
    """Add (n, c) values to (n, c) float64 sums.

    Memory of layers that a scene lacks, which are 0, is never touched.
    """
    for k in prange(len(values)):
        for c in range(values.shape[1]):
            if values[k, c] != 0.0:
                total[k, c] += values[k, c]


@compiled(parallel=True, fastmath=())
def keep_first(kept: np.ndarray, numbers: np.ndarray) -> None:
    """Take over (n,) numbers where (n,) those kept are still 0."""
    for k in prange(len(numbers)):
        if kept[k] == 0:
            kept[k] = numbers[k]

"""The machine's own rate of matrix products, which timings are compared with."""

import time
from collections.abc import Callable

import numpy as np

from rna_export.machine import seconds_of

_GEMM_SIZE = 2048
GEMM_FLOP = 2 * _GEMM_SIZE**3
_SPINNING = 0.2  # s, longer than idle threads of the product spin


def matrix_product() -> Callable[[], float]:
    """The machine's own 2048-cubed float32 matrix product, on all cores: GEMM_FLOP of them.

    A call returns its seconds of wall time, and waits until the threads of the product, which look
    out for more work, leave the cores to what is timed next.
    """
    a, b = np.random.default_rng(0).random((2, _GEMM_SIZE, _GEMM_SIZE), np.float32)

    def product() -> float:
        seconds = seconds_of(lambda: a @ b)
        time.sleep(_SPINNING)
        return seconds

    return product

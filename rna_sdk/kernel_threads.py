"""Threads of parallel kernels: numba's, callable from several Python threads at once."""

from __future__ import annotations

import os
from typing import Any

import numba
from numba.np.ufunc import get_num_threads, set_num_threads, threading_layer

from rna_sdk.cores import core_count
from rna_sdk.errors import RnaError

_SAFE_LAYERS = ("tbb", "omp", "safe", "threadsafe")
"""Settings of numba's threading layer with which kernels may run side by side. With the others
numba may choose its `workqueue`, which ends the process when a second thread comes."""

_config: Any = numba.config


def launch_kernel_threads() -> None:
    """Start numba's threads, if nobody has, in a layer that is safe.

    Raises:
        RnaError: no such layer can be loaded, or an unsafe one is running already.
    """
    if str(_config.THREADING_LAYER).lower() not in _SAFE_LAYERS:
        _config.THREADING_LAYER = "threadsafe"
    if not _is_launched() and "NUMBA_NUM_THREADS" not in os.environ:
        _config.NUMBA_NUM_THREADS = core_count()  # numba's own number knows no container's quota
    try:
        get_num_threads()
    except ValueError:
        raise RnaError(
            "numba found no thread-safe threading layer (setting: "
            f"{_config.THREADING_LAYER}); install one with: pip install tbb"
        ) from None
    if threading_layer() == "workqueue":
        raise RnaError(
            "numba already runs its 'workqueue' threads, which are not thread-safe; set the "
            "environment variable NUMBA_THREADING_LAYER=threadsafe before the program starts"
        )


def _is_launched() -> bool:
    try:
        threading_layer()
    except ValueError:
        return False
    return True


def kernel_threads() -> int:
    """Number of threads of a parallel kernel that is called from this thread.

    Raises:
        RnaError: as `launch_kernel_threads`.
    """
    launch_kernel_threads()
    return int(get_num_threads())


def limit_kernel_threads(count: int | None) -> int:
    """Let parallel kernels called from this thread take `count` threads, and return how many.

    count: at least 1; no more are taken than numba has, and None takes those.

    Raises:
        RnaError: as `launch_kernel_threads`.
    """
    launch_kernel_threads()
    most = int(_config.NUMBA_NUM_THREADS)
    threads = min(count or most, most)
    set_num_threads(threads)
    return threads

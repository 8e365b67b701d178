"""Threads of parallel kernels: numba's, callable from several Python threads at once.

Only kernels that no host calls have them: those of training.
"""

import os
from typing import Any

import numba
from numba.np.ufunc import get_num_threads, parallel, set_num_threads, threading_layer

from rna_sdk.errors import RnaError
from rna_sdk.machine.kernel_threads import limit_kernel_threads, most_threads

_SAFE_LAYERS = ("tbb", "omp", "safe", "threadsafe")
"""Settings of numba's threading layer with which kernels may run side by side. With the others
numba may choose its `workqueue`, which ends the process when a second thread comes."""

_config: Any = numba.config


def launch_numba_threads() -> None:
    """Start numba's threads, if nobody has, in a layer that is safe.

    They are `most_threads`, and sleep while they have nothing to do. Numba has read its number of
    threads by now, which knows no container's quota: it launches as many as its module has.

    Raises:
        RnaError: no such layer can be loaded, or an unsafe one is running already.
    """
    if str(_config.THREADING_LAYER).lower() not in _SAFE_LAYERS:
        _config.THREADING_LAYER = "threadsafe"
    if not _is_launched():
        os.environ.setdefault("OMP_WAIT_POLICY", "passive")  # libgomp reads it when it is loaded
        _config.NUMBA_NUM_THREADS = parallel.NUM_THREADS = most_threads()
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


def limit_all_threads(count: int | None) -> int:
    """`limit_kernel_threads`, for parallel kernels too.

    Raises:
        RnaError: as `launch_numba_threads`.
    """
    launch_numba_threads()
    threads = min(limit_kernel_threads(count), int(_config.NUMBA_NUM_THREADS))
    set_num_threads(threads)
    return threads

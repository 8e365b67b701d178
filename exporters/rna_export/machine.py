"""The machine: its memory and clock."""

import ctypes
import time
from collections.abc import Callable

# Parameters of mallopt(3), from malloc.h.
_M_TRIM_THRESHOLD, _M_TOP_PAD, _M_MMAP_THRESHOLD, _M_ARENA_MAX = -1, -2, -3, -8


def seconds_of(action: Callable[[], object]) -> float:
    """Wall time of a call."""
    start = time.perf_counter()
    action()
    return time.perf_counter() - start


def keep_freed_memory() -> None:
    """Tell glibc's malloc to reuse arrays of up to 32 MB and not to give memory back.

    For loops that allocate equal arrays: by default each is mapped anew and every page of it
    faults, and a training step at width 64 took 120 ms instead of 11. Does nothing with another C
    library.
    """
    try:
        mallopt = ctypes.CDLL("libc.so.6").mallopt
    except (OSError, AttributeError):
        return
    mallopt(_M_MMAP_THRESHOLD, 1 << 25)  # the largest that glibc takes
    mallopt(_M_TRIM_THRESHOLD, 2**31 - 1)
    mallopt(_M_TOP_PAD, 1 << 28)
    mallopt(_M_ARENA_MAX, 1)

"""Keeps freed memory in the process, for loops that allocate the same large arrays each step."""

from __future__ import annotations

import ctypes

# Parameters of mallopt(3), from malloc.h.
_M_TRIM_THRESHOLD, _M_TOP_PAD, _M_MMAP_THRESHOLD, _M_ARENA_MAX = -1, -2, -3, -8


def keep_freed_memory() -> None:
    """Tell glibc's malloc to reuse arrays of up to 32 MB and not to give memory back.

    By default each such array is mapped anew and every page of it faults: a training step at
    width 64 took 120 ms instead of 11. Does nothing with another C library.
    """
    try:
        mallopt = ctypes.CDLL("libc.so.6").mallopt
    except (OSError, AttributeError):
        return
    mallopt(_M_MMAP_THRESHOLD, 1 << 25)  # the largest that glibc takes
    mallopt(_M_TRIM_THRESHOLD, 2**31 - 1)
    mallopt(_M_TOP_PAD, 1 << 28)
    mallopt(_M_ARENA_MAX, 1)

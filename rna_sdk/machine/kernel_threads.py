"""Threads of kernels and of decoders: this process' own, in any of which a call may begin.

They are Python's, not OpenMP's: they wait without spinning, are as many as each caller wants, and
a forked process makes its own.
"""

import os
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from functools import cache

from rna_sdk.machine.cores import core_count

_caller = threading.local()
"""Per thread: `count`, the limit on the threads of its calls, if there is one."""


class _Helpers:
    """The threads beside those that call."""

    def __init__(self) -> None:
        self.renew()

    def renew(self) -> None:
        """Others: in a forked process there are none, and a lock may be held by one of them."""
        self.pool = ThreadPoolExecutor(most_threads(), thread_name_prefix="rna-kernel")


@cache
def most_threads() -> int:
    """Number of threads of a call without a limit: all cores that this process may use.

    NUMBA_NUM_THREADS in the environment is another number.
    """
    wanted = os.environ.get("NUMBA_NUM_THREADS", "")
    return int(wanted) if wanted.isdecimal() and int(wanted) > 0 else core_count()


def kernel_threads() -> int:
    """Number of threads of a kernel that is called from this thread."""
    return int(getattr(_caller, "count", most_threads()))


def limit_kernel_threads(count: int | None) -> int:
    """Let kernels called from this thread take `count` threads, and return how many.

    count: at least 1; no more are taken than `most_threads`, and None takes those.
    """
    _caller.count = min(count or most_threads(), most_threads())
    return int(_caller.count)


@contextmanager
def at_most(count: int | None) -> Iterator[None]:
    """A context whose kernels, called from this thread, take no more than `count` threads."""
    before = kernel_threads()
    _caller.count = min(count or before, before)
    try:
        yield
    finally:
        _caller.count = before


def share(run: Callable[[Iterator[int]], None], starts: Sequence[int], threads: int) -> None:
    """Call `run` in this thread and in up to `threads` - 1 others, and wait for all.

    starts: of pieces of work. Each call of `run` is given the iterator of those that are left, and
    takes from it until it is empty. After an error or Ctrl-C no piece is begun.
    """
    left = iter(starts)
    others = min(threads, len(starts)) - 1
    running = []
    with suppress(RuntimeError):  # once the main thread has ended, executors take no work
        for _ in range(others):
            running.append(_helpers.pool.submit(run, left))
    try:
        run(left)
    finally:
        for _ in left:
            pass
        for helper in running:
            if not helper.cancel():  # busy threads may not have come to it; none is needed
                helper.result()


_helpers = _Helpers()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_helpers.renew)

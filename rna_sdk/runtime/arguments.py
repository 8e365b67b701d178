"""Checks of arguments to the runtime."""

from __future__ import annotations

import os

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import vectors
from rna_sdk.errors import QueryError


def results(value: object, number: int, count: int) -> tuple[NDArray[np.float32], ...]:
    """`value`, checked to be a tuple of `number` writable arrays for `count` rows of results.

    Raises:
        QueryError: it is not.
    """
    if not isinstance(value, tuple) or len(value) != number:
        raise QueryError(f"out: expected a tuple of {number} arrays, found {type(value).__name__}")
    for k, array in enumerate(value):
        vectors(name := f"out[{k}]", array, count)
        if not (array.flags.c_contiguous and array.flags.writeable and array.flags.aligned):
            raise QueryError(f"{name}: expected a C-contiguous array that can be written")
    return value


def thread_count(threads: int | None) -> int:
    """`threads`, or for None the number of cores available to this process.

    Raises:
        QueryError: `threads` is not a positive integer.
    """
    if threads is None:
        affinity = getattr(os, "sched_getaffinity", None)  # Linux alone has it
        return len(affinity(0)) if affinity else os.cpu_count() or 1
    if isinstance(threads, bool) or not isinstance(threads, int) or threads < 1:
        raise QueryError(f"threads: expected an integer of at least 1 or None, found {threads!r}")
    return threads

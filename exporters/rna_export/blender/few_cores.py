"""Limits Blender's thread pools to the requested number of threads."""

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress


@contextmanager
def few_cores(count: int) -> Iterator[None]:
    """In this context the process has `count` of its cores, afterwards all of them again.

    Pools of threads that start in it have as many threads. TBB's has one for each core of the
    affinity mask, whatever Cycles is told, and those without work spin: on 16 cores a render of one
    thread takes up to 16. The mask is given back, since a process that stays bound shares its core
    with whatever else is bound to it, such as the first worker of another capture. Systems without
    affinity (macOS, Windows) go without: TBB has no setting for it outside of C++.

    Which cores follows from the process's number: workers that start together import Blender on
    different ones. Sixteen on one core took 40 s before the first ray.
    """
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, chosen(cores, count, os.getpid()))
    try:
        yield
    finally:
        for thread in os.listdir("/proc/self/task"):
            with suppress(ProcessLookupError):  # it has ended meanwhile
                os.sched_setaffinity(int(thread), cores)


def chosen(cores: set[int], count: int, number: int) -> set[int]:
    """`count` of the cores, or all if there are fewer; consecutive numbers start at other cores."""
    ordered = sorted(cores)
    first = number % len(ordered)
    return set((ordered[first:] + ordered[:first])[:count])

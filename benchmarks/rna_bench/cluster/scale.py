"""Overhead of one cluster driver: no-op tasks, and gathering of results.

    rna-bench cluster-scale --tasks 100000 --workers 2

Prints the driver's time and CPU per task, its memory, the rate at which results arrive, and the
resulting number of workers that saturate one driver.
"""

from __future__ import annotations

import argparse
import resource
import time
from functools import partial
from pathlib import Path
from typing import Any

from rna_bench.bench_options import add_out
from rna_bench.results import publish
from rna_work.backend import Needs
from rna_work.executors import open_executor
from rna_work.pool import Pool

_SHARD_SECONDS = 60.0  # what a shard of a capture takes, about


class StandIn:
    """A worker that returns a given number of bytes."""

    def __init__(self, size: int, name: str) -> None:
        self._answer = bytes(size)

    def __enter__(self) -> StandIn:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, item: int) -> bytes:
        return self._answer

    def kill(self) -> None:
        pass


def memory_mb() -> float:
    """Memory of this process without Ray's shared memory, MB."""
    status = Path("/proc/self/status").read_text()
    return int(next(x.split()[1] for x in status.splitlines() if x.startswith("RssAnon"))) / 1e3


def cpu_seconds() -> float:
    """CPU time of this process, all threads."""
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def measure(executor: Any, tasks: int, workers: int, size: int, ahead: int) -> dict[str, Any]:
    """Runs the tasks; figures of the driver."""
    backend = executor.workers(Needs("processes", cpus=0.5), workers)
    pool: Pool[int, bytes] = Pool(backend, partial(StandIn, size), ahead=ahead)
    with pool:
        for _ in pool.run(range(10 * workers)):  # all have started
            pass
        memory, started, cpu = [memory_mb()], time.perf_counter(), cpu_seconds()
        for done, outcome in enumerate(pool.run(range(tasks)), 1):
            outcome.value()
            if done % max(1, tasks // 10) == 0:
                memory.append(memory_mb())
        seconds, used = time.perf_counter() - started, cpu_seconds() - cpu
    return {
        "tasks": tasks,
        "workers": workers,
        "bytes": size,
        "us_a_task": 1e6 * seconds / tasks,
        "driver_cpu_us_a_task": 1e6 * used / tasks,
        "mb_a_second": size * tasks / seconds / 1e6,
        "memory_mb": [round(m, 1) for m in memory],
        "workers_that_keep_a_driver_busy": _SHARD_SECONDS / (used / tasks),
    }


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--cluster", default="local", help="cluster address; none: local processes")
    parser.add_argument("--tasks", type=int, default=100_000, help="number of no-op tasks")
    parser.add_argument("--workers", type=int, default=2, help="number of workers")
    add_out(parser)


def run(args: argparse.Namespace) -> None:
    with open_executor(None if args.cluster == "none" else args.cluster) as executor:
        small = measure(executor, args.tasks, args.workers, 100, ahead=4)
        large = measure(executor, 200, args.workers, 10_000_000, ahead=0)
    publish({"small": small, "large": large}, args)

"""Decode cost of packages, measured beside the machine's own rate of matrix products."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from pydantic import BaseModel, Field

from rna_bench.matrix_product import GEMM_FLOP, matrix_product
from rna_export.capture.dataset.asset_arguments import Arguments, rows_of
from rna_export.machine import seconds_of
from rna_sdk.machine.cpu import processor, thread_count
from rna_sdk.runtime import FiberAsset, SurfaceAsset, load

_SECONDS = 0.05  # of one evaluation
_REPEATS = 7
_FEWEST, _MOST = 16_384, 1_000_000


class QueryCost(BaseModel, extra="forbid", frozen=True):
    """Nanoseconds per query, everything included; medians."""

    ns: float = Field(description="on all threads")
    ns_one_thread: float


class Costs(BaseModel, extra="forbid", frozen=True):
    """Measured in one run, one after the other, over and over."""

    machine: str
    threads: int
    repeats: int
    gemm_gflops: float = Field(description="of 2048-cubed float32 matrix products, all threads")
    of: dict[str, QueryCost]


def measure_costs(packages: dict[str, Path], queries: Arguments) -> Costs:
    """Costs of packages by name, each the median of several evaluations.

    Every repeat goes through all packages and a matrix product, so that whatever else slows the
    machine down for a while slows all of them alike. queries: of `all_queries`.
    """
    timed = {
        (name, threads): _evaluation(load(path, threads=threads).parts, queries)
        for name, path in packages.items()
        for threads in (None, 1)
    }
    product, gemm = matrix_product(), []
    taken: dict[tuple[str, int | None], list[float]] = {key: [] for key in timed}
    for _ in range(_REPEATS):
        gemm.append(product())
        for key, (evaluate, rows) in timed.items():
            taken[key].append(1e9 * seconds_of(evaluate) / rows)
    median = {key: float(np.median(values)) for key, values in taken.items()}
    return Costs(
        machine=processor(),
        threads=thread_count(None),
        repeats=_REPEATS,
        gemm_gflops=1e-9 * GEMM_FLOP / float(np.median(gemm)),
        of={
            name: QueryCost(ns=median[name, None], ns_one_thread=median[name, 1])
            for name in packages
        },
    )


def _evaluation(
    parts: tuple[SurfaceAsset | FiberAsset, ...], queries: Arguments
) -> tuple[Callable[[], object], int]:
    """An evaluation of the one part that takes about `_SECONDS`, warm; its number of queries."""
    (part,) = parts
    evaluate: Callable[..., object] = part.evaluate  # what follows fits either kind
    few = rows_of(queries, np.arange(_FEWEST) % len(queries[0]))
    evaluate(*few)
    rate = _FEWEST / seconds_of(lambda: evaluate(*few))
    n = int(np.clip(rate * _SECONDS, _FEWEST, _MOST))
    rows = rows_of(queries, np.arange(n) % len(queries[0]))
    out = np.zeros((n, 3), np.float32), np.zeros((n, 3), np.float32)
    return lambda: evaluate(*rows, out=out), n

"""Times one checkout's `evaluate` whenever it is asked; `evaluate_against.py` does.

    python -m rna_bench.speed.evaluate_worker CHECKOUT PACKAGE BATCHES

BATCHES: an .npz of the arguments of `evaluate`, `name/0` and on for each batch. For each line that
comes in it writes a line of JSON: CPU ns of this thread, per flop of a matrix product (`gemm`) and
per query of each batch. It uses public names alone, which other checkouts have, too.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import rna_sdk
from rna_sdk.runtime import load

_GEMM_SIZE = 1024


def main() -> None:
    checkout, package_path, batches_path = sys.argv[1:]
    assert rna_sdk.__file__ is not None and Path(rna_sdk.__file__).is_relative_to(checkout)
    (asset,) = load(package_path, threads=1).parts
    evaluate: Callable[..., object] = asset.evaluate
    batches = load_batches(batches_path)
    n = len(next(iter(batches.values()))[0])
    out = np.zeros((n, 3), np.float32), np.zeros((n, 3), np.float32)
    a, b = np.random.default_rng(0).random((2, _GEMM_SIZE, _GEMM_SIZE), np.float32)
    for _ in sys.stdin:
        found = {"gemm": cpu_ns(lambda: a @ b) / (2 * _GEMM_SIZE**3)}
        for name, batch in batches.items():
            found[name] = cpu_ns(partial(evaluate, *batch, out=out)) / n
        print(json.dumps(found), flush=True)


def load_batches(path: str) -> dict[str, tuple[NDArray[np.float32], ...]]:
    batches: dict[str, tuple[NDArray[np.float32], ...]] = {}
    with np.load(path) as arrays:
        for key in arrays:  # in the order of the arguments
            name = key.partition("/")[0]
            batches[name] = (*batches.get(name, ()), arrays[key])
    return batches


def cpu_ns(action: Callable[[], object]) -> int:
    """CPU time of this thread in a call."""
    start = time.thread_time_ns()
    action()
    return time.thread_time_ns() - start


if __name__ == "__main__":
    main()

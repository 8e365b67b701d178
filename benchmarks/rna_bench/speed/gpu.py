"""Queries/s on a GPU and on the CPU runtime, with flop and bytes per query for a roofline.

    rna-bench gpu examples/quickstart/toy.rna examples/fibers/curly_ball.rna \
        --out benchmarks/results/gpu.json

One run, alternating; medians. Arithmetic counts multiply-adds of the decoder twice, and those of
the bilinear lookups; bytes are those of texels, row and result, without caches. Weights are read
once a workgroup at best, and once a query at worst: both are given.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import rna_gpu
from rna_bench.bench_options import add_out
from rna_bench.one_part import load_one_part
from rna_bench.results import publish
from rna_bench.speed.query_batches import random_queries
from rna_gpu import Device, GpuAsset

TEXELS = 12  # that a query reads
ROW, RESULT, GROUP = 64, 32, 64  # bytes, bytes, threads


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("packages", nargs="+", type=Path, help="of one part each")
    parser.add_argument("--rows", type=int, default=32_768, help="queries per run")
    parser.add_argument("--runs", type=int, default=5, help="runs of each")
    parser.add_argument("--threads", type=int, default=None, help="of the CPU (default: all)")
    add_out(parser)


def run(args: argparse.Namespace) -> None:
    device = rna_gpu.open_device()
    measured = [measure(path, device, args.rows, args.runs, args.threads) for path in args.packages]
    result = {"gpu": device.name, "rows": args.rows, "packages": measured}
    publish(result, args)


def measure(
    path: Path, device: Device, rows: int, runs: int, threads: int | None
) -> dict[str, Any]:
    """One package of one part, in its first tier."""
    cpu = load_one_part(path, threads=threads)
    gpu = rna_gpu.load(path, device=device)
    assert not isinstance(gpu, GpuAsset)
    arguments = random_queries(cpu, rows)
    calls: dict[str, Callable[[], object]] = {
        "gpu": lambda: gpu.evaluate(*arguments),
        "cpu": lambda: cpu.evaluate(*arguments),
    }
    seconds: dict[str, list[float]] = {name: [] for name in calls}
    for run in range(runs + 1):  # the first one compiles
        for name, call in calls.items():
            start = time.perf_counter()
            call()
            if run:
                seconds[name].append(time.perf_counter() - start)
    rates = {name: rows / float(np.median(values)) for name, values in seconds.items()}
    return {
        "package": path.name,
        "tier": cpu.tier.name,
        "queries_per_second": {name: round(rate) for name, rate in rates.items()},
        "gpu_over_cpu": round(rates["gpu"] / rates["cpu"], 4),
        "per_query": _cost(gpu, cpu),
    }


def _cost(gpu: Any, cpu: Any) -> dict[str, float]:
    part = gpu.tier_part
    texel = part.channels * {"int8": 1, "float16": 2, "float32": 4}[part.plane_precision]
    arithmetic = 2 * gpu.multiply_adds + TEXELS * 2 * part.channels
    streamed = TEXELS * texel + ROW + RESULT
    weights = 4 * gpu.multiply_adds
    return {
        "multiply_adds": gpu.multiply_adds,
        "flop": arithmetic,
        "bytes_streamed": streamed,
        "bytes_with_weights_once_a_workgroup": streamed + weights / GROUP,
        "bytes_with_weights_once_a_query": streamed + weights,
        "flop_per_byte": round(arithmetic / (streamed + weights / GROUP), 1),
    }

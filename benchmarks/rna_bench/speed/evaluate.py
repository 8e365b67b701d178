"""Speed of an asset's `evaluate` against the machine's own float32 matrix product.

    rna-bench evaluate --widths 64 --out evaluate.json
    rna-bench evaluate --widths 64 128 256 512 --precisions float32 int8

Prints JSON, one record a decoder width. Matrix products and evaluations alternate in one run, both
on all cores the process may use, and medians are compared; so `share_of_gemm` is comparable between
idle machines. The packages hold random weights.
"""

import argparse
import tempfile
from collections.abc import Callable
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.bench_options import add_out
from rna_bench.matrix_product import GEMM_FLOP, matrix_product
from rna_bench.one_part import OnePart, load_one_part
from rna_bench.results import publish
from rna_bench.speed.query_batches import Arrays, random_points, sphere_scan
from rna_bench.speed.random_package import HIDDEN_LAYERS, INPUTS, write_random_package
from rna_export.export.precision import PRECISIONS
from rna_export.machine import seconds_of

_CHANNELS, _SECONDS, _REPEATS = 8, 0.3, 9
"""Features per texel; about the time of an evaluation; evaluations, of which the median counts."""


def run(args: argparse.Namespace) -> None:
    report: dict[str, Any] = {
        "planes": [3, args.resolution, args.resolution, _CHANNELS],
        "inputs": INPUTS,
        "hidden_layers": HIDDEN_LAYERS,
        "repeats": _REPEATS,
        "widths": [measure(width, args) for width in args.widths],
    }
    publish(report, args)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--widths", type=int, nargs="+", default=[16, 32, 64, 128, 256, 512], help="decoder widths"
    )
    parser.add_argument(
        "--precisions", nargs="+", choices=list(PRECISIONS), default=["float32"], help="of tiers"
    )
    parser.add_argument("--resolution", type=int, default=512, help="texels along a plane's side")
    add_out(parser)


def measure(width: int, args: argparse.Namespace) -> dict[str, Any]:
    """The record of one decoder width."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "random.rna"
        write_random_package(path, width, args.resolution, _CHANNELS)
        assets = {name: load_one_part(path, name) for name in args.precisions}
        asset = next(iter(assets.values()))
        n = batch_size(asset)
        batches = {"random": random_points(n), "coherent": sphere_scan(n)}
        gemm, rates = alternate(assets, batches)
        columns = asset.tier_part.query_width
        flop = 2 * sum(a * b for a, b in pairwise([columns, *[width] * HIDDEN_LAYERS, 6]))
        records: dict[str, Any] = {precision: {} for precision in assets}
        for (precision, name), rate in rates.items():
            records[precision][name] = {
                "evaluate_mqueries_s": round(rate / 1e6, 3),
                "evaluate_gflops": round(rate * flop / 1e9, 1),
                "share_of_gemm": round(rate * flop / 1e9 / gemm, 3),
                "times_first": round(rate / rates[args.precisions[0], name], 2),
            }
    return {
        "width": width,
        "threads": asset.threads,
        "queries": n,
        "gemm_gflops": round(gemm, 1),
        **records,
    }


def batch_size(asset: OnePart) -> int:
    """A number of queries that takes about _SECONDS."""
    trial = random_points(65_536)
    asset.evaluate(*trial)
    rate = len(trial[0]) / seconds_of(lambda: asset.evaluate(*trial))
    return int(np.clip(rate * _SECONDS, 16_384, 2**22))


def alternate(
    assets: dict[str, OnePart], batches: dict[str, Arrays]
) -> tuple[float, dict[tuple[str, str], float]]:
    """GFLOP/s of the matrix product, and queries/s of each asset and batch, by their names.

    Medians of alternating runs.
    """
    product = matrix_product()
    size = len(next(iter(batches.values()))[0])
    results = np.zeros((size, 3), np.float32), np.zeros((size, 3), np.float32)
    gemm: list[float] = []
    rates: dict[tuple[str, str], list[float]] = {(p, b): [] for p in assets for b in batches}
    for _ in range(_REPEATS + 1):  # the first run warms caches and threads
        gemm.append(GEMM_FLOP / 1e9 / product())
        for precision, name in rates:
            asset, batch = assets[precision], batches[name]
            evaluate: Callable[..., object] = asset.evaluate
            taken = seconds_of(partial(evaluate, *batch, out=results))
            rates[precision, name].append(len(batch[0]) / taken)
    return float(np.median(gemm[1:])), {k: float(np.median(v[1:])) for k, v in rates.items()}

"""Speed of `evaluate` in this checkout against another one, alternating in one run.

    git worktree add ../before v1.1
    rna-bench evaluate-against ../before --widths 16 32 64 128 --out before-after.json

Prints JSON. Both answer the same queries of the same packages of random weights, with a matrix
product beside each evaluation. All of it on one thread, and by the CPU time of that thread, which
other work on the machine changes less than it does the clock; medians of alternating runs.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.bench_options import add_out, add_repeats
from rna_bench.checkout import ROOT
from rna_bench.one_part import load_one_part
from rna_bench.results import publish
from rna_bench.speed.query_batches import arguments_of, random_points, sphere_scan
from rna_bench.speed.random_package import HIDDEN_LAYERS, INPUTS, write_random_package
from rna_sdk.package import query_width
from rna_sdk.package.manifest.manifest_fields import Kind

Figures = dict[str, Any]


def run(args: argparse.Namespace) -> None:
    report: Figures = {
        "planes": [3, args.resolution, args.resolution, args.channels],
        "hidden_layers": HIDDEN_LAYERS,
        "threads": 1,
        "queries": args.queries,
        "repeats": args.repeats,
        "records": [measure(kind, width, args) for kind in args.kinds for width in args.widths],
    }
    publish(report, args)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("before", type=Path, help="the other checkout")
    parser.add_argument(
        "--kinds", nargs="+", choices=list(INPUTS), default=list(INPUTS), help="of assets"
    )
    parser.add_argument(
        "--widths", type=int, nargs="+", default=[16, 32, 64, 128], help="of the decoders"
    )
    parser.add_argument("--resolution", type=int, default=512, help="texels along a plane's side")
    parser.add_argument("--channels", type=int, default=8, help="features per texel")
    parser.add_argument("--queries", type=int, default=131_072, help="of one evaluation")
    add_repeats(parser)
    add_out(parser)


def measure(kind: Kind, width: int, args: argparse.Namespace) -> Figures:
    """The record of one decoder width of one kind of asset."""
    checkouts = {"before": args.before.resolve(), "after": ROOT}
    with tempfile.TemporaryDirectory() as folder:
        package, batches = Path(folder) / "random.rna", Path(folder) / "batches.npz"
        write_random_package(package, kind, width, args.resolution, args.channels)
        write_batches(batches, package, args.queries)
        workers = {k: start_worker(path, package, batches) for k, path in checkouts.items()}
        try:
            runs = [{k: ask(w) for k, w in workers.items()} for _ in range(args.repeats + 1)]
        finally:
            for worker in workers.values():
                worker.communicate()
    sizes = [query_width(INPUTS[kind], args.channels), *[width] * HIDDEN_LAYERS, 6]
    flop = 2 * sum(a * b for a, b in pairwise(sizes))
    records = {name: batch_record(name, runs[1:], flop) for name in ("random", "coherent")}
    return {"kind": kind, "width": width, **records}


def write_batches(path: Path, package: Path, queries: int) -> None:
    asset = load_one_part(package)
    batches = {"random": random_points(queries), "coherent": sphere_scan(queries)}
    arrays = {
        f"{name}/{k}": array
        for name, points in batches.items()
        for k, array in enumerate(arguments_of(asset, points))
    }
    np.savez(path, allow_pickle=False, **arrays)


def batch_record(batch: str, runs: list[dict[str, Figures]], flop: int) -> Figures:
    """Medians of one batch over the runs; the first run, which warms caches, is not among them."""
    record: Figures = {}
    for name in ("before", "after"):
        ns = float(np.median([run[name][batch] for run in runs]))
        share = np.median([run[name]["gemm"] * flop / run[name][batch] for run in runs])
        record[name] = {"share_of_gemm": round(float(share), 3), "ns_per_query": round(ns, 1)}
    ratios = [run["before"][batch] / run["after"][batch] for run in runs]
    record["times_as_fast"] = round(float(np.median(ratios)), 2)
    return record


def start_worker(checkout: Path, package: Path, batches: Path) -> subprocess.Popen[str]:
    threads = dict.fromkeys(("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "OMP_NUM_THREADS"), "1")
    paths = [str(checkout), str(ROOT / "benchmarks"), os.environ.get("PYTHONPATH", "")]
    environment = {**os.environ, **threads, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
    module = "rna_bench.speed.evaluate_worker"
    command = [sys.executable, "-P", "-m", module, *map(str, (checkout, package, batches))]
    pipe = subprocess.PIPE
    return subprocess.Popen(command, stdin=pipe, stdout=pipe, env=environment, text=True)


def ask(worker: subprocess.Popen[str]) -> Figures:
    assert worker.stdin is not None and worker.stdout is not None
    worker.stdin.write("go\n")
    worker.stdin.flush()
    result: Figures = json.loads(worker.stdout.readline())
    return result

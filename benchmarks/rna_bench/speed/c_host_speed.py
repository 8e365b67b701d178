"""Speed of the C host against the runtime, per thread, on the same queries.

    rna-bench c-host --out benchmarks/results/c-host.json

Prints JSON: ns/query of both, and the speedup of the C host over the runtime. Both run on one
thread; runs alternate and medians are compared. The decoders have four hidden layers, the planes
are 256 x 256 x 8 in float16, the inputs are every block of a surface. Needs a C compiler.
"""

from __future__ import annotations

import argparse
import statistics
import tempfile
import time
from pathlib import Path
from typing import Any

from rna_bench.bench_options import add_out, add_repeats
from rna_bench.checkout import CURLS, TOY
from rna_bench.one_part import load_one_part
from rna_bench.results import publish
from rna_bench.speed.query_batches import random_queries
from tests.hosts.c_host import CAsset, build
from tests.hosts.packages import make_profile_tier, write_profile_package

LAYERS = 4


def run(args: argparse.Namespace) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (library,) = build(folder, "librna.so", arch=args.arch)
        cases = [(path, "small") for path in (TOY, CURLS)]
        for width in args.widths:
            path = write_package(folder / f"width-{width}.rna", width)
            cases += [(path, precision) for precision in ("float32", "int8")]
        report = {
            "flags": f"-std=c11 -O3 {args.arch} -fno-math-errno",
            "rows": args.rows,
            "repeats": args.repeats,
            "results": [compare(library, path, tier, args) for path, tier in cases],
        }
    publish(report, args)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--widths", type=int, nargs="+", default=[16, 64, 128], help="of layers")
    parser.add_argument("--rows", type=int, default=100_000, help="queries per run")
    parser.add_argument("--arch", default="-march=x86-64-v3", help="option of the C compiler")
    add_repeats(parser)
    add_out(parser)


def write_package(path: Path, width: int) -> Path:
    """A package with a tier in float32 and one in int8."""
    tiers = [
        make_profile_tier(name, "surface", resolution=256, channels=8, decoder_precision=name)
        for name in ("float32", "int8")
    ]
    return write_profile_package(path, *tiers, widths=(width,) * LAYERS)


def compare(library: Path, path: Path, tier: str, args: argparse.Namespace) -> dict[str, Any]:
    """Median ns/query of both, on the same random queries."""
    runtime, host = load_one_part(path, tier, threads=1), CAsset(library, path, tier)
    rows = random_queries(runtime, args.rows)
    times: dict[str, list[float]] = {"runtime": [], "c": []}
    for _ in range(args.repeats + 1):  # the first run warms up
        for name, asset in (("runtime", runtime), ("c", host)):
            start = time.perf_counter()
            asset.evaluate(*rows)
            times[name].append((time.perf_counter() - start) / args.rows * 1e9)
    host.close()
    ours, theirs = (statistics.median(times[name][1:]) for name in ("runtime", "c"))
    return {
        "package": path.stem,
        "tier": tier,
        "runtime_ns_per_query": round(ours, 1),
        "c_ns_per_query": round(theirs, 1),
        "c_queries_per_runtime_query": round(ours / theirs, 3),
    }

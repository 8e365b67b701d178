"""Whether images depend on the number of threads: fresh processes, compared bit by bit.

    rna-bench threads examples/*/scene.yaml --repeats 10 --out benchmarks/results/threads.json

Each scene is rendered at each resolution by one thread, then by each number of threads in fresh
processes, half of which switch between Python threads every microsecond: what is made lazily by
several threads at once then shows. Numba gets as many threads as the largest number, on any
machine.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from rna_bench.bench_options import add_out
from rna_bench.results import publish
from rna_render import read_exr
from rna_sdk.errors import RnaError

SWITCH_INTERVAL = 1e-6
"""Seconds between switches of Python threads in a hurried process; Python's own are 5e-3."""

_RENDER = """
import sys
interval = float(sys.argv.pop(1))
if interval:
    sys.setswitchinterval(interval)
from rna_render.command.rna_run import main
sys.exit(main())
"""

Channels = dict[str, np.ndarray]


def run(args: argparse.Namespace) -> None:
    results = {}
    for scene in args.scenes:
        for resolution in args.resolutions:
            found = _compared(scene, resolution, args)
            results[f"{scene.parent.name}/{scene.name} {resolution}"] = found
            print(f"{scene} {resolution}: {found}", file=sys.stderr)
    wrong = sum(one["differing_runs"] for one in results.values())
    publish({"repeats": args.repeats, "differing_runs": wrong, "scenes": results}, args)
    if wrong:
        raise RnaError(f"{wrong} runs differ from one thread")


def rendered(
    scene: Path, threads: int, resolution: str, samples: int = 1, interval: float = 0.0
) -> Channels:
    """The channels of an image that a fresh `rna-run` process writes.

    resolution: WxH. interval: seconds between switches of Python threads; 0 for Python's own.
    Raises RnaError with what the process said where it fails.
    """
    with TemporaryDirectory() as folder:
        out = Path(folder) / "out.exr"
        how = ["--threads", str(threads), "--resolution", resolution, "--samples", str(samples)]
        done = subprocess.run(
            [sys.executable, "-c", _RENDER, str(interval), str(scene), "--out", str(out), *how],
            env={**os.environ, "NUMBA_NUM_THREADS": str(max(threads, os.cpu_count() or 1))},
            capture_output=True,
            text=True,
        )
        if done.returncode:
            raise RnaError(
                f"{scene}, {threads} threads: exit status {done.returncode}, {done.stderr}"
            )
        return read_exr(out)[0]


def differing(found: Channels, expected: Channels) -> int:
    """Values of all channels that differ in any bit."""
    pairs = (
        (found[name].view(np.uint32), plane.view(np.uint32)) for name, plane in expected.items()
    )
    return sum(int(np.count_nonzero(a != b)) for a, b in pairs)


def _compared(scene: Path, resolution: str, args: argparse.Namespace) -> dict[str, Any]:
    expected = rendered(scene, 1, resolution, args.samples)
    counts = [
        differing(rendered(scene, threads, resolution, args.samples, interval), expected)
        for threads in args.threads
        for repeat in range(args.repeats)
        for interval in [SWITCH_INTERVAL * (repeat % 2)]
    ]
    wrong = sum(count > 0 for count in counts)
    return {"runs": len(counts), "differing_runs": wrong, "differing_values": max(counts)}


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("scenes", nargs="+", type=Path, metavar="SCENE", help="scene files")
    add(
        "--resolutions",
        nargs="+",
        default=["128x128", "320x180"],
        metavar="WxH",
        help="sizes of the images; one below 128x64 has a single band",
    )
    add("--threads", nargs="+", type=int, default=[1, 2, 4, 8], metavar="N", help="threads")
    add("--repeats", type=int, default=10, help="fresh processes for each number of threads")
    add("--samples", type=int, default=4, help="samples per pixel")
    add_out(parser)

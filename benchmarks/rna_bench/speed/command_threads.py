"""Processor time and threads of every command, over the threads that it was asked for.

    rna-bench command-threads --out benchmarks/results/command-threads.json

Runs each command of the SDK on the quickstart's asset, from its capture on, with one thread or
worker where it has such an option, else with as many as there are cores. Prints a table, and JSON:
processor seconds over wall seconds and threads asked for, where more than 1 shows a pool of threads
that nobody asked for, and the largest number of threads that existed at a time. Takes 3 minutes;
needs an idle machine and Blender (`rna-capture --setup-blender`).
"""

from __future__ import annotations

import argparse
import resource
import subprocess
import sys
import tempfile
import time
import tomllib
from pathlib import Path
from typing import Any

from rna_bench.bench_options import add_out
from rna_bench.checkout import QUICKSTART, ROOT, TOY
from rna_bench.results import publish
from rna_sdk.cores import core_count
from rna_sdk.errors import RnaError
from rna_work.processor_time import process_threads

_SOURCE = ROOT / "examples" / "quickstart" / "toy.py"
_CAPTURE = ["--lights", "48", "--validation-views", "2", "--validation-resolution", "64"]
_APART = 0.05  # s between looks at the threads


def run(args: argparse.Namespace) -> None:
    scripts = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["scripts"]
    rows = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, (command, arguments, threads) in commands(Path(folder)).items():
            module = scripts[command].partition(":")[0]
            row = measured([sys.executable, "-m", module, *map(str, arguments)], threads)
            rows[name] = row
            told = f"{row['cores_a_thread']:.2f} cores a thread, {row['existing']} threads exist"
            print(f"{name:22} {threads} asked for: {told}", file=sys.stderr, flush=True)
    publish({"cores": core_count(), "commands": rows}, args)


def add_options(parser: argparse.ArgumentParser) -> None:
    add_out(parser)


def commands(folder: Path) -> dict[str, tuple[str, list[Any], int]]:
    """Name -> command, arguments, threads asked for; in an order in which each finds its input."""
    cores, rays, runs = core_count(), folder / "toy.rays", folder / "runs"
    package, made = folder / "toy.rna", folder / "made.rna"
    small = ["--resolution", "192x108", "--samples", 8]
    return {
        "rna-capture --workers 1": (
            "rna-capture",
            [_SOURCE, "--out", rays, "--workers", 1, *_CAPTURE],
            1,
        ),
        "rna-train": ("rna-train", [rays, "--out", runs, "--steps", 1500], cores),
        "rna-export": ("rna-export", [runs / "best.ckpt", "--out", package], cores),
        "rna-make --workers 1": (
            "rna-make",
            [_SOURCE, "--out", made, "--workers", 1, "--lights", 32, "--steps", 500, *_CAPTURE[2:]],
            cores,
        ),
        "rna-compare": (
            "rna-compare",
            [TOY, _SOURCE, "--out", folder / "compare", "--resolution", 96, "--samples", 4],
            cores,
        ),
        "rna-info": ("rna-info", [TOY], 1),
        "rna-validate": ("rna-validate", [TOY], 1),
        "rna-run --threads 1": (
            "rna-run",
            [QUICKSTART, "--out", folder / "one.exr", "--threads", 1, *small],
            1,
        ),
        "rna-run --threads 1 --denoise": (
            "rna-run",
            [QUICKSTART, "--out", folder / "clean.exr", "--threads", 1, "--denoise", *small],
            1,
        ),
        "rna-run": ("rna-run", [QUICKSTART, "--out", folder / "all.exr", *small], cores),
    }


def measured(command: list[str], threads: int) -> dict[str, float]:
    """Of a command that is run to its end. Raises RnaError if it fails."""
    before, begun, most = _spent(), time.perf_counter(), 0
    with tempfile.TemporaryFile() as told:
        process = subprocess.Popen(command, stdout=told, stderr=told)
        while process.poll() is None:
            most = max(most, process_threads(process.pid))
            time.sleep(_APART)
        took = time.perf_counter() - begun
        if process.returncode:
            told.seek(0)
            raise RnaError(f"{' '.join(command)}: {told.read().decode()[-500:]}")
    return {
        "threads": threads,
        "seconds": round(took, 2),
        "cores_a_thread": round((_spent() - before) / took / threads, 3),
        "existing": most,
    }


def _spent() -> float:
    """Processor time of all processes that this one has started and that have ended, s."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime

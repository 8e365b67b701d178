"""Throughput beside busy processes: trainer, rna-run, evaluate and capture.

    rna-bench busy --out benchmarks/results/busy.json

Prints a table, and JSON: what each does in a second, quiet and beside two and four loops that never
wait; as a share of quiet, and that over the share of the processor that a scheduler gives to one
thread a core beside so many loops: cores / (cores + loops). 1 loses nothing to waiting; the least
that is expected is 2/3. Takes 3 to 4 minutes on an idle machine, and means nothing on another. The
capture needs Blender: `rna-capture --setup-blender`; without it, the rest is measured.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from rna_bench.bench_options import add_out
from rna_bench.checkout import ROOT
from rna_bench.results import publish
from rna_bench.speed.busy_worker import WORK
from rna_sdk.cpu import core_count
from rna_sdk.errors import RnaError

_LOOP = "while True: pass"


def run(args: argparse.Namespace) -> None:
    cores, rows = core_count(), {}
    for name in args.work:
        try:
            rows[name] = measure(name, args.loops, args.seconds, cores)
        except RnaError as error:
            print(f"{name}: {error}", file=sys.stderr)
            continue
        print(line(name, rows[name]), file=sys.stderr, flush=True)
    publish({"cores": cores, "seconds": args.seconds, "work": rows}, args)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--loops", type=int, nargs="+", default=[2, 4], help="busy processes beside, each in turn"
    )
    parser.add_argument(
        "--seconds",
        type=float,
        default=12.0,
        help="time of a measurement, of which there is one for each work and number of loops",
    )
    parser.add_argument(
        "--work", nargs="+", choices=list(WORK), default=list(WORK), help="what is measured"
    )
    add_out(parser)


def measure(name: str, loops: list[int], seconds: float, cores: int) -> dict[str, Any]:
    """Rates of one kind of work, quiet first.

    Raises RnaError where it cannot be done here, such as a capture without Blender.
    """
    with worker(name) as process:
        quiet = ask(process, seconds)
        record: dict[str, Any] = {"unit": WORK[name], "quiet": round(quiet["rate"], 3)}
        for count in loops:
            with busy(count):
                found = ask(process, seconds)
            of_quiet = found["rate"] / quiet["rate"]
            share = cores / (cores + count)
            record[f"beside {count}"] = {
                "rate": round(found["rate"], 3),
                "of_quiet": round(of_quiet, 3),
                "share_of_processor": round(share, 3),
                "of_share": round(of_quiet / share, 3),
            }
    return record


def line(name: str, record: dict[str, Any]) -> str:
    """The record as a line of the table."""
    beside = [
        f"{key}: {value['of_quiet']:.0%} of it, {value['of_share']:.2f} of the share"
        for key, value in record.items()
        if key.startswith("beside")
    ]
    return f"{name:9} {record['quiet']:12,.1f} {record['unit']}; {'; '.join(beside)}"


@contextmanager
def busy(count: int) -> Iterator[None]:
    """So many processes that never wait, in the block."""
    loops = [subprocess.Popen([sys.executable, "-c", _LOOP]) for _ in range(count)]
    try:
        yield
    finally:
        for loop in loops:
            loop.kill()
            loop.wait()


@contextmanager
def worker(name: str) -> Iterator[subprocess.Popen[str]]:
    """A process that is ready for this work."""
    paths = os.pathsep.join([str(ROOT), str(ROOT / "benchmarks")])
    environment = {**os.environ, "PYTHONPATH": paths}
    command = [sys.executable, "-m", "rna_bench.speed.busy_worker", name]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, env=environment, text=True) as process:
        try:
            yield process
        finally:
            process.communicate()


def ask(process: subprocess.Popen[str], seconds: float) -> dict[str, float]:
    """The worker's next measurement."""
    assert process.stdin is not None and process.stdout is not None
    process.stdin.write(f"{seconds}\n")
    process.stdin.flush()
    answer = process.stdout.readline()
    if not answer:
        raise RnaError("the worker ended; its error is above")
    found: dict[str, float] = json.loads(answer)
    return found

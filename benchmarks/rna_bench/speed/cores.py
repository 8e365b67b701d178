"""Throughput of capture, training, rendering and queries by number of threads.

    rna-bench cores --out benchmarks/results/cores.json --picture cores.svg

Prints a table, and JSON: rates with 1, 2, 4, ... threads up to one a core, over as many times the
rate of one thread; processor seconds over wall seconds and threads, where more than 1 shows a pool
of threads that nobody asked for; the number of threads that exist. With one thread a core also the
rate beside busy processes, over its share of the processor: cores / (cores + loops). Each number
of threads has a process of its own and takes 2 minutes; the machine has to be idle. The capture
needs Blender (`rna-capture --setup-blender`); without it, the rest is measured.
"""

import argparse
import json
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from rna_bench.bench_options import add_out
from rna_bench.checkout import ROOT
from rna_bench.plot_style import figure, save_chart
from rna_bench.results import publish
from rna_bench.speed.core_worker import WORK
from rna_sdk.errors import RnaError
from rna_sdk.machine.cores import core_count
from rna_work.processor_time import process_seconds, process_threads

_LOOP = "while True: pass"
_LOOPS, _SECONDS = [2, 4], 8.0
"""Busy processes beside the work, each number in turn; time of a measurement."""
EFFICIENCY = 0.8
"""Least share of linear speed-up that captures, renders and queries must reach."""


def run(args: argparse.Namespace) -> None:
    cores, rows = core_count(), {}
    for name in args.work:
        try:
            rows[name] = measure(name, args.threads or _numbers(cores), _LOOPS, _SECONDS)
        except RnaError as error:
            print(f"{name}: {error}", file=sys.stderr)
            continue
        print("\n".join(lines(name, rows[name])), file=sys.stderr, flush=True)
    if args.picture is not None:
        draw(rows, args.picture)
    publish({"cores": cores, "seconds": _SECONDS, "work": rows}, args)


def add_options(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("--threads", type=int, nargs="+", metavar="N", help="counts (default: 1, 2, 4, ... cores)")
    add("--work", nargs="+", choices=list(WORK), default=list(WORK), help="workloads to measure")
    add("--picture", type=Path, help="chart of the rates (SVG or PNG, default: none)")
    add_out(parser)


def _numbers(cores: int) -> list[int]:
    """1, 2, 4, ... and the cores."""
    return sorted({*(1 << k for k in range(cores.bit_length()) if 1 << k <= cores), cores})


def measure(name: str, numbers: list[int], loops: list[int], seconds: float) -> dict[str, Any]:
    """Rates of one kind of work.

    Raises RnaError where it cannot be done here, such as a capture without Blender.
    """
    rows: list[dict[str, float]] = []
    record: dict[str, Any] = {"unit": WORK[name], "threads": rows}
    for threads in numbers:
        with worker(name, threads) as process:
            rows.append({"threads": threads, **_measured(process, threads, seconds)})
            rows[-1]["of_linear"] = round(
                rows[-1]["rate"] / rows[0]["rate"] * rows[0]["threads"] / threads, 3
            )
            for count in loops if threads == numbers[-1] else ():
                with busy(count):
                    result = _measured(process, threads, seconds)
                share = threads / (threads + count)
                of_share = round(result["rate"] / rows[-1]["rate"] / share, 3)
                record[f"beside {count}"] = {"rate": result["rate"], "of_share": of_share}
    return record


def lines(name: str, record: dict[str, Any]) -> list[str]:
    """The record as lines of the table."""
    lines = [
        f"{name:9} {row['threads']:3} threads {row['rate']:14,.1f} {record['unit']}, "
        f"{row['of_linear']:.0%} of linear, {row['cores_a_thread']:.2f} cores a thread, "
        f"{row['existing']} threads exist"
        for row in record["threads"]
    ]
    return lines + [
        f"{name:9} {key} busy processes: {value['of_share']:.2f} of its share"
        for key, value in record.items()
        if key.startswith("beside")
    ]


def draw(rows: dict[str, Any], path: Path) -> None:
    """Rates over those of one thread."""
    chart = figure(6.0, 4.0)
    axes = chart.subplots()
    most = max(row["threads"] for record in rows.values() for row in record["threads"])
    axes.plot([1, most], [1, most], color="0.6", lw=0.8, label="linear")
    axes.plot(
        [1, most],
        [1, EFFICIENCY * most],
        color="0.6",
        lw=0.8,
        ls=":",
        label=f"{EFFICIENCY:.0%} of it",
    )
    for name, record in rows.items():
        threads = [row["threads"] for row in record["threads"]]
        axes.plot(
            threads,
            [row["of_linear"] * row["threads"] for row in record["threads"]],
            "o-",
            label=name,
        )
    axes.set(
        xlabel="threads", ylabel="rate over the rate of one thread", xscale="log", yscale="log"
    )
    ticks = [1 << k for k in range(most.bit_length())]
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_ticks(ticks, [str(tick) for tick in ticks], minor=False)
        axis.set_ticks([], minor=True)
    axes.legend(frameon=False)
    save_chart(chart, path)


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
def worker(name: str, threads: int) -> Iterator[subprocess.Popen[str]]:
    """A process that is ready for this work."""
    paths = os.pathsep.join([str(ROOT), str(ROOT / "benchmarks")])
    environment = {**os.environ, "PYTHONPATH": paths}
    command = [sys.executable, "-m", "rna_bench.speed.core_worker", name, str(threads)]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, env=environment, text=True) as process:
        try:
            yield process
        finally:
            process.communicate()


def _measured(process: subprocess.Popen[str], threads: int, seconds: float) -> dict[str, float]:
    """The worker's next measurement."""
    assert process.stdin is not None and process.stdout is not None
    if not process.stdout.readline():  # that it is ready
        raise RnaError("the worker ended; its error is above")
    before, begun = process_seconds(process.pid) or 0.0, time.perf_counter()
    process.stdin.write(f"{seconds}\n")
    process.stdin.flush()
    answer = process.stdout.readline()
    if not answer:
        raise RnaError("the worker ended; its error is above")
    took = time.perf_counter() - begun
    spent = (process_seconds(process.pid) or 0.0) - before
    return {
        "rate": round(float(json.loads(answer)["rate"]), 3),
        "cores_a_thread": round(spent / took / threads, 3),
        "existing": process_threads(process.pid),
    }

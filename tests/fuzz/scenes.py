"""Mutated meshes, pictures and scene files through the readers of rna-run: none may crash.

    rna-bench fuzz-scenes --mutations 100000 --out benchmarks/results/fuzz-scenes.json

Mutations by number, of small glTF, GLB, OBJ, PLY, HDR, EXR, texture and YAML files. Each is read;
what is accepted is looked up, sampled and placed in a world. A failure is an exception that is not
of the project's, a value that is not finite, a message of several lines, more than --gigabytes or
SLOW_SECONDS, or a signal: batches run in processes of their own, and go on behind a crash.

Kernels are compiled with numba's bounds checks (NUMBA_BOUNDSCHECK, in a cache of its own), so that
an index outside an array is an IndexError. Kernels that read memory by address are not checked so;
they form their indices by the same functions. Decoders of others (OpenEXR, PIL) run as they are.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.bench_options import add_out
from rna_bench.results import publish, write_results
from rna_sdk.atomic_file import write_atomically

SLOW_SECONDS = 20
BATCH = 4000
_SHOWN = 40


def run(args: argparse.Namespace) -> int:
    started = time.monotonic()
    total: Counter[str] = Counter()
    failures: list[str] = []
    firsts = range(0, args.mutations, BATCH)
    with ThreadPoolExecutor(args.jobs) as pool:
        batches = [(first, min(BATCH, args.mutations - first)) for first in firsts]
        for counts, failed in pool.map(partial(run_batch, gigabytes=args.gigabytes), batches):
            total.update(counts)
            failures += failed
            report = _report(total, failures, time.monotonic() - started, args)
            if args.out is not None:  # what there is, should the run be stopped
                write_results(args.out, args.stamp, report)
    publish(report, args)
    return int(bool(failures))


def run_batch(batch: tuple[int, int], gigabytes: float) -> tuple[Counter[str], list[str]]:
    """Counts of verdicts by kind, and failures as "NUMBER KIND FILE: what"; in other processes."""
    (first, count), total = batch, Counter[str]()
    failures: list[str] = []
    with tempfile.TemporaryDirectory() as name:
        state, end = Path(name) / "state.json", first + count
        cache = Path(tempfile.gettempdir()) / f"rna-bounds-checked-{os.getuid()}"
        checked = {"NUMBA_BOUNDSCHECK": "1", "NUMBA_CACHE_DIR": str(cache)}
        threads = {"NUMBA_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
        while first < end:
            command = [sys.executable, "-m", "rna_bench.readers.fuzz_scenes"]
            command += [str(first), str(end), str(gigabytes), name]
            environment = {**os.environ, **checked, **threads}
            try:
                limit = 120 + SLOW_SECONDS * count
                done = subprocess.run(command, env=environment, capture_output=True, timeout=limit)
                ended, said = done.returncode, done.stderr.decode(errors="replace")
            except subprocess.TimeoutExpired:
                ended, said = -signal.SIGKILL, "no end"
            found: dict[str, Any] = {"at": first}
            if state.is_file():
                found = json.loads(state.read_text())
            total.update(found.get("counts", {}))
            failures += found.get("failures", [])
            if ended == 0:
                break
            failures.append(f"{found['at']} {found.get('file')}: ended by {ended}; {said[-300:]}")
            first = found["at"] + 1
            state.unlink(missing_ok=True)
    return total, failures


def mutations(first: int, end: int, folder: Path) -> Iterator[tuple[int, str, Path]]:
    """The numbers, kinds and files of mutations; each file is there until the next one."""
    from rna_bench.readers.scene_mutations import mutate
    from rna_bench.readers.scene_seeds import write_seeds

    seeds = write_seeds(folder)
    kinds = list(seeds)
    for number in range(first, end):
        rng = np.random.default_rng(number)
        kind = kinds[number % len(kinds)]
        source = seeds[kind][rng.integers(len(seeds[kind]))]
        path = folder / f"mutated-{os.getpid()}{source.suffix}"
        path.write_bytes(mutate(source.read_bytes(), source.suffix, rng))
        yield number, f"{kind}, {source.name}", path


def warm_up(folder: Path) -> None:
    """Checks all seeds, so that kernels are compiled."""
    from rna_bench.readers.scene_checks import check
    from rna_bench.readers.scene_seeds import write_seeds

    for kind, paths in write_seeds(folder).items():
        for path in paths:
            assert check(kind, path), path.name


def check_all(first: int, end: int, folder: Path, state: Path | None = None) -> dict[str, Any]:
    """Checks mutations; `state` has what there is, before each one that may crash."""
    from rna_bench.readers.scene_checks import check

    found: dict[str, Any] = {"counts": Counter(), "failures": []}
    signal.signal(signal.SIGALRM, _too_slow)
    for number, name, path in mutations(first, end, folder):
        found |= {"at": number, "file": name}
        if state is not None:
            write_atomically(state, json.dumps(found).encode())
        kind = name.partition(",")[0]
        try:
            signal.alarm(SLOW_SECONDS)
            accepted = check(kind, path)
        except BaseException as error:
            if isinstance(error, KeyboardInterrupt):
                raise
            cause = f" from {error.__cause__!r}" if error.__cause__ else ""
            found["failures"].append(f"{number} {name}: {error!r}{cause}"[:500])
            verdict = "failed"
        else:
            verdict = "accepted" if accepted else "refused"
        finally:
            signal.alarm(0)
        found["counts"][f"{kind} {verdict}"] += 1
    if state is not None:
        write_atomically(state, json.dumps(found).encode())
    return found


def _too_slow(*_: object) -> None:
    raise TimeoutError(f"more than {SLOW_SECONDS} s")


def _report(
    total: Counter[str], failures: list[str], seconds: float, args: argparse.Namespace
) -> dict[str, Any]:
    return {
        "mutations": sum(total.values()),
        "failures": len(failures),
        "first_failures": failures[:_SHOWN],
        "verdicts": dict(sorted(total.items())),
        "kernels": "NUMBA_BOUNDSCHECK=1",
        "gigabytes": args.gigabytes,
        "seconds": round(seconds),
        "processes": args.jobs,
    }


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--mutations", type=int, default=10_000, help="mutated files")
    parser.add_argument(
        "--gigabytes", type=float, default=3.0, help="memory of a process, beside its libraries"
    )
    parser.add_argument("--jobs", type=int, default=2, help="concurrent processes")
    add_out(parser)


def _main(first: int, end: int, gigabytes: float, folder: Path) -> None:
    from rna_bench.readers import scene_checks  # noqa: F401, loads all libraries

    size = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    limit = size + int(gigabytes * 2**30)
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    warm_up(folder)
    check_all(first, end, folder, folder / "state.json")


if __name__ == "__main__":
    _main(int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]), Path(sys.argv[4]))

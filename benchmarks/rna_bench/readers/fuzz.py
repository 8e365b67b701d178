"""Mutated packages through the C host and `rna_sdk.package.validate`: neither may crash.

    rna-bench fuzz --mutations 1000000 --out benchmarks/results/fuzz.json

Mutations by number, of small packages: surface and fiber, float32 and int8. The C host, under
AddressSanitizer and UBSan, opens each, and evaluates and traces what it accepts. The first
--validate of them go through the Python validator, too, and the verdicts are compared: packages
that one of the two accepts and the other refuses are counted by code. Needs a C compiler.
"""

from __future__ import annotations

import argparse
import ctypes
import json
import os
import signal
import subprocess
import tempfile
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from itertools import repeat
from pathlib import Path
from typing import Any

from rna_bench.options import add_out
from rna_bench.results import publish, write_results
from rna_sdk.package import Code, Severity, validate
from tests.hosts.c_host import build
from tests.hosts.packages import write_fuzz_packages

FLAGS = "-std=c11 -g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all"
SLOW_SECONDS = 20
_ROOM = 2**21
_CHUNK = 2000
_SHOWN = 20


@dataclass
class Verdicts:
    """Results of the validator, and its disagreements with the C host.

    Attributes:
        failures: "SEED: exception" where it raised, or took too long.
        disagreements: "python: CODES, C: CODES" -> seeds.
    """

    validated: int = 0
    accepted: int = 0
    failures: list[str] = field(default_factory=list)
    disagreements: dict[str, list[int]] = field(default_factory=dict)

    def add(self, other: Verdicts) -> None:
        self.validated += other.validated
        self.accepted += other.accepted
        self.failures += other.failures
        for codes, seeds in other.disagreements.items():
            self.disagreements.setdefault(codes, []).extend(seeds)


def run(args: argparse.Namespace) -> int:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        programs = build(args.build or folder, "fuzz", "libmutate.so")
        packages = write_fuzz_packages(folder)
        started = time.monotonic()
        with ProcessPoolExecutor(args.jobs) as pool:
            shared = repeat(programs[0]), repeat(packages), repeat(folder)
            chunks = [
                (first, min(_CHUNK, args.mutations - first))
                for first in range(0, args.mutations, _CHUNK)
            ]
            tallies = list(pool.map(run_c_host, *shared, chunks))
            seconds = time.monotonic() - started
            checked = [chunk for chunk in chunks if chunk[0] < args.validate]
            shared = repeat(programs[1]), repeat(packages), repeat(folder)
            verdicts = Verdicts()
            report = _report(tallies, verdicts, seconds, args.jobs)
            for part in pool.map(run_validator, *shared, checked):
                verdicts.add(part)
                report = _report(tallies, verdicts, seconds, args.jobs)
                if args.out is not None:  # what there is, should the run be stopped
                    write_results(args.out, args.stamp, report)
    publish(report, args)
    return int(report["reports"] > 0 or bool(verdicts.failures))


def run_c_host(
    program: Path, packages: list[Path], folder: Path, chunk: tuple[int, int]
) -> dict[str, Any]:
    """The program's tally of these mutations, and the report of a sanitizer, or None."""
    first, count = chunk
    command = [str(program), str(first), str(count), *map(str, packages)]
    command += ["--verdicts", str(folder / f"{first}.txt")]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode:
        return {"report": result.stderr[-4000:], "first": first}
    return {**json.loads(result.stdout), "report": None}


def run_validator(
    library: Path, packages: list[Path], folder: Path, chunk: tuple[int, int]
) -> Verdicts:
    """The same mutations through `validate`."""
    mutate = ctypes.CDLL(str(library)).rna_mutate
    mutate.restype = ctypes.c_size_t
    buffer = ctypes.create_string_buffer(_ROOM)
    data = [path.read_bytes() for path in packages]
    said = _verdicts_of_c_host(folder / f"{chunk[0]}.txt")
    path, result = folder / f"{os.getpid()}.rna", Verdicts()
    signal.signal(signal.SIGALRM, _too_slow)
    for seed in range(chunk[0], sum(chunk)):
        package = data[seed % len(data)]
        size = mutate(
            package, ctypes.c_size_t(len(package)), ctypes.c_uint64(seed), buffer,
            ctypes.c_size_t(_ROOM),
        )  # fmt: skip
        path.write_bytes(buffer.raw[:size])
        result.validated += 1
        try:
            signal.alarm(SLOW_SECONDS)
            codes = [issue.code for issue in validate(path)]
        except Exception as error:
            result.failures.append(f"{seed}: {error!r}")
            continue
        finally:
            signal.alarm(0)
        result.accepted += _accepts(codes)
        other = said.get(seed)
        if other is not None and _accepts(codes) != _accepts(other):
            key = f"python: {' '.join(codes) or 'valid'}, C: {' '.join(other) or 'valid'}"
            result.disagreements.setdefault(key, []).append(seed)
    return result


def _too_slow(*_: object) -> None:
    raise TimeoutError(f"more than {SLOW_SECONDS} s")


def _accepts(codes: list[str]) -> bool:
    return all(Code[code].severity is not Severity.ERROR for code in codes)


def _verdicts_of_c_host(path: Path) -> dict[int, list[str]]:
    """Seed -> codes; empty where the program ended at a report."""
    if not path.exists():
        return {}
    lines = (line.split() for line in path.read_text().splitlines())
    return {int(line[0]): line[1:] for line in lines}


def _report(
    tallies: list[dict[str, Any]], verdicts: Verdicts, seconds: float, jobs: int
) -> dict[str, Any]:
    done = [tally for tally in tallies if tally["report"] is None]
    refused: Counter[str] = Counter()
    for tally in done:
        refused.update(tally["refused"])
    broken = [tally["report"] for tally in tallies if tally["report"] is not None]
    known = sorted(verdicts.disagreements.items(), key=lambda item: -len(item[1]))
    return {
        "compiler_flags": FLAGS,
        "mutations": sum(tally["mutations"] for tally in done),
        "reports": len(broken),
        "first_reports": broken[:3],
        "accepted": sum(tally["accepted"] for tally in done),
        "tiers_evaluated": sum(tally["evaluated"] for tally in done),
        "tiers_that_need_an_engine": sum(tally["unsupported"] for tally in done),
        "refused": dict(refused.most_common()),
        "seconds": round(seconds),
        "processes": jobs,
        "python": {
            "mutations": verdicts.validated,
            "accepted": verdicts.accepted,
            "failures": verdicts.failures[:_SHOWN],
            "verdicts_that_differ": sum(len(seeds) for _, seeds in known),
            "by_codes": {codes: len(seeds) for codes, seeds in known[:_SHOWN]},
            "seeds": {codes: seeds[:5] for codes, seeds in known[:_SHOWN]},
        },
    }


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--mutations", type=int, default=20_000, help="mutations run through the C host"
    )
    parser.add_argument(
        "--validate",
        type=int,
        default=20_000,
        help="of these, also run through the Python validator",
    )
    parser.add_argument("--build", type=Path, help="folder to compile in (default: temporary)")
    parser.add_argument("--jobs", type=int, default=2, help="concurrent processes")
    add_out(parser)

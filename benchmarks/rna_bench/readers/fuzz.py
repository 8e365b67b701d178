"""Mutated packages through a reader, which may refuse them, but not crash.

    rna-bench fuzz --reader c-host --mutations 1000000 --out benchmarks/results/fuzz-1.1-c-host.json

Mutations by number, of small packages: `--seeds 1.0`, surface and fiber, float32 and int8; `1.1`,
parts, textures, normal maps, emission, quantised geometry, proxies, coded entries. Readers:

- `c-host`: the C host under AddressSanitizer and UBSan, each entry in a block of its own size; it
  evaluates and traces what it accepts;
- `python`: the validator and all that a package reads; verdicts are compared with the C host's;
- `viewer`: the reader of the viewer's page, in Node.

A run with the same --out goes on where the one before stopped. Needs a C compiler.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from collections import Counter
from hashlib import sha256
from pathlib import Path
from typing import Any

from rna_bench.bench_options import add_out
from rna_bench.readers.fuzz_readers import READERS, Mutations, Tally
from rna_bench.results import publish, write_results
from rna_sdk.errors import RnaError
from tests.hosts.c_host import build
from tests.hosts.packages import FUZZ_SEEDS

_PROGRAMS = ("fuzz", "mutations")
_CHUNK = 2000
_SHOWN = 20


def run(args: argparse.Namespace) -> int:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        programs = args.build or folder
        build(programs, *_PROGRAMS)
        packages = FUZZ_SEEDS[args.seeds](folder)
        seeds = {path.name: sha256(path.read_bytes()).hexdigest() for path in packages}
        tally, seconds = _done_before(args.out, args.reader, seeds)
        report = _report(args, seeds, tally, seconds)
        while tally.mutations < args.mutations:
            started = time.monotonic()
            count = min(_CHUNK, args.mutations - tally.mutations)
            mutations = Mutations(programs, packages)
            tally.add(READERS[args.reader](mutations, tally.mutations, count, folder))
            seconds += time.monotonic() - started
            report = _report(args, seeds, tally, seconds)
            if args.out is not None:  # what there is, should the run be stopped
                write_results(args.out, args.stamp, report)
    publish(report, args)
    return int(bool(tally.failures))


def _done_before(out: Path | None, reader: str, seeds: dict[str, str]) -> tuple[Tally, float]:
    """The tally of an earlier run on the same mutations, and its seconds."""
    if out is None or not out.exists():
        return Tally(), 0.0
    found = json.loads(out.read_text())
    if (found["reader"], found["seeds"]) != (reader, seeds):
        raise RnaError(f"{out} holds a run of another reader or of other packages")
    tally = Tally(found["mutations"], found["accepted"], Counter(found["refused"]))
    tally.failures, tally.disagreements = found["failures"], found["verdicts_that_differ"]
    return tally, found["seconds"]


def _report(
    args: argparse.Namespace, seeds: dict[str, str], tally: Tally, seconds: float
) -> dict[str, Any]:
    differ = sorted(tally.disagreements.items(), key=lambda item: -len(item[1]))
    return {
        "reader": args.reader,
        "version": args.seeds,
        "seeds": seeds,
        "mutations": tally.mutations,
        "failures": tally.failures[:_SHOWN],
        "failure_count": len(tally.failures),
        "accepted": tally.accepted,
        "refused": dict(tally.refused.most_common()),
        "verdicts_that_differ": dict(differ),
        "seconds": round(seconds),
    }


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--reader", choices=READERS, default="c-host", help="what reads them")
    parser.add_argument(
        "--seeds", choices=FUZZ_SEEDS, default="1.1", help="version whose contents are mutated"
    )
    parser.add_argument("--mutations", type=int, default=20_000, help="number of mutations")
    parser.add_argument("--build", type=Path, help="folder to compile in (default: temporary)")
    add_out(parser)

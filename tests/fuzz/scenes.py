"""Mutated meshes, pictures and scene files through the readers of rna-run: none may crash.

    NUMBA_BOUNDSCHECK=1 NUMBA_CACHE_DIR=/tmp/checked python -m tests.fuzz.scenes --count 100000

Mutations by number, of small glTF, GLB, OBJ, PLY, HDR, EXR, texture and YAML files. Each is read;
what is accepted is looked up, sampled and placed in a world. A failure is an exception that is not
of the project's, a value that is not finite, a message of several lines, or more than --gigabytes
or SLOW_SECONDS. A signal ends the run: the file is left in --folder, and `number` there has its
number; go on behind it with --first.

With NUMBA_BOUNDSCHECK an index outside an array is an IndexError in kernels, but for those that
read memory by address. Decoders of others (OpenEXR, PIL) run as they are.
"""

from __future__ import annotations

import argparse
import faulthandler
import resource
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tests.fuzz.mutations import mutate
from tests.fuzz.scene_checks import check
from tests.fuzz.scene_seeds import write_seeds
from tests.time_limit import time_limit

SLOW_SECONDS = 20


def mutations(first: int, end: int, folder: Path) -> Iterator[tuple[int, str, Path]]:
    """The numbers, kinds and files of mutations; each file is there until the next one."""
    seeds = write_seeds(folder)
    kinds = list(seeds)
    for number in range(first, end):
        rng = np.random.default_rng(number)
        kind = kinds[number % len(kinds)]
        source = seeds[kind][rng.integers(len(seeds[kind]))]
        path = folder / f"mutated{source.suffix}"
        path.write_bytes(mutate(source.read_bytes(), source.suffix, rng))
        yield number, f"{kind}, {source.name}", path


def warm_up(folder: Path) -> None:
    """Checks all seeds, so that kernels are compiled."""
    for kind, paths in write_seeds(folder).items():
        for path in paths:
            assert check(kind, path), path.name


def check_all(first: int, end: int, folder: Path) -> tuple[Counter[str], list[str]]:
    """Counts of "KIND VERDICT", and failures as "NUMBER KIND, FILE: what"."""
    counts, failures = Counter[str](), []
    for number, name, path in mutations(first, end, folder):
        (folder / "number").write_text(str(number))
        kind = name.partition(",")[0]
        try:
            with time_limit(SLOW_SECONDS):
                verdict = "accepted" if check(kind, path) else "refused"
        except Exception as error:
            cause = f" from {error.__cause__!r}" if error.__cause__ else ""
            failures.append(f"{number} {name}: {error!r}{cause}"[:500])
            verdict = "failed"
        counts[f"{kind} {verdict}"] += 1
    return counts, failures


def main() -> int:
    parser = argparse.ArgumentParser(
        "python -m tests.fuzz.scenes", description=(__doc__ or "").splitlines()[0]
    )
    parser.add_argument("--first", type=int, default=0, help="number of the first mutation")
    parser.add_argument("--count", type=int, default=10_000, help="number of mutations")
    parser.add_argument("--folder", type=Path, help="folder of the files (default: temporary)")
    parser.add_argument(
        "--gigabytes", type=float, default=3.0, help="memory of the process, beside its libraries"
    )
    args = parser.parse_args()
    faulthandler.enable()
    size = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    limit = size + int(args.gigabytes * 2**30)
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    folder = args.folder or Path(tempfile.mkdtemp(prefix="fuzz-"))
    folder.mkdir(exist_ok=True, parents=True)
    warm_up(folder)
    counts, failures = check_all(args.first, args.first + args.count, folder)
    print(dict(sorted(counts.items())), *failures, sep="\n")
    return int(bool(failures))


if __name__ == "__main__":
    sys.exit(main())

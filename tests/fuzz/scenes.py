"""Mutated files through the readers of rna-run and rna-train: none may crash.

    NUMBA_BOUNDSCHECK=1 NUMBA_CACHE_DIR=/tmp/checked python -m tests.fuzz.scenes --count 100000
    python -m tests.fuzz.scenes --kinds "glTF motions,motion files" --gigabytes 1 --count 100000

Mutations by number, of small glTF, GLB, OBJ, PLY, HDR, EXR, texture and YAML files, of motions,
checkpoints and manifests of datasets. Each is read; what is accepted is looked up, sampled and
placed in a world, or asked for its frames. A failure is an exception that is not
of the project's, a value that is not finite, a message of several lines, or more than --gigabytes
or SLOW_SECONDS. A signal ends the run: the file is left in --folder, and `number` there has its
number; go on behind it with --first.

With NUMBA_BOUNDSCHECK an index outside an array is an IndexError in kernels, except in those that
read memory by address. Decoders of others (OpenEXR, PIL) run as they are.
"""

import argparse
import faulthandler
import resource
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from tests.fuzz.motion_files import write_motions
from tests.fuzz.mutations import mutate
from tests.fuzz.scene_checks import check
from tests.fuzz.scene_seeds import write_seeds
from tests.fuzz.training_files import (
    CHECKPOINTS,
    MANIFESTS,
    mutate_checkpoint,
    write_training_files,
)
from tests.time_limit import time_limit

SLOW_SECONDS = 20


def seeds_of(folder: Path, kinds: Sequence[str] = ()) -> dict[str, list[Path]]:
    """Writes small valid files; kind -> paths, of these kinds or all."""
    seeds = write_seeds(folder) | write_motions(folder) | write_training_files(folder)
    return {kind: seeds[kind] for kind in kinds} if kinds else seeds


def mutations(
    first: int, end: int, seeds: dict[str, list[Path]]
) -> Iterator[tuple[int, str, Path]]:
    """The numbers, kinds and files of mutations; each file is there until the next one."""
    kinds = list(seeds)
    originals = {path: path.read_bytes() for paths in seeds.values() for path in paths}
    for number in range(first, end):
        rng = np.random.default_rng(number)
        kind = kinds[number % len(kinds)]
        source = seeds[kind][rng.integers(len(seeds[kind]))]
        # A manifest keeps its name: the dataset is around it.
        path = source if kind == MANIFESTS else source.with_name(f"mutated{source.suffix}")
        if kind == CHECKPOINTS:
            path.write_bytes(mutate_checkpoint(source, rng))
        else:
            path.write_bytes(mutate(originals[source], source.suffix, rng))
        yield number, f"{kind}, {source.name}", path


def warm_up(seeds: dict[str, list[Path]]) -> None:
    """Checks all seeds, so that kernels are compiled."""
    for kind, paths in seeds.items():
        for path in paths:
            assert check(kind, path), path.name


def check_all(
    first: int, end: int, folder: Path, seeds: dict[str, list[Path]]
) -> tuple[Counter[str], list[str]]:
    """Counts of "KIND VERDICT", and failures as "NUMBER KIND, FILE: what"."""
    counts, failures = Counter[str](), []
    for number, name, path in mutations(first, end, seeds):
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
    parser.add_argument("--kinds", default="", help="of files, with commas between (default: all)")
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
    seeds = seeds_of(folder, [kind.strip() for kind in args.kinds.split(",") if kind])
    warm_up(seeds)
    counts, failures = check_all(args.first, args.first + args.count, folder, seeds)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
    print(dict(sorted(counts.items())), f"peak memory {peak} MiB", *failures, sep="\n")
    return int(bool(failures))


if __name__ == "__main__":
    sys.exit(main())

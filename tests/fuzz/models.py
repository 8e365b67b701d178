"""Hostile models through Blender's importers and what a capture makes of them, before its rays.

    python -m tests.fuzz.models --count 200

The files that `model_seeds` names, then mutations by number. Each is opened in one Blender, which
is started anew when it has ended; its geometry and textures are exported and checked. A failure is
an exception that is not of the project's, a message of several lines or with a traceback, a script
that has run, or a file that is left outside of the capture's own folder.
"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import threading
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path

import numpy as np

from rna_export.capture.blender_process import blender_env
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.opened_source import OpenedSource
from rna_sdk.errors import RnaError
from tests.exporters.conftest import LentWorker
from tests.fuzz.model_seeds import write_hostile, write_models
from tests.fuzz.mutations import mutate

SECONDS = 60  # of processor time, for one file
GIGABYTES = 8  # of addresses, for Blender

ENDED = "ended without an answer"


class LimitedWorker(LentWorker):
    """Ends when a file takes too long or too much memory, as by a crash."""

    def _launch(self) -> subprocess.Popen[str]:
        process = super()._launch()
        limit = GIGABYTES * 2**30
        resource.prlimit(process.pid, resource.RLIMIT_AS, (limit, limit))
        return process

    @contextmanager
    def limited(self) -> Iterator[None]:
        """A context in which the process is killed after so much of its time."""
        done = threading.Event()

        def watch() -> None:
            begun: float | None = None
            while not done.wait(0.5):
                spent = self.processor_seconds() or 0.0
                begun = spent if begun is None else begun
                if spent - begun > SECONDS:
                    self.kill()

        watcher = threading.Thread(target=watch, daemon=True)
        watcher.start()
        try:
            yield
        finally:
            done.set()
            watcher.join()


def verdict_on(python: Path, path: Path, scratch: Path) -> tuple[str, str]:
    """Accepted, refused, ended (Blender was) or failed; and what was said."""
    worker = LimitedWorker(python, Source(path), scratch, 1)
    try:
        with worker.limited(), worker:
            OpenedSource.of(worker, {}, path.stem, None)
        return "accepted", ""
    except RnaError as error:
        said = str(error)
        if len(said.splitlines()) != 1 or "Traceback" in said or "\x1b" in said:
            return "failed", said
        return ("ended" if ENDED in said else "refused"), said
    except Exception as error:
        return "failed", repr(error)


def mutations(
    first: int, end: int, seeds: dict[str, list[Path]], kinds: Iterable[str] = ()
) -> Iterator[Path]:
    """Files by number, of each suffix in turn."""
    suffixes = list(kinds) or list(seeds)
    for number in range(first, end):
        rng = np.random.default_rng(number)
        suffix = suffixes[number % len(suffixes)]
        source = seeds[suffix][rng.integers(len(seeds[suffix]))]
        path = source.with_name(f"mutated-{number}{suffix}")
        path.write_bytes(mutate(source.read_bytes(), suffix, rng))
        yield path


def check_all(
    python: Path, paths: Iterable[Path], folder: Path, say: Callable[[str], None] = lambda _: None
) -> tuple[Counter[str], list[str]]:
    """Counts of "SUFFIX VERDICT", and a line for each file, which is said at once.

    folder: of the files.
    """
    counts, lines = Counter[str](), []
    home = folder / "home"
    home.mkdir(exist_ok=True)
    before = {name: os.environ.get(name) for name in ("TMPDIR", "HOME")}
    os.environ |= {"TMPDIR": str(home), "HOME": str(home)}
    known = _files(folder)
    try:
        for path in paths:
            known.add(path)
            verdict, said = verdict_on(python, path, folder / "scratch")
            left = sorted(str(each.relative_to(folder)) for each in _files(folder) - known)
            known |= _files(folder)
            if left:
                verdict, said = "failed", f"{verdict}, and wrote {left}: {said}"
            counts[f"{path.suffix} {verdict}"] += 1
            lines.append(f"{verdict} {path.name}: {said}")
            say(lines[-1])
    finally:
        LimitedWorker.end_idle()
        for name, value in before.items():
            os.environ.pop(name)
            if value is not None:
                os.environ[name] = value
    return counts, lines


def _files(folder: Path) -> set[Path]:
    """All but those in the folders that the capture and Blender have for themselves."""
    return {
        path
        for path in folder.rglob("*")
        if path.is_file()
        and not path.is_relative_to(folder / "scratch")
        and not any(part.startswith("blender_") for part in path.relative_to(folder).parts)
    }


def main() -> int:
    parser = argparse.ArgumentParser(
        "python -m tests.fuzz.models", description=(__doc__ or "").splitlines()[0]
    )
    parser.add_argument("--first", type=int, default=0, help="number of the first mutation")
    parser.add_argument("--count", type=int, default=200, help="number of mutations")
    parser.add_argument("--kinds", default="", help="suffixes, with commas between (default: all)")
    parser.add_argument("--mutations-only", action="store_true", help="leave out the named files")
    parser.add_argument("--folder", type=Path, help="folder of the files (default: temporary)")
    args = parser.parse_args()
    python = blender_env.find_python()
    folder = args.folder or Path(tempfile.mkdtemp(prefix="fuzz-"))
    seeds = write_models(python, folder)
    kinds = [kind for kind in args.kinds.split(",") if kind]
    paths = [] if args.mutations_only else write_hostile(folder)
    paths = [path for path in paths if not kinds or path.suffix in kinds]
    paths += mutations(args.first, args.first + args.count, seeds, kinds)
    counts, lines = check_all(python, paths, folder, partial(print, flush=True))
    print(*sorted(f"{count} {kind}" for kind, count in counts.items()), sep="\n")
    return int(any(line.startswith("failed") for line in lines))


if __name__ == "__main__":
    sys.exit(main())

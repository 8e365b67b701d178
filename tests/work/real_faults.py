"""Captures and renders on a cluster in which something is killed, hangs, or is full.

    python -m tests.work.real_faults --runs 50 --seed 1

Three nodes on this machine, real commands with real Blender. In each run, at a random moment, the
raylet of a node, a worker, or the command itself gets SIGKILL, a Blender stops answering, or the
disk is full. A command that ends with an error is started again. The result has to have the bytes
of one machine's, and files that were finished at that moment must not have been written again.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from tests.exporters.scenes import write_scene
from tests.render.assets import sphere
from tests.render.packages import write_lambert_package
from tests.render.test_sequence import SCENE
from tests.work.conftest import start_cluster

LIMIT = 900.0  # seconds of a run
MOST_HANG, FACTOR = 5.0, 4.0  # seconds that an item may take, or times as long as its fellows

BODY = "add(*BALL, principled(Roughness=0.3))\n"
SETTINGS = (
    "--lights 256 --rays 64 --samples 1 --validation-views 1 --validation-resolution 24 "
    "--validation-samples 4 --seed 3"
).split()


@dataclass(frozen=True)
class Kind:
    """A command that is tried. files: of what is finished, in its folder."""

    faults: tuple[str, ...]
    arguments: Callable[[Path, Path], list[str]]
    files: str
    count: int


def capture_arguments(inputs: Path, out: Path) -> list[str]:
    return ["capture", str(inputs / "ball.py"), "--out", str(out / "ball.rays"), *SETTINGS]


def frames_arguments(inputs: Path, out: Path) -> list[str]:
    return ["run", str(inputs / "moving.yaml"), "--frames", "all", "--out", str(out / "%02d.exr")]


def image_arguments(inputs: Path, out: Path) -> list[str]:
    return ["run", str(inputs / "still.yaml"), "--out", str(out / "still.exr")]


ALL = ("node", "worker", "driver", "full")
KINDS = {
    "capture": Kind((*ALL, "hang"), capture_arguments, "ball.rays/*/[0-9]*.safetensors", 10),
    "frames": Kind(ALL, frames_arguments, "*.exr", 16),
    "image": Kind(ALL, image_arguments, "still.exr.pieces/*.safetensors", 15),
}


def write_inputs(folder: Path) -> None:
    """What is captured and rendered."""
    write_scene(folder, "ball", BODY)
    write_lambert_package(folder / "ball.rna", sphere(4))
    moving = SCENE.replace("frames: 4", "frames: 16").replace("[12, 8]", "[200, 150]")
    (folder / "moving.yaml").write_text(moving.replace("samples: 4", "samples: 32"))
    still = SCENE.replace("[12, 8]", "[400, 300]").replace("samples: 4", "samples: 64")
    (folder / "still.yaml").write_text(still)


def command(arguments: list[str]) -> int:
    """What a user would run; a Blender that hangs is given up after seconds, not minutes."""
    from rna_export.capture import capture_run as run
    from rna_export.capture import rna_capture as cli
    from rna_render.command.rna_run import main as render
    from rna_work import timeouts

    timeouts._FACTOR = FACTOR
    run.Timeouts = partial(timeouts.Timeouts, least=MOST_HANG)
    name, *rest = arguments
    return {"capture": cli.main, "run": render}[name](rest)


class Trial:
    """One run of a command in a folder. small: the folder is a disk of its own, which can fill."""

    def __init__(self, kind: Kind, address: str, inputs: Path, folder: Path, log: Path) -> None:
        self._kind, self._address, self._inputs = kind, address, inputs
        self.folder, self._log = folder, log

    def start(self) -> subprocess.Popen[bytes]:
        arguments = [*self._kind.arguments(self._inputs, self.folder), "--cluster", self._address]
        program = [sys.executable, "-m", "tests.work.real_faults", "--command", *arguments]
        with self._log.open("ab") as log:
            return subprocess.Popen(program, stdout=log, stderr=log, start_new_session=True)

    def finished(self) -> dict[Path, tuple[int, int]]:
        """What is finished, and by which file."""
        actual = {}
        for path in self.folder.glob(self._kind.files):
            with contextlib.suppress(FileNotFoundError):
                actual[path] = (path.stat().st_ino, path.stat().st_mtime_ns)
        return actual

    def tail(self) -> str:
        return self._log.read_text(errors="replace")[-1500:]


def one_run(cluster: Any, fault: str, dice: random.Random, trial: Trial, count: int) -> None:
    """Raises AssertionError where the command does not come to its end, or does a thing twice."""
    deadline = time.monotonic() + LIMIT
    process, moment = trial.start(), dice.randrange(0, count - 3)
    while process.poll() is None and len(trial.finished()) < moment:
        assert time.monotonic() < deadline, f"nothing goes on: {trial.tail()}"
        time.sleep(0.02)
    time.sleep(dice.random())
    assert process.poll() is None, f"ended before anything was done to it: {trial.tail()}"
    done = trial.finished()
    act(cluster, fault, dice, trial, process)
    for _ in range(3):
        status = process.wait(timeout=max(1.0, deadline - time.monotonic()))
        if status == 0:
            break
        assert fault in ("driver", "full"), f"status {status}: {trial.tail()}"
        process = trial.start()
    if fault == "node":
        cluster.add_node(num_cpus=1)
    assert status == 0, trial.tail()
    now = trial.finished()
    again = [path.name for path in done if path in now and now[path] != done[path]]
    assert not again, f"written twice: {again}"


def act(
    cluster: Any, fault: str, dice: random.Random, trial: Trial, process: subprocess.Popen[bytes]
) -> None:
    """Let something go wrong."""
    if fault == "node":
        victims = [node for node in cluster.list_all_nodes() if node is not cluster.head_node]
        cluster.remove_node(dice.choice(victims), allow_graceful=False)
    elif fault == "driver":
        process.kill()
    elif fault == "full":
        fill(trial.folder, dice)
    elif fault == "worker":
        kill_one(dice, "ray::_Actor", signal.SIGKILL)
    elif fault == "hang":
        kill_one(dice, "blender/worker.py", signal.SIGSTOP)


def kill_one(dice: random.Random, name: str, how: signal.Signals) -> None:
    """Of the processes below this one whose command has the name; waits for the first."""
    for _ in range(600):
        actual = [pid for pid in below(os.getpid()) if name in command_of(pid)]
        if actual:
            os.kill(dice.choice(actual), how)
            return
        time.sleep(0.1)
    raise AssertionError(f"no {name} was started")


def below(pid: int) -> Iterator[int]:
    """Processes that a process and those below it have started."""
    for task in Path(f"/proc/{pid}/task").glob("*/children"):
        with contextlib.suppress(OSError):
            for child in map(int, task.read_text().split()):
                yield child
                yield from below(child)


def command_of(pid: int) -> str:
    try:
        return Path(f"/proc/{pid}/cmdline").read_text().replace("\0", " ")
    except OSError:
        return ""


def fill(disk: Path, dice: random.Random) -> None:
    """Leave no room on a disk for a while."""
    ballast = disk / "ballast"
    with ballast.open("wb", buffering=0) as file, contextlib.suppress(OSError):
        while True:
            file.write(bytes(4096))
    time.sleep(5.0 + 5.0 * dice.random())
    ballast.unlink()


@contextlib.contextmanager
def disk(wanted: bool) -> Iterator[Path]:
    """A folder; a disk of its own if wanted, of 40 MB, for which one has to be root."""
    folder = Path(tempfile.mkdtemp(prefix="rna-faults-"))
    if wanted:
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=40m", "none", folder], check=True)
    try:
        yield folder
    finally:
        if wanted:
            subprocess.run(["umount", "--lazy", folder], check=True)
        shutil.rmtree(folder)


def contents(folder: Path) -> dict[str, bytes]:
    files = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def expected(kind: Kind, inputs: Path, folder: Path) -> dict[str, bytes]:
    """What one machine makes."""
    folder.mkdir()
    assert command(kind.arguments(inputs, folder)) == 0
    return contents(folder)


def check(actual: dict[str, bytes], wanted: dict[str, bytes]) -> None:
    assert actual.keys() == wanted.keys(), sorted(actual.keys() ^ wanted.keys())
    other = [name for name in actual if actual[name] != wanted[name]]
    assert not other, f"other bytes: {other}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=50)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS))
    parser.add_argument("--faults", nargs="+", choices=(*ALL, "hang"), default=[*ALL, "hang"])
    parser.add_argument("--command", nargs=argparse.REMAINDER, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.command:
        return command(options.command)
    base = Path(tempfile.mkdtemp(prefix="rna-faults-"))
    write_inputs(base)
    wanted = {name: expected(KINDS[name], base, base / name) for name in options.kinds}
    dice, failed = random.Random(options.seed), 0
    pairs = [(k, f) for k in options.kinds for f in KINDS[k].faults if f in options.faults]
    cluster = start_cluster()
    for run in range(options.runs):
        name, fault = pairs[run % len(pairs)]
        began, kind = time.monotonic(), KINDS[name]
        with disk(fault == "full") as folder:
            trial = Trial(kind, cluster.address, base, folder, base / f"{run}.log")
            try:
                one_run(cluster, fault, dice, trial, kind.count)
                check(contents(folder), wanted[name])
                said = "nothing lost"
            except (AssertionError, OSError, subprocess.TimeoutExpired) as error:
                failed, said = failed + 1, f"FAILED: {error!r:.2500}"
        print(f"{run + 1} {name} {fault}: {said} ({time.monotonic() - began:.0f} s)", flush=True)
    cluster.shutdown()
    shutil.rmtree(base)
    print(f"{options.runs - failed} of {options.runs} runs without loss")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())

"""Runs of long work on a cluster in which something is killed, or hangs, at a random moment.

    python -m tests.work.faults --runs 50 --seed 1

Three nodes on this machine. In each run stand-ins for captures write files; at random moments the
raylet of a node, a worker, or the command itself gets SIGKILL, a worker hangs, or a disk is full.
Every file has to be there with the right bytes, and none may have been made twice.
"""

import argparse
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from rna_work.backend import Needs
from rna_work.executors import open_executor
from rna_work.pool import Pool
from rna_work.timeouts import Timeouts
from tests.work.conftest import start_cluster
from tests.work.workers import Writing

FAULTS = ("node", "worker", "driver", "hang", "full")
ITEMS, SECONDS = 40, 0.2


def command(address: str, folder: Path, items: int, seconds: float) -> None:
    """What a user would run: makes the files that are missing."""
    missing = [k for k in range(items) if not (folder / f"{k:05d}.bin").is_file()]
    make = partial(Writing, folder, seconds)
    with open_executor(address) as executor:
        backend = executor.workers(Needs("processes"), None)
        timeouts = Timeouts(least=3.0)
        with Pool(backend, make, attempts=3, timeouts=timeouts, tell=print) as pool:
            for outcome in pool.run(missing):
                outcome.value()


def one_run(cluster: Any, fault: str, dice: random.Random, folder: Path) -> None:
    """Raises AssertionError where something was lost or done twice."""
    if fault in ("hang", "full"):
        (folder / f"{fault}-{dice.randrange(5, ITEMS)}").touch()
    process = start(cluster.address, folder)
    deadline = time.monotonic() + 240.0
    moment = dice.randrange(1, ITEMS - 5)  # finished files
    while process.poll() is None and len(list(folder.glob("*.bin"))) < moment:
        assert time.monotonic() < deadline, "nothing goes on"
        time.sleep(0.01)
    if fault == "node":
        victims = [node for node in cluster.list_all_nodes() if node is not cluster.head_node]
        cluster.remove_node(dice.choice(victims), allow_graceful=False)
    elif fault == "worker":
        kill_a_worker(folder, dice)
    elif fault == "driver":
        process.kill()
        process.wait()
        process = start(cluster.address, folder)
    status = process.wait(timeout=max(1.0, deadline - time.monotonic()))
    if fault == "node":
        cluster.add_node(num_cpus=1)
    assert status == 0, (folder / "out").read_text()[-2000:]
    check(folder)


def start(address: str, folder: Path) -> subprocess.Popen[bytes]:
    """The command in a process of its own."""
    arguments = [sys.executable, "-m", "tests.work.faults", "--command", address, str(folder)]
    with (folder / "out").open("a") as out:
        return subprocess.Popen(arguments, stdout=out, stderr=out, start_new_session=True)


def kill_a_worker(folder: Path, dice: random.Random) -> None:
    alive = [int(p.name) for p in (folder / "pids").iterdir() if Path("/proc", p.name).exists()]
    if alive:
        os.kill(dice.choice(alive), signal.SIGKILL)


def check(folder: Path) -> None:
    """All files are there, with the bytes that one machine would have written, each made once."""
    for number in range(ITEMS):
        data = (folder / f"{number:05d}.bin").read_bytes()
        assert data == np.random.default_rng(number).bytes(1000), f"file {number} is another"
    lines = Counter((folder / "log").read_text().split())
    twice = [number for number, times in lines.items() if times > 1]
    assert not twice, f"made twice: {twice}"
    assert not list(folder.glob("*.part"))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=50)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--command", nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.command:
        command(options.command[0], Path(options.command[1]), ITEMS, SECONDS)
        return 0
    dice, failed = random.Random(options.seed), 0
    cluster = start_cluster()
    for run in range(options.runs):
        fault = FAULTS[run % len(FAULTS)]
        began = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            try:
                one_run(cluster, fault, dice, Path(folder))
                said = "nothing lost"
            except (AssertionError, OSError, subprocess.TimeoutExpired) as error:
                failed, said = failed + 1, f"FAILED: {error!r:.500}"
        print(f"{run + 1} {fault}: {said} ({time.monotonic() - began:.0f} s)", flush=True)
    cluster.shutdown()
    print(f"{options.runs - failed} of {options.runs} runs without loss")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())

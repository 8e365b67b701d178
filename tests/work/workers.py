"""Workers for tests: what they do is in their items."""

import errno
import os
import signal
import threading
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_sdk.files.atomic_file import write_atomically


class Doubling:
    """Doubles numbers; strings are orders."""

    def __init__(self, name: str) -> None:
        self.name = name
        self._killed = threading.Event()

    def __enter__(self) -> "Doubling":
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, item: object) -> object:
        if item == "pid":
            return os.getpid()
        if item == "gpus":
            time.sleep(0.5)
            return os.environ.get("CUDA_VISIBLE_DEVICES")
        if item == "fail":
            raise ValueError("was told to fail")
        if item == "die":
            os.kill(os.getpid(), signal.SIGKILL)
        if item == "hang":
            self._killed.wait(60.0)
            raise ValueError("was killed")
        if item == "slow":  # a little of the processor, for six times the limit of its test
            for _ in range(60):
                time.sleep(0.02)
                _spin(0.001)
        if item == "circles":
            while not self._killed.is_set():
                _spin(0.01)
        if isinstance(item, float):
            time.sleep(item)
        return item * 2

    def kill(self) -> None:
        self._killed.set()


def _spin(seconds: float) -> None:
    """Use the processor for so long, by its own time."""
    until = time.thread_time() + seconds
    while time.thread_time() < until:
        pass


class CannotStart(Doubling):
    """Fails when it is entered."""

    def __enter__(self) -> Doubling:
        raise ValueError(f"worker {self.name} cannot start")


@dataclass(frozen=True)
class Once:
    """An item that goes wrong on its first attempt, which it marks with a file."""

    mark: Path
    how: str


class Repeating(Doubling):
    """Runs `Once` items: the first time as they say, then well."""

    def run(self, item: object) -> object:
        if not isinstance(item, Once):
            return super().run(item)
        if item.mark.exists():
            return "done"
        item.mark.touch()
        return super().run(item.how)


class Writing:
    """Writes a file for each number into a folder, as a capture does; a line in `log` for each.

    A number whose file is there is not written again. What goes wrong, on first attempts, stands in
    files `hang-N` and `full-N`.
    """

    def __init__(self, folder: Path, seconds: float, name: str) -> None:
        self._folder, self._seconds = folder, seconds

    def __enter__(self) -> "Writing":
        (self._folder / "pids").mkdir(exist_ok=True)
        (self._folder / "pids" / str(os.getpid())).touch()
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, number: int) -> int:
        path = self._folder / f"{number:05d}.bin"
        if path.exists():
            return number
        self._go_wrong(number)
        data = np.random.default_rng(number).bytes(1000)
        time.sleep(self._seconds * (0.5 + data[0] / 256.0))
        write_atomically(path, data)
        with (self._folder / "log").open("a") as log:
            log.write(f"{number}\n")
        return number

    def kill(self) -> None:
        pass

    def _go_wrong(self, number: int) -> None:
        for how in ("hang", "full"):
            try:
                (self._folder / f"{how}-{number}").unlink()
            except FileNotFoundError:
                continue
            if how == "full":
                raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
            time.sleep(1000.0)

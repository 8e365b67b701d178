"""Workers for tests: what they do is in their items."""

from __future__ import annotations

import os
import signal
import threading
import time
from dataclasses import dataclass
from pathlib import Path


class Doubling:
    """Doubles numbers; strings are orders."""

    def __init__(self, name: str) -> None:
        self.name = name
        self._killed = threading.Event()

    def __enter__(self) -> Doubling:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, item: object) -> object:
        if item == "pid":
            return os.getpid()
        if item == "fail":
            raise ValueError("was told to fail")
        if item == "die":
            os.kill(os.getpid(), signal.SIGKILL)
        if item == "hang":
            self._killed.wait(60.0)
            raise ValueError("was killed")
        if isinstance(item, float):
            time.sleep(item)
        return item * 2

    def kill(self) -> None:
        self._killed.set()


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

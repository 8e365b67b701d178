"""Trainings of rounds: in their turn, or on a GPU beside the captures."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Self


class Trainer:
    """Runs trainings, one after the other; a context.

    beside: whether each goes on while the caller does something else, until the next one.
    """

    def __init__(self, beside: bool) -> None:
        self._pool = ThreadPoolExecutor(1) if beside else None
        self._running: Future[None] | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._pool is not None:
            self._pool.shutdown()

    def run(self, train: Callable[[], None]) -> None:
        """Train, once the training before is finished, whose error this raises."""
        self.wait()
        if self._pool is None:
            train()
        else:
            self._running = self._pool.submit(train)

    def wait(self) -> None:
        """Return when nothing is trained any more. Raises the error of what was."""
        running, self._running = self._running, None
        if running is not None:
            running.result()

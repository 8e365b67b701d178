"""What a pool asks of threads, processes and Ray: slots, each of which holds one worker."""

from __future__ import annotations

from concurrent.futures import Future
from typing import Any, Protocol

from rna_work.workers import MakeWorker


class Slot(Protocol):
    """A slot for one worker.

    Attributes:
        name: of the worker.
        ready: done when the worker was entered, or could not be; its result names the node.
    """

    name: str
    ready: Future[str]

    def give(self, item: Any) -> Future[Any]:
        """Run an item after those given before. The future raises WorkerLost if the worker ends."""

    def processor_seconds(self) -> float | None:
        """Processor time of the worker and of what it started, s; None where nobody can tell."""

    def close(self, kill: bool) -> None:
        """End the worker, at once or after its items, and wait until it has ended."""


class Backend(Protocol):
    """Slots in which workers run.

    Attributes:
        losses: how often an item may lose its worker before it counts as failed.
    """

    losses: int

    def width(self) -> int:
        """Number of workers there is room for now."""

    def slot(self, make: MakeWorker, name: str) -> Slot:
        """Start a worker."""

"""What a worker needs, and what a pool asks of threads, processes and Ray: slots, each of which
holds one worker.
"""

from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any, Literal, Protocol

from rna_work.workers import MakeWorker


@dataclass(frozen=True)
class Needs:
    """Resources of a worker.

    local: what holds it there, where there is no cluster.
    """

    local: Literal["threads", "processes"]
    cpus: float = 1.0
    gpus: float = 0.0
    memory: int = 0  # bytes
    resource: str | None = None  # of a cluster: only nodes that have it, if any node does

    def __str__(self) -> str:
        gpus = f", {self.gpus:g} GPU" if self.gpus else ""
        memory = f", {self.memory / 1e9:.1f} GB" if self.memory else ""
        return f"{self.cpus:g} CPU{gpus}{memory}"


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
        """Processor time of the worker and its processes, s; None where nobody can tell."""

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

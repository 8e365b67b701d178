"""Workers, and the outcomes of their items."""

from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar, runtime_checkable

from rna_sdk.errors import WorkError

Item = TypeVar("Item")
Result = TypeVar("Result")


class Worker(Protocol):
    """Runs items, one after the other; a context that is entered where the work is done."""

    def __enter__(self) -> Any: ...

    def __exit__(self, *exception: object) -> None: ...

    def run(self, item: Any) -> Any:
        """The result of one item. Its exceptions are the item's failure."""

    def kill(self) -> None:
        """Stop the worker's current item; called from another thread, possibly more than once."""


@runtime_checkable
class Employer(Protocol):
    """A worker that has processes of its own work for it."""

    def processor_seconds(self) -> float | None:
        """Processor time of all its processes so far, s; None where the system does not tell.

        Called from another thread.
        """


class MakeWorker(Protocol):
    """Makes a worker of a name. Picklable, where workers are not threads."""

    def __call__(self, name: str) -> Worker: ...


class WorkerLost(WorkError):
    """The process or the machine of a worker has ended; its item may be run by another one."""


class TimedOut(WorkError):
    """An item took many times as long as its fellows, and its worker was ended."""


@dataclass(frozen=True)
class Outcome(Generic[Item, Result]):
    """Outcome of an item.

    result: None if it failed. failure: of the last attempt. worker, node: who ran it, and where.
    seconds: of the last attempt.
    """

    item: Item
    result: Result | None
    failure: Exception | None
    worker: str
    node: str
    seconds: float

    def value(self) -> Result:
        """The result. Raises the failure."""
        if self.failure is not None:
            raise self.failure
        return self.result  # type: ignore[return-value]

"""Workers in threads of this process."""

import threading
from concurrent.futures import Future
from dataclasses import dataclass
from queue import SimpleQueue
from typing import Any

from rna_work.processor_time import thread_seconds
from rna_work.workers import Employer, MakeWorker, Worker, WorkerLost

HERE = "this machine"


@dataclass(frozen=True)
class Threads:
    """So many threads."""

    count: int
    losses = 1

    def width(self) -> int:
        return self.count

    def slot(self, make: MakeWorker, name: str) -> "ThreadSlot":
        return ThreadSlot(make, name)


class ThreadSlot:
    """A thread with its worker."""

    def __init__(self, make: MakeWorker, name: str) -> None:
        self.name = name
        self.ready: Future[str] = Future()
        self._given: SimpleQueue[tuple[Any, Future[Any]] | None] = SimpleQueue()
        self._ended = False
        self._worker: Worker | None = None
        self._thread = threading.Thread(
            target=self._work, args=(make,), name=f"rna-{name}", daemon=True
        )
        self._thread.start()

    def give(self, item: Any) -> Future[Any]:
        future: Future[Any] = Future()
        self._given.put((item, future))
        return future

    def processor_seconds(self) -> float | None:
        seconds = thread_seconds(self._thread.native_id)
        others = self._worker.processor_seconds() if isinstance(self._worker, Employer) else 0.0
        return None if seconds is None or others is None else seconds + others

    def close(self, kill: bool) -> None:
        self._ended = self._ended or kill
        self._given.put(None)
        while self._thread.is_alive():
            if kill and self._worker is not None:
                self._worker.kill()  # again and again: it may be starting
            self._thread.join(0.05)

    def _work(self, make: MakeWorker) -> None:
        try:
            self._worker = make(self.name)
            with self._worker as worker:
                self.ready.set_result(HERE)
                while (given := self._given.get()) is not None:
                    self._run(worker, *given)
        except Exception as error:
            if not self.ready.done():
                self.ready.set_exception(error)

    def _run(self, worker: Worker, item: Any, future: Future[Any]) -> None:
        if self._ended:
            future.set_exception(WorkerLost(f"worker {self.name} was ended"))
            return
        try:
            future.set_result(worker.run(item))
        except BaseException as error:
            future.set_exception(error)

"""Workers in processes of this machine."""

import multiprocessing
import os
import pickle
import signal
import threading
from collections import deque
from concurrent.futures import Future
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any

from rna_sdk.errors import WorkError
from rna_work.processor_time import process_seconds
from rna_work.threads import HERE
from rna_work.workers import MakeWorker, WorkerLost


@dataclass(frozen=True)
class Processes:
    """So many processes, started afresh: none inherits threads or locks of this one."""

    count: int
    losses = 1

    def width(self) -> int:
        return self.count

    def slot(self, make: MakeWorker, name: str) -> "ProcessSlot":
        return ProcessSlot(make, name)


class ProcessSlot:
    """A process with its worker; a thread here listens to it."""

    def __init__(self, make: MakeWorker, name: str) -> None:
        self.name = name
        self.ready: Future[str] = Future()
        self._under_way: deque[Future[Any]] = deque([self.ready])
        context = multiprocessing.get_context("spawn")
        self._pipe, theirs = context.Pipe()
        self._process = context.Process(target=_serve, args=(theirs, make, name))
        self._process.start()
        theirs.close()
        self._listener = threading.Thread(target=self._listen, name=f"rna-{name}", daemon=True)
        self._listener.start()

    def give(self, item: Any) -> Future[Any]:
        future: Future[Any] = Future()
        self._under_way.append(future)
        try:
            self._pipe.send((item,))
        except OSError:
            pass  # it has ended: the listener says so
        return future

    def processor_seconds(self) -> float | None:
        return process_seconds(self._process.pid)

    def close(self, kill: bool) -> None:
        if kill:
            self._process.kill()
        else:
            try:
                self._pipe.send(None)
            except OSError:
                pass  # it has ended
        self._process.join()
        self._listener.join()
        self._pipe.close()

    def _listen(self) -> None:
        while True:
            try:
                result, error = self._pipe.recv()
            except (EOFError, OSError):
                break
            future = self._under_way.popleft()
            if error is None:
                future.set_result(result)
            else:
                future.set_exception(error)
        self._process.join()
        lost = WorkerLost(f"its process ended ({_how(self._process.exitcode)})")
        while self._under_way:
            self._under_way.popleft().set_exception(lost)


def _how(status: int | None) -> str:
    if status == -9:  # SIGKILL, which Windows has not
        return "killed; is there enough memory?"
    return f"status {status}"


def _serve(pipe: Connection, make: MakeWorker, name: str) -> None:
    """Main function of a worker process: enter the worker, run items; ends with the parent."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the one that started it
    threading.Thread(target=_end_with_parent, daemon=True).start()
    try:
        worker = make(name).__enter__()
    except Exception as error:
        pipe.send((None, portable(error)))
        return
    pipe.send((HERE, None))
    while (given := pipe.recv()) is not None:
        answer: tuple[Any, Exception | None]
        try:
            answer = worker.run(*given), None
        except Exception as error:
            answer = None, portable(error)
        pipe.send(answer)
    worker.__exit__(None, None, None)


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)  # it was killed: whoever runs the command again works on the same files


def portable(error: Exception) -> Exception:
    """The error itself, or its message where it cannot be sent to another process."""
    try:
        pickle.loads(pickle.dumps(error))
    except Exception:
        return WorkError(f"{type(error).__name__}: {error}")
    return error

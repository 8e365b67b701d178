"""Nodes of a Ray cluster, and workers in actors on them."""

import os
import socket
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any

from rna_work.backend import Needs
from rna_work.processes import portable
from rna_work.workers import MakeWorker, Worker, WorkerLost

_LOSSES = 10  # of an item's workers: nodes come and go


def alive_nodes() -> list[dict[str, Any]]:
    """Nodes that can work, as Ray lists them."""
    import ray

    return [node for node in ray.nodes() if node["Alive"] and node["Resources"].get("CPU", 0) > 0]


def nodes_with(resource: str | None) -> list[dict[str, Any]]:
    """Nodes with a resource; all usable nodes if none has it."""
    nodes = alive_nodes()
    return [node for node in nodes if resource in node["Resources"]] or nodes


@dataclass(frozen=True)
class RayWorkers:
    """Room for workers on a cluster.

    count: how many, which a cluster may grow for; None for as many as there is room for.
    """

    needs: Needs
    count: int | None
    losses = _LOSSES

    def __str__(self) -> str:
        return str(self.needs)

    def width(self) -> int:
        if self.count is not None:
            return self.count
        wanted = self._wanted()
        return sum(
            int(min(node["Resources"].get(name, 0) / need for name, need in wanted.items() if need))
            for node in alive_nodes()
        )

    def slot(self, make: MakeWorker, name: str) -> "RaySlot":
        return RaySlot(self.options(), max(1, int(self.needs.cpus)), make, name)

    def options(self) -> dict[str, Any]:
        """Options of a Ray actor."""
        wanted = self._wanted()
        standard = {"CPU": "num_cpus", "GPU": "num_gpus", "memory": "memory"}
        named = {standard[name]: need for name, need in wanted.items() if name in standard}
        more = {name: need for name, need in wanted.items() if name not in standard}
        return {**named, "resources": more, "max_restarts": 0, "max_task_retries": 0}

    def _wanted(self) -> dict[str, float]:
        """Resources that a worker takes, by Ray's names."""
        needs = self.needs
        wanted = {"CPU": needs.cpus, "GPU": needs.gpus, "memory": needs.memory}
        nodes = nodes_with(needs.resource)
        if needs.resource and nodes and needs.resource in nodes[0]["Resources"]:
            wanted[needs.resource] = 1e-3  # only says which nodes
        return {name: need for name, need in wanted.items() if need}


class RaySlot:
    """An actor with its worker."""

    def __init__(self, options: dict[str, Any], threads: int, make: MakeWorker, name: str) -> None:
        import ray

        self.name = name
        self._actor: Any = ray.remote(_Actor).options(**options).remote(threads)
        self.ready = _settled(self._actor.begin.remote(make, name))

    def give(self, item: Any) -> Future[Any]:
        return _settled(self._actor.run.remote(item))

    def processor_seconds(self) -> None:
        """Not known: an actor answers nothing while an item runs."""

    def close(self, kill: bool) -> None:
        import ray

        if not kill:
            try:
                ray.get(self._actor.end.remote(), timeout=10.0)
            except ray.exceptions.RayError:
                pass  # it has ended, or hangs: either way it is ended now
        ray.kill(self._actor)


class _Actor:
    """Runs in a process of its own on some node."""

    _worker: Worker

    def __init__(self, threads: int) -> None:
        """threads: of compiled kernels, which read this when the worker's modules are imported."""
        os.environ["NUMBA_NUM_THREADS"] = str(threads)
        os.environ.setdefault("OMP_WAIT_POLICY", "passive")  # else idle threads spin

    def begin(self, make: MakeWorker, name: str) -> tuple[Any, Exception | None]:
        return _answer(lambda: self._enter(make, name))

    def run(self, item: Any) -> tuple[Any, Exception | None]:
        return _answer(lambda: self._worker.run(item))

    def end(self) -> None:
        self._worker.__exit__(None, None, None)

    def _enter(self, make: MakeWorker, name: str) -> str:
        import ray

        self._worker = make(name).__enter__()
        return f"{socket.gethostname()}-{ray.get_runtime_context().get_node_id()[:4]}"


def _answer(do: Callable[[], Any]) -> tuple[Any, Exception | None]:
    try:
        return do(), None
    except Exception as error:
        return None, portable(error)


def _settled(reference: Any) -> Future[Any]:
    """A future of an actor's answer; WorkerLost if it answers no more."""
    future: Future[Any] = Future()

    def settle(done: Future[tuple[Any, Exception | None]]) -> None:
        error = done.exception()
        if error is not None:
            lost = WorkerLost(f"its process or node ended: {first_line(error)}")
            future.set_exception(lost)
            return
        result, failure = done.result()
        if failure is not None:
            future.set_exception(failure)
        else:
            future.set_result(result)

    reference.future().add_done_callback(settle)
    return future


def first_line(error: BaseException) -> str:
    """First line of the message, and the next unindented one: Ray's reason for an actor's death."""
    lines = str(error).strip().splitlines() or [type(error).__name__]
    more = (line for line in lines[1:] if line and not line[0].isspace())
    return f"{lines[0]} {next(more, '')}".strip()

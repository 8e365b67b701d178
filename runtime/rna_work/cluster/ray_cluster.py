"""A Ray cluster as an executor. Nothing else of the project imports Ray.

What its address needs is found out before Ray is imported, which reads it then.
"""

import os
import socket
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from rna_sdk.commands.console import install_hint
from rna_sdk.errors import RnaError, WorkError
from rna_work.backend import Needs
from rna_work.cached import content_hash
from rna_work.cluster.ray_slots import RayWorkers, alive_nodes, first_line, nodes_with
from rna_work.cluster.travelling import Travelling, check_elsewhere
from rna_work.processes import portable
from rna_work.sources import Carried

Answer = TypeVar("Answer")

_TRIES = 3
_ANSWER_SECONDS = 10.0
_HANDSHAKES = {  # of a head, and of the server of its ray:// address
    "": "/ray.rpc.NodeInfoGcsService/CheckAlive",
    "ray": "/ray.rpc.RayletDriver/ClusterInfo",
}
_NODE_SECONDS = 1800.0  # for what each node does before work begins, such as installing Blender


@contextmanager
def connected(address: str) -> Iterator["RayCluster"]:
    """The cluster of an address, as `--cluster` takes it.

    Raises WorkError where Ray is not installed, or where no cluster answers.
    """
    if address != "local":
        prepare(address)
    ray = imported_ray()
    # Read by the nodes that are started here. Workers of this machine's pools are not nice either.
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    os.environ.setdefault("RAY_worker_niceness", "0")
    options: dict[str, Any] = {"address": address, "log_to_driver": False, "logging_level": "ERROR"}
    if address == "local":  # even where a cluster runs on this machine
        options |= {"include_dashboard": False}
    begun_here = not ray.is_initialized()
    if begun_here:
        _connect(ray, options)
    try:
        yield RayCluster()
    finally:
        if begun_here:
            ray.shutdown()


def _connect(ray: Any, options: dict[str, Any]) -> None:
    """`ray.init`. Raises WorkError where no cluster answers."""
    for left in reversed(range(_TRIES)):
        try:
            ray.init(**options)
            return
        except (ImportError, ConnectionError, RuntimeError, ValueError, OSError) as error:
            # A busy head takes longer than Ray's 30 s to start what serves a ray:// address.
            if left and isinstance(error, ConnectionAbortedError):
                continue
            line = next(reversed(str(error).strip().splitlines()), type(error).__name__)
            where = f"--cluster {options['address']}"
            raise WorkError(f"{where}: no cluster answers: {line}") from error


def imported_ray() -> Any:
    """The module. Raises WorkError where it is not installed."""
    try:
        import ray
    except ModuleNotFoundError as error:
        raise WorkError(f"--cluster needs Ray: {install_hint('cluster')}") from error
    return ray


@dataclass(frozen=True)
class RayCluster:
    """The cluster that this process is connected to."""

    far = True

    def workers(self, needs: Needs, count: int | None) -> RayWorkers:
        return RayWorkers(needs, count)

    def gpus(self) -> float:
        return float(sum(node["Resources"].get("GPU", 0) for node in alive_nodes()))

    def carry(self, path: Path, others: Sequence[Path] = (), fixed: Sequence[Path] = ()) -> Carried:
        hashes = {file.absolute(): content_hash(file) for file in fixed}
        if hashes:
            self.on_every_node(partial(check_elsewhere, path, hashes))
        return Travelling.of(path, others)

    def whole_machines(
        self, threads: int | None, needs_gpu: bool = False
    ) -> tuple[RayWorkers, int]:
        gpus = 1.0 if needs_gpu else 0.0
        nodes = [node for node in alive_nodes() if node["Resources"].get("GPU", 0) >= gpus]
        if needs_gpu and not nodes:
            hint = "`ray start --num-gpus 1` tells it of one that it does not see"
            raise WorkError(f"no node of the cluster has a GPU resource; {hint}")
        least = min((int(node["Resources"]["CPU"]) for node in nodes), default=1)
        count = max(min(threads or least, least), 1)
        return RayWorkers(Needs("threads", count, gpus), None), count

    def on_every_node(
        self, do: Callable[[], Answer], resource: str | None = None
    ) -> dict[str, Answer]:
        import ray
        from ray.util.scheduling_strategies import NodeAffinitySchedulingStrategy

        remote = ray.remote(num_cpus=0, max_retries=0)(_answer_of_node)
        pending = {}
        for node in nodes_with(resource):
            there = NodeAffinitySchedulingStrategy(node["NodeID"], soft=False)
            pending[node_name(node)] = remote.options(scheduling_strategy=there).remote(do)
        answers = {}
        for name, reference in pending.items():
            try:
                answer, failure = ray.get(reference, timeout=_NODE_SECONDS)
            except ray.exceptions.RayError as error:
                raise WorkError(f"node {name} does not answer: {first_line(error)}") from error
            if failure is not None:
                raise WorkError(f"node {name}: {failure}") from failure
            answers[name] = answer
        return answers


def _answer_of_node(do: Callable[[], Any]) -> tuple[Any, Exception | None]:
    try:
        return do(), None
    except RnaError as error:
        return None, portable(error)


def node_name(node: dict[str, Any]) -> str:
    """Host, and the beginning of the node's number: several nodes may be on one host."""
    return f"{node['NodeManagerHostname']}-{node['NodeID'][:4]}"


def prepare(address: str) -> None:
    """See that somebody listens, and show the cluster's token if it asks for one.

    Ray itself would try for minutes. Raises WorkError.
    """
    scheme, _, rest = address.rpartition("://")
    host, colon, port = rest.rpartition(":")
    if not colon or not (port.isascii() and port.isdigit()):
        return  # such as `auto`
    try:
        socket.create_connection((host, int(port)), timeout=_ANSWER_SECONDS).close()
    except (OSError, OverflowError, ValueError) as error:  # of ports and names that cannot be
        raise WorkError(f"--cluster {address}: no cluster answers: {error}") from error
    if (
        "RAY_AUTH_MODE" not in os.environ
        and scheme in _HANDSHAKES
        and _asks(rest, _HANDSHAKES[scheme])
    ):
        named = any(os.environ.get(name) for name in ("RAY_AUTH_TOKEN", "RAY_AUTH_TOKEN_PATH"))
        if not (named or (Path.home() / ".ray" / "auth_token").is_file()):
            raise WorkError(
                f"--cluster {address}: requires a token: copy ~/.ray/auth_token from its head node "
                "to this machine"
            )
        os.environ["RAY_AUTH_MODE"] = "token"


def _asks(target: str, method: str) -> bool:
    """Whether a server wants a token. Without this answer Ray takes it that none does."""
    try:
        import grpc
    except ModuleNotFoundError:
        return False
    with grpc.insecure_channel(target) as channel:
        try:
            channel.unary_unary(method)(b"", timeout=_ANSWER_SECONDS)
        except grpc.RpcError as error:
            return bool(error.code() == grpc.StatusCode.UNAUTHENTICATED)
    return False

"""Where work runs, which only the option `--cluster` of a command decides."""

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Protocol, TypeVar
from uuid import uuid4

from rna_sdk.errors import WorkError
from rna_sdk.machine.cores import core_count
from rna_work.backend import Backend, Needs
from rna_work.processes import Processes
from rna_work.sources import Carried, InPlace
from rna_work.threads import HERE, Threads

Answer = TypeVar("Answer")


class Executor(Protocol):
    """This machine, or a cluster.

    Attributes:
        far: whether workers may be on other machines.
    """

    far: bool

    def workers(self, needs: Needs, count: int | None) -> Backend:
        """Slots for workers: at most `count`, or as many as fit for None."""

    def gpus(self) -> float:
        """Number of GPUs."""

    def whole_machines(self, threads: int | None, needs_gpu: bool = False) -> tuple[Backend, int]:
        """Slots for workers with the given threads (None: all of a machine), and their number.

        On this machine, without a cluster, there is one. needs_gpu: machines of a cluster with a
        GPU alone; raises WorkError where it knows of none.
        """

    def carry(self, path: Path, others: Sequence[Path] = (), fixed: Sequence[Path] = ()) -> Carried:
        """A file for workers, with others that it reads.

        fixed: those that it names by absolute paths, which stay where they are. Raises WorkError
        where one of these is missing on a machine.
        """

    def on_every_node(
        self, do: Callable[[], Answer], resource: str | None = None
    ) -> dict[str, Answer]:
        """Result of `do`, which can be pickled, by the name of each machine.

        resource: see `Needs`. Raises what it raises, with the name of the machine.
        """


@dataclass(frozen=True)
class ThisMachine:
    """Threads and processes."""

    cores: int
    far = False

    def workers(self, needs: Needs, count: int | None) -> Backend:
        wanted = count or max(1, int(self.cores // needs.cpus))
        return Threads(wanted) if needs.local == "threads" else Processes(wanted)

    def gpus(self) -> float:
        import torch

        return torch.cuda.device_count()

    def whole_machines(self, threads: int | None, needs_gpu: bool = False) -> tuple[Backend, int]:
        return Threads(1), min(threads or self.cores, self.cores)

    def carry(self, path: Path, others: Sequence[Path] = (), fixed: Sequence[Path] = ()) -> Carried:
        return InPlace(path)

    def on_every_node(
        self, do: Callable[[], Answer], resource: str | None = None
    ) -> dict[str, Answer]:
        return {HERE: do()}


def this_machine() -> ThisMachine:
    """Its cores that this process may use."""
    return ThisMachine(core_count())


def open_executor(address: str | None) -> AbstractContextManager[Executor]:
    """Context with the executor that `--cluster` names. Raises WorkError if it cannot be used."""
    if address is None:
        return nullcontext(this_machine())
    from rna_work.cluster.ray_cluster import connected

    return connected(address)


def check_shared(executor: Executor, folder: Path) -> None:
    """Raises WorkError where a machine of an executor has not this folder, or has another one."""
    if not executor.far:
        return
    folder = folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    token = folder / f".shared-{uuid4().hex}"
    token.touch()
    try:
        executor.on_every_node(partial(_find, token))
    finally:
        token.unlink()


def _find(token: Path) -> None:
    if not token.is_file():
        raise WorkError(
            f"{token.parent}: differs from the folder on the command's machine; expected a folder "
            "shared by all nodes"
        )
    probe = token.with_name(f"{token.name}.{uuid4().hex[:8]}")
    try:
        probe.touch()
        probe.unlink()
    except OSError as error:
        raise WorkError(f"{token.parent}: cannot be written: {error.strerror}") from error

"""Whether a folder is one and the same on all machines."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from uuid import uuid4

from rna_sdk.errors import WorkError
from rna_work.executors import Executor


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

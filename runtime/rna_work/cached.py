"""Folders that a machine keeps between commands, each made once and whole; and a lock."""

import hashlib
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from uuid import uuid4

from rna_sdk.errors import WorkError
from rna_sdk.files.owned_folder import cache_folder


def cached(name: str, write: Callable[[Path], None]) -> Path:
    """The folder named by its contents; `write` fills it if it is missing."""
    folder = sources_folder() / name
    if not folder.is_dir():
        with locked(folder.with_name(f"{name}.lock")):
            if not folder.is_dir():
                _make(folder, write)
    return folder


def _make(folder: Path, write: Callable[[Path], None]) -> None:
    temporary = folder.with_name(f"{folder.name}.{uuid4().hex[:8]}.part")
    try:
        temporary.mkdir()
        write(temporary)
        temporary.rename(folder)
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def sources_folder() -> Path:
    """Folder in which a machine keeps sources and datasets.

    Raises:
        WorkError: the user has no home, and XDG_CACHE_HOME names no other folder.
    """
    try:
        return cache_folder() / "sources"
    except RuntimeError as error:
        raise WorkError(f"no folder for caches: {error} Set XDG_CACHE_HOME") from error


def content_hash(path: Path) -> str:
    """SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


@contextmanager
def locked(file: Path) -> Iterator[None]:
    """Held by one of all machines that share the file; free again where its holder ends.

    Not on Windows, which has no such locks.
    """
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("w") as lock:
        with suppress(ModuleNotFoundError):
            import fcntl

            fcntl.flock(lock, fcntl.LOCK_EX)
        yield

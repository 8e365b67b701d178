"""Atomic file writing: to a temporary name, then renamed."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path


@contextmanager
def atomic_file(path: Path) -> Iterator[Path]:
    """A name to write to, in the folder of `path`; it becomes `path` when the block ends.

    A block that raises leaves `path` as it was and no temporary file. The name ends in ".part" and
    is one that no other process has, on this machine or on another that shares the folder.
    """
    temporary = temporary_path(path)
    try:
        yield temporary
        temporary.replace(path)
    except BaseException:
        with suppress(OSError):
            temporary.unlink()
        raise


def write_atomically(path: Path, data: bytes) -> None:
    """Write a file's bytes by `atomic_file`."""
    with atomic_file(path) as temporary:
        temporary.write_bytes(data)


def temporary_path(path: Path) -> Path:
    """A new temporary name beside `path`."""
    return path.with_name(f".{path.name}.{os.urandom(6).hex()}.part")

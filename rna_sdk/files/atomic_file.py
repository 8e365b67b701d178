"""Atomic file writing: to a temporary name, then renamed.

Whoever writes holds a shared lock on the folder, so that what killed processes left there can be
told from what is being written.
"""

import errno
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path

_TEMPORARY = re.compile(r"\..+\.[0-9a-f]{12}\.part")


@contextmanager
def atomic_file(path: Path) -> Iterator[Path]:
    """A name to write to, in the folder of `path`; it becomes `path` when the block ends.

    A block that raises leaves `path` as it was and no temporary file. The name ends in ".part" and
    is one that no other process has, on this machine or on another that shares the folder. An
    OSError without a file name, or with the temporary one, gets the name of `path`.
    """
    check_replaceable(path)
    temporary = temporary_path(path)
    try:
        with _locked(path.parent, alone=False):
            yield temporary
            temporary.replace(path)
    except BaseException as error:
        with suppress(OSError):
            temporary.unlink()
        if not isinstance(error, OSError) or error.errno is None:
            raise
        if error.filename not in (None, str(temporary)):
            raise
        raise OSError(error.errno, error.strerror, str(path)) from error


def check_replaceable(path: Path) -> None:
    """Raises OSError for a folder, pipe or device: a file would take its place."""
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, "it is a folder", str(path))
    if path.exists() and not path.is_file():
        raise OSError(
            errno.EINVAL, "it is a pipe or a device, which a file would replace", str(path)
        )


def write_atomically(path: Path, data: bytes) -> None:
    """Write a file's bytes by `atomic_file`."""
    with atomic_file(path) as temporary:
        temporary.write_bytes(data)


def temporary_path(path: Path) -> Path:
    """A new temporary name beside `path`."""
    return path.with_name(f".{path.name}.{os.urandom(6).hex()}.part")


def is_temporary(path: Path) -> bool:
    """Whether the name is one of `temporary_path`."""
    return _TEMPORARY.fullmatch(path.name) is not None


@cache
def remove_leftovers(folder: Path) -> None:
    """Delete leftovers of killed processes in a folder, once a process; none while others write."""
    with _locked(folder, alone=True) as locked:
        for path in filter(is_temporary, folder.iterdir() if locked else ()):
            path.unlink(missing_ok=True)


@contextmanager
def _locked(folder: Path, alone: bool) -> Iterator[bool]:
    """Whether a lock on a folder was had; not on Windows, nor on some file systems of networks."""
    locked, descriptor = False, None
    with suppress(OSError, ModuleNotFoundError):
        import fcntl

        descriptor = os.open(folder, os.O_RDONLY)
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB if alone else fcntl.LOCK_SH)
        locked = True
    try:
        yield locked
    finally:
        if descriptor is not None:
            os.close(descriptor)

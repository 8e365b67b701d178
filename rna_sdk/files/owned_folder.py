"""Folders that a command writes: marked as its own, locked while it runs, cleared by name.

A command marks its folder with an empty file that is named for it, `.rna-capture`. It writes into a
folder only if that is new, empty or marked so, which keeps the files of the user and of other
commands safe. While it runs it holds a lock on the marker, whose text then says who that is; the
system releases the lock of a process that ends in any way. Names that start with `.rna-` are ours.

So is the folder of the user's caches, which all commands share.
"""

import os
import shutil
import socket
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from datetime import datetime
from io import TextIOWrapper
from pathlib import Path

from rna_sdk.errors import RnaError
from rna_sdk.files.atomic_file import is_temporary

_OURS = ".rna-"
_SCRATCH = f"{_OURS}scratch-"
_NAMED = 3  # files, in an error


@dataclass(frozen=True)
class OwnedFolder:
    """A folder that this process alone writes; made by `owned`."""

    path: Path
    command: str

    @contextmanager
    def scratch(self) -> Iterator[Path]:
        """A new folder for temporary files, removed at the end.

        Its name is new, too: processes of a command that was killed may still write into theirs.
        """
        folder = self.path / f"{_SCRATCH}{os.urandom(6).hex()}"
        folder.mkdir()
        try:
            yield folder
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def remove(self, *names: str) -> None:
        """Delete these files and folders in it, which the command made; a link, not its target."""
        for name in names:
            path = self.path / name
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path)
            else:
                path.unlink(missing_ok=True)

    def dissolve(self, *names: str) -> list[str]:
        """Delete these, then the folder, unless it holds others: their names are returned."""
        self.remove(*names)
        others = sorted(path.name for path in self.path.iterdir() if not _is_ours(path))
        if not others:
            _marker(self.path, self.command).unlink()
            with suppress(OSError):  # a link to a folder
                self.path.rmdir()
        return others


@contextmanager
def owned(folder: Path, command: str) -> Iterator[OwnedFolder]:
    """The folder for a command, made if missing, until the block ends.

    Leftovers of its killed runs are deleted: scratch folders and unfinished files. A block that
    wrote nothing leaves no folder that was not there.

    command: its name, `rna-capture`.

    Raises RnaError for a file, a folder of others, and one that another process writes; OSError
    where the folder cannot be written.
    """
    was_there = folder.exists()
    _check_marked(folder, command)
    folder.mkdir(parents=True, exist_ok=True)
    marker = _marker(folder, command)
    with _locked(marker, folder, command) as file:
        _clear(folder)
        try:
            yield OwnedFolder(folder, command)
        finally:
            if _is_at(file, marker) and not any(map(_counts, folder.iterdir())):
                marker.unlink()
                if not was_there:
                    with suppress(OSError):
                        folder.rmdir()


def _check_marked(folder: Path, command: str) -> None:
    if folder.exists() and not folder.is_dir():
        raise RnaError(f"{folder}: is a file, expected a folder")
    if not folder.is_dir() or _marker(folder, command).is_file():
        return
    others = sorted(path.name for path in folder.iterdir() if _counts(path) or _is_ours(path))
    if others:
        more = f" and {len(others) - _NAMED} more" if len(others) > _NAMED else ""
        raise RnaError(
            f"{folder}: found {', '.join(others[:_NAMED])}{more}, which {command} did not write; "
            "expected a new or empty folder"
        )


def _counts(path: Path) -> bool:
    """Whether a file makes a folder one of somebody's; `.gitkeep` or `.DS_Store` does not."""
    return not path.name.startswith(".")


def _is_ours(path: Path) -> bool:
    return path.name.startswith(_OURS)


def _marker(folder: Path, command: str) -> Path:
    return folder / f".{command}"


def _clear(folder: Path) -> None:
    for path in folder.iterdir():
        if path.name.startswith(_SCRATCH):
            shutil.rmtree(path, ignore_errors=True)
        elif is_temporary(path):
            path.unlink(missing_ok=True)


@contextmanager
def _locked(marker: Path, folder: Path, command: str) -> Iterator[TextIOWrapper]:
    """The marker, locked, while its text says by whom."""
    with _opened_and_locked(marker, folder) as file:
        file.truncate(0)
        host, now = socket.gethostname(), datetime.now()
        file.write(f"{command}, process {os.getpid()} on {host} since {now:%Y-%m-%d %H:%M:%S}")
        file.flush()
        try:
            yield file
        finally:
            file.truncate(0)


def _opened_and_locked(marker: Path, folder: Path) -> TextIOWrapper:
    while True:
        file = marker.open("a+", encoding="utf-8")
        try:
            _lock(file, folder)
        except BaseException:
            file.close()
            raise
        if _is_at(file, marker):
            return file
        file.close()  # whoever held it before has deleted it
        folder.mkdir(parents=True, exist_ok=True)


def _is_at(file: TextIOWrapper, path: Path) -> bool:
    """Whether an open file is still the file of this name."""
    try:
        return os.path.samestat(os.fstat(file.fileno()), path.stat())
    except FileNotFoundError:
        return False


def _lock(file: TextIOWrapper, folder: Path) -> None:
    try:
        import fcntl
    except ModuleNotFoundError:  # not on Windows
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as error:
        file.seek(0)
        who = file.read().strip() or "another process"
        raise RnaError(f"{folder}: in use by {who}; wait until it ends, or end it") from error
    except OSError as error:  # a file system without locks
        warnings.warn(f"{folder}: cannot be locked: {error.strerror}", stacklevel=2)


def cache_folder() -> Path:
    """The SDK's folder for files that can be made again; it need not exist.

    That of the XDG Base Directory Specification: `$XDG_CACHE_HOME` where it is an absolute path,
    else `~/.cache`. Raises RuntimeError where neither is there, since the user has no home.
    """
    named = Path(os.environ.get("XDG_CACHE_HOME", ""))
    return (named if named.is_absolute() else Path.home() / ".cache") / "rna-sdk"

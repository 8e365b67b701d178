"""Folders in a store: on their way to machines, each file once, and copied while they change."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from rna_work.cached import cached, content_hash
from rna_work.cluster.store import Store


@dataclass(frozen=True)
class StoredFolder:
    """Files of a folder; see `rna_work.sources.Carried`.

    hashes: SHA-256 by name, from the folder on; the first is the one that is asked for.
    """

    store: Store
    hashes: Mapping[str, str]

    @classmethod
    def of(cls, first: Path, store: Store) -> StoredFolder:
        """A file with all that lies beside and below it. Raises WorkError if that cannot be sent.

        What the store has already is not sent again. Hidden files and folders stay here: the
        marker of the command that wrote the folder, and what is unfinished; likewise `*.part`.
        """
        folder = first.parent
        files = [path for path in sorted(folder.rglob("*")) if _is_sent(path, folder)]
        paths = {p.relative_to(folder).as_posix(): p for p in [first, *files]}
        hashes = {name: content_hash(path) for name, path in paths.items()}
        there = store.sizes()
        for name, sha in hashes.items():
            size = paths[name].stat().st_size
            if there.get(sha) != size:  # one of another size was cut
                store.put(paths[name], sha)
                there[sha] = size
        return cls(store, hashes)

    @property
    def sha256(self) -> str:
        """Hash of all names and contents."""
        whole = "".join(f"{name}\0{sha}\0" for name, sha in self.hashes.items())
        return hashlib.sha256(whole.encode()).hexdigest()

    def here(self) -> Path:
        """The path on this machine, where the files are fetched unless they are there."""
        return cached(self.sha256, self._fetch) / next(iter(self.hashes))

    def _fetch(self, folder: Path) -> None:
        for name, sha in self.hashes.items():
            self.store.get(sha, folder / name, sha)


def _is_sent(path: Path, folder: Path) -> bool:
    names = path.relative_to(folder).parts
    hidden = any(name.startswith(".") for name in names)
    return path.is_file() and path.suffix != ".part" and not hidden


class Mirror:
    """A folder that changes and its copy, from which another machine goes on.

    Whoever writes into the folder is the only one that does so.
    """

    def __init__(self, folder: Path, store: Store) -> None:
        self._folder, self._store = folder, store
        self._sent: dict[str, tuple[int, int]] = {}  # name -> time of the last change, size

    def fetch(self) -> None:
        """Get all files of the copy. Raises WorkError if one cannot be had."""
        for name in sorted(self._store.names()):
            self._store.get(name, self._folder / name)
            self._sent[name] = _state(self._folder / name)

    def send(self) -> None:
        """Send changed files, oldest first, then remove deleted ones. Raises WorkError."""
        now = {
            path.relative_to(self._folder).as_posix(): _state(path)
            for path in self._folder.rglob("*")
            if path.is_file() and path.suffix != ".part"
        }
        for name, state in sorted(now.items(), key=lambda pair: pair[1]):
            if self._sent.get(name) != state:
                self._store.put(self._folder / name, name)
                self._sent[name] = state
        for name in self._sent.keys() - now.keys():
            self._store.remove(name)
            del self._sent[name]


def _state(path: Path) -> tuple[int, int]:
    status = path.stat()
    return status.st_mtime_ns, status.st_size

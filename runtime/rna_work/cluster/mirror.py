"""A folder that changes, and a copy of it in a store, from which another machine goes on."""

from __future__ import annotations

from pathlib import Path

from rna_work.cluster.store import Store


class Mirror:
    """A folder of this machine and its copy.

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
    found = path.stat()
    return found.st_mtime_ns, found.st_size

"""A folder on its way to machines through a store: each file is sent once, by its content."""

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

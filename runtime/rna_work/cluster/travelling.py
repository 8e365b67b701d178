"""A source on its way to the machines of a cluster: once a machine, by the hash of its content."""

import hashlib
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rna_sdk.errors import WorkError
from rna_sdk.files.regular_file import read_regular
from rna_work.cached import cached, content_hash


@dataclass(frozen=True)
class Travelling:
    """Files with their relative paths, and contents in Ray's object store.

    names: of all files, from the deepest folder on that they share; the first is the one that is
    asked for.
    """

    names: tuple[str, ...]
    sha256: str
    contents: Any  # of a list of bytes, in the same order; a Ray reference

    @classmethod
    def of(cls, path: Path, others: Sequence[Path]) -> "Travelling":
        """A file and others. Raises WorkError where one cannot be read."""
        import ray

        first = os.path.abspath(path)
        files = [first, *sorted({os.path.abspath(other) for other in others} - {first})]
        root = os.path.commonpath([os.path.dirname(file) for file in files])
        names = tuple(os.path.relpath(file, root) for file in files)
        try:
            contents = [read_regular(Path(file)) for file in files]
        except OSError as error:
            raise WorkError(f"{path} reads {error.filename}: {error.strerror}") from error
        whole = hashlib.sha256()
        for name, data in zip(names, contents, strict=True):
            whole.update(f"{name}\0{hashlib.sha256(data).hexdigest()}\0".encode())
        return cls(names, whole.hexdigest(), ray.put(contents))

    def here(self) -> Path:
        """The path on this machine, where the files are written unless they are there."""
        return cached(self.sha256, self._write) / self.names[0]

    def _write(self, folder: Path) -> None:
        import ray

        for name, data in zip(self.names, ray.get(self.contents), strict=True):
            file = folder / name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(data)


def check_elsewhere(source: Path, hashes: dict[Path, str]) -> None:
    """Raises WorkError where one of these files is missing on this machine, or is another one."""
    wrong = [str(p) for p, sha in hashes.items() if not p.is_file() or content_hash(p) != sha]
    if wrong:
        more = f" and {len(wrong) - 3} more" if len(wrong) > 3 else ""
        raise WorkError(
            f"{source} reads {', '.join(wrong[:3])}{more} by an absolute path, where this machine "
            "has no such file, or another one: name it by a path relative to the source, and it "
            "travels"
        )

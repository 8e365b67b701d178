"""Finished pieces of an image, stored in a folder beside it until the image is complete."""

import json
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from safetensors import SafetensorError, safe_open
from safetensors.numpy import save_file

from rna_render.image.film import Film
from rna_sdk.errors import SceneError
from rna_sdk.files.atomic_file import atomic_file, remove_leftovers

_PIECES = f"{'[0-9]' * 10}-{'[0-9]' * 10}.safetensors"


@dataclass(frozen=True)
class Piece:
    """Pixels of an image in row-major order, from `start` to before `stop`."""

    start: int
    stop: int

    @property
    def pixels(self) -> int:
        """Number of pixels."""
        return self.stop - self.start

    def __str__(self) -> str:
        return f"piece of pixels {self.start} to {self.stop - 1}"


@dataclass(frozen=True)
class FinishedPieces:
    """Pieces in a folder, a file each.

    key: of the image that they are of; pieces of another one are removed.
    """

    folder: Path
    key: str

    def saved(self) -> Iterator[tuple[Piece, Film]]:
        """Stored pieces of this image, in order; others are deleted."""
        if self.folder.is_dir():
            remove_leftovers(self.folder)
        for path in _paths(self.folder):
            film = self._read(path)
            if film is None:
                path.unlink()
            else:
                yield _piece_of(path), film

    def keep(self, piece: Piece, film: Film) -> None:
        """Write a piece, whole or not at all. Raises SceneError if that cannot be."""
        path = self.folder / f"{piece.start:010d}-{piece.stop:010d}.safetensors"
        metadata = {"image": self.key, "groups": json.dumps(film.groups)}
        try:
            self.folder.mkdir(exist_ok=True)
            with atomic_file(path) as temporary:
                save_file(film.arrays(), temporary, metadata)
        except (OSError, SafetensorError) as error:
            raise SceneError(f"cannot be written: {error}", file=path) from error

    def remove(self) -> None:
        """The image is written: its pieces are deleted, and the folder that had only these."""
        for path in _paths(self.folder):
            path.unlink()
        with suppress(OSError):
            self.folder.rmdir()

    def _read(self, path: Path) -> Film | None:
        """None for a piece of another image, and for a damaged file."""
        try:
            with safe_open(path, "np") as file:
                metadata = file.metadata() or {}
                if metadata.get("image") != self.key:
                    return None
                arrays = {name: file.get_tensor(name) for name in file.keys()}
                return Film.of_arrays(arrays, json.loads(metadata["groups"]))
        except (OSError, SafetensorError, KeyError, ValueError):
            return None


def missing_pieces(count: int, there: list[Piece]) -> Iterator[Piece]:
    """Gaps between ordered, disjoint pieces of `count` pixels."""
    start = 0
    for piece in there:
        if piece.start > start:
            yield Piece(start, piece.start)
        start = piece.stop
    if start < count:
        yield Piece(start, count)


def finished_pixels(folder: Path) -> int:
    """Number of pixels of the pieces that a folder holds; 0 if there is no such folder."""
    return sum(_piece_of(path).pixels for path in _paths(folder))


def _paths(folder: Path) -> list[Path]:
    return [path for path in sorted(folder.glob(_PIECES)) if path.is_file()]


def _piece_of(path: Path) -> Piece:
    start, _, stop = path.stem.partition("-")
    return Piece(int(start), int(stop))

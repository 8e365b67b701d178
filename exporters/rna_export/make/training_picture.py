"""The picture of a model that is being trained, in a file that is rewritten."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from rna_sdk.atomic_file import write_atomically


@dataclass(frozen=True)
class TrainingPicture:
    """A copy of the first validation picture that trainings write: ours, Cycles, the error.

    path: the file, beside the package to come.
    """

    path: Path

    @classmethod
    def beside(cls, package: Path) -> TrainingPicture:
        """The picture `<package without .rna>.training.png`."""
        return cls(package.with_name(f"{package.stem}.training.png"))

    def show(self, training: Path) -> None:
        """Copy the newest picture of a training's folder, if it has one.

        A picture is no reason to end a training: one that cannot be read or written is left out.
        """
        with suppress(OSError):
            pictures = sorted((training / "validation").glob("view-*.png"))
            if pictures:
                write_atomically(self.path, pictures[0].read_bytes())

"""Files that workers read, wherever they are."""

from dataclasses import dataclass
from pathlib import Path
from typing import Protocol


class Carried(Protocol):
    """A file that is brought to where it is needed, with those beside it that it reads."""

    def here(self) -> Path:
        """Its path on this machine."""


@dataclass(frozen=True)
class InPlace:
    """A file that is where it was."""

    path: Path

    def here(self) -> Path:
        return self.path

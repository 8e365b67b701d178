"""Every method of `rna-bench peers`: a row each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from rna_bench.peers.method import Method


@dataclass(frozen=True)
class Setting:
    """What a method is made with.

    seed: of its initialisation and training. device: of PyTorch. full: the published sizes of
    batches and numbers of samples a ray, instead of those for a CPU.
    """

    seed: int = 0
    device: str = "cpu"
    full: bool = False


@dataclass(frozen=True)
class MethodRow:
    """A method by name.

    title: for tables. make: imports its module. published_steps, published_batch: of the training
    as published; None where it is not known. reduced: what differs without `Setting.full`, for
    tables; empty for nothing.
    """

    name: str
    title: str
    make: Callable[[Setting], Method]
    published_steps: int | None
    published_batch: int | None
    reduced: str = ""

    def share(self, samples: int) -> float | None:
        """Of the published number of pixels seen, with repetition."""
        if self.published_steps is None or self.published_batch is None:
            return None
        return samples / (self.published_steps * self.published_batch)


_ROWS: tuple[MethodRow, ...] = ()

METHODS = {row.name: row for row in _ROWS}

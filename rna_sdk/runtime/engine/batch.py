"""The arrays of one evaluation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from rna_sdk.package.decoder.query_arrays import Rows, in_order


@dataclass(frozen=True)
class Batch:
    """Arguments and results.

    Attributes:
        arrays: one for each of QUERY_ARRAYS, (n, 3) or (n,) float32.
        results: written by the evaluation: those of the decoder's form, each (n, columns) float32.
    """

    arrays: tuple[Rows, ...]
    results: tuple[Rows, ...]

    @classmethod
    def of(cls, arrays: Mapping[str, Rows], results: tuple[Rows, ...]) -> Batch:
        """arrays: by name, those that the decoder's blocks are made of."""
        return cls(in_order(arrays), results)

    def __len__(self) -> int:
        return len(self.arrays[0])

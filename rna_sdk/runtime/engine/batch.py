"""The arrays of one evaluation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder.decoder_form import COLUMNS
from rna_sdk.package.decoder.query_arrays import Rows, in_order


@dataclass(frozen=True)
class Batch:
    """Arguments and results.

    Attributes:
        arrays: one for each of INPUT_ARRAYS, (n, 3) or (n,) float32.
        results: written by the evaluation: those of the decoder's form, each (n, 3) float32.
        base_color: (n, 3) float32 where the decoder has a factor of each result, behind them.
    """

    arrays: tuple[Rows, ...]
    results: tuple[Rows, ...]
    base_color: Rows | None = field(default=None, kw_only=True)

    @classmethod
    def of(cls, arrays: Mapping[str, Rows], results: tuple[Rows, ...]) -> Batch:
        """arrays: by name, those that the decoder's blocks are made of, and the base colour."""
        return cls(in_order(arrays), results, base_color=arrays.get("base_color"))

    def __len__(self) -> int:
        return len(self.arrays[0])

    def complete(self, tile: slice, queries: Rows, valid: NDArray[np.bool_]) -> None:
        """Write what stands in `queries` (m, K) behind the input blocks, for m rows: nothing."""

    def write(self, tile: slice, output: Rows, valid: NDArray[np.bool_]) -> None:
        """Write the results of a tile from the decoder's output."""
        # numba loads when it is used
        from rna_sdk.runtime.kernels.output_kernel import write_results, write_sums

        for k, result in enumerate(self.results):
            if self.base_color is None:
                write_results(output, COLUMNS * k, valid, result[tile])
            else:
                columns = COLUMNS * k, COLUMNS * (k + len(self.results))
                write_sums(output, *columns, self.base_color[tile], valid, result[tile])

"""The arrays of one evaluation."""

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
        nearby: nearby light of each result, if the decoder takes it, (n, 3) float32.
    """

    arrays: tuple[Rows, ...]
    results: tuple[Rows, ...]
    base_color: Rows | None = field(default=None, kw_only=True)
    nearby: tuple[Rows, ...] | None = field(default=None, kw_only=True)

    @classmethod
    def of(
        cls,
        arrays: Mapping[str, Rows],
        results: tuple[Rows, ...],
        nearby: tuple[Rows, ...] | None = None,
    ) -> "Batch":
        """arrays: by name, those that the decoder's blocks are made of, and the base colour."""
        return cls(in_order(arrays), results, base_color=arrays.get("base_color"), nearby=nearby)

    def __len__(self) -> int:
        return len(self.arrays[0])

    def complete(self, tile: slice, queries: Rows, valid: NDArray[np.bool_]) -> None:
        """Write the columns of `queries` (m, K) behind the input blocks, for m rows: none here."""

    def write(self, tile: slice, output: Rows, valid: NDArray[np.bool_]) -> None:
        """Write the results of a tile from the decoder's output."""
        # numba loads when it is used
        from rna_sdk.runtime.kernels.output_kernel import write_results, write_sums

        whole = output
        for k, result in enumerate(self.results):
            if self.nearby is not None:
                output = self._mixed(whole, self.nearby[k][tile], valid)
            if self.base_color is None:
                write_results(output, COLUMNS * k, valid, result[tile])
            else:
                write_sums(
                    output,
                    COLUMNS * k,
                    COLUMNS * (k + len(self.results)),
                    self.base_color[tile],
                    valid,
                    result[tile],
                )

    def _mixed(self, output: Rows, nearby: Rows, valid: NDArray[np.bool_]) -> Rows:
        """The columns of a decoder without nearby light, (m, c) float32, of a tile."""
        from rna_sdk.runtime.kernels.output_kernel import mix_sets  # as above

        columns = COLUMNS * len(self.results) * (1 if self.base_color is None else 2)
        mixed = np.empty((len(nearby), columns), np.float32)
        mix_sets(output, nearby, valid, mixed)
        return mixed

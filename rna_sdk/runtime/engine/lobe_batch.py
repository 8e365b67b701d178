"""The arrays of a query of lobes."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.decoder.query_arrays import Rows
from rna_sdk.runtime.engine.batch import Batch
from rna_sdk.runtime.kernels.lobe_kernels import put_visibility, write_lobes


@dataclass(frozen=True)
class LobeBatch(Batch):
    """As Batch, whose wi is the mirror direction; results: amplitudes and axes, (n, L, 3) each.

    Attributes:
        free: (n,) float32, visibility along the mirror direction.
        visibility: (n, 16 or 0) float32, of `queries` from `column` on.
        is_fiber: whether the part is of fibers.
    """

    free: Rows
    visibility: Rows
    column: int
    is_fiber: bool

    def complete(self, tile: slice, queries: Rows, valid: NDArray[np.bool_]) -> None:
        put_visibility(self.visibility[tile], self.free[tile], self.column, queries, valid)

    def write(self, tile: slice, output: Rows, valid: NDArray[np.bool_]) -> None:
        _, axis, _, wo, mirror = (array[tile] for array in self.arrays)
        wide = wo if self.is_fiber else axis
        amplitudes, axes = (result[tile] for result in self.results)
        free = self.free[tile]
        write_lobes(output, valid, wide, mirror, free, self.is_fiber, amplitudes, axes)

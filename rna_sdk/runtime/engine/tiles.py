"""Evaluate a batch in tiles that stay in a core's cache, on several threads."""

from collections.abc import Iterator
from copy import copy
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.machine.kernel_threads import share
from rna_sdk.package import Bounds, Int8Planes, Planes
from rna_sdk.package.decoder.query_arrays import Rows
from rna_sdk.package.manifest.manifest_fields import Kind
from rna_sdk.package.manifest.manifest_tiers import TierPartFields
from rna_sdk.runtime.engine.batch import Batch
from rna_sdk.runtime.engine.decoder_sessions import Decoder
from rna_sdk.runtime.kernels.block_columns import block_columns
from rna_sdk.runtime.kernels.lanes import LANES
from rna_sdk.runtime.kernels.query_kernel import query_kernel

_ROW_STEP = 16
"""The decoder always sees a multiple of this many rows: vector instructions then leave no
remainder, whose elements a library may compute by another formula with other rounding."""

_SMALLEST_TILE = 256
"""Rows; below this a call of the decoder costs more than its work."""


class QueryFiller:
    """Gathers features and lays out decoder inputs, for one part in one tier.

    Attributes:
        largest_query: no number in the queries is further from 0.
    """

    def __init__(
        self,
        planes: Planes,
        bounds: Bounds,
        part: TierPartFields,
        kind: Kind,
        of_lobes: bool = False,
    ) -> None:
        """of_lobes: wi is the mirror direction, and the half vector of the blocks the normal."""
        low, high = bounds.corners().astype(np.float64)
        self._box = np.stack([low, 1 / (high - low)])
        self._columns = block_columns(part.inputs, part.channels)
        self._channels, self._resolution = part.channels, part.resolution
        self._of_lobes = of_lobes
        # Planes stay as they are in the file, converted as they are read: less memory and cache.
        texels, scales = _parts(planes)
        if self._resolution == 1:  # the same everywhere, like four equal texels
            texels, self._resolution = texels.repeat(2, axis=1).repeat(2, axis=2), 2
        self._texels = texels.view(np.uint16 if texels.dtype == np.float16 else texels.dtype)
        self._texels = self._texels.reshape(-1)
        self._scales = scales.reshape(-1)
        self.largest_query = _largest_query(planes)
        self._kernel = query_kernel(kind, part.channels, part.plane_precision)

    def laying_out(self, inputs: tuple[str, ...]) -> "QueryFiller":
        """A filler for other input blocks, on the same planes."""
        other = copy(self)
        other._columns = block_columns(inputs, self._channels)
        return other

    def fill(self, batch: Batch, rows: slice, queries: Rows, valid: NDArray[np.bool_]) -> None:
        """Write K columns of `queries`, and `valid` (m,), for the m rows of the batch."""
        sources = [array[rows] for array in batch.arrays]
        if len(queries) >= LANES:
            self._call(sources, queries, valid)
            return
        sources = [np.resize(a, (LANES, *a.shape[1:])) if len(a) else a for a in sources]
        whole, flags = np.zeros((LANES, queries.shape[1]), np.float32), np.empty(LANES, np.bool_)
        self._call(sources, whole, flags)
        queries[:], valid[:] = whole[: len(queries)], flags[: len(valid)]

    def _call(self, sources: list[Rows], queries: Rows, valid: NDArray[np.bool_]) -> None:
        self._kernel(
            self._texels,
            self._scales,
            self._resolution,
            self._box,
            self._columns,
            self._of_lobes,
            *sources,
            queries,
            valid,
        )


def _parts(planes: Planes) -> tuple[NDArray[Any], NDArray[np.float32]]:
    """The texels, and the scales: only for int8."""
    if isinstance(planes, Int8Planes):
        return planes.texels, planes.scales
    return planes, np.empty(0, np.float32)


def _largest_query(planes: Planes) -> float:
    """A bound for three features summed, and for all the other blocks, which are below 4."""
    if isinstance(planes, Int8Planes):
        return max(128.01 * float(np.abs(planes.scales).sum(axis=0).max()), 4.0)
    if planes.dtype == np.float16:  # without the sign bit, the bits of a number grow with it
        largest = (planes.view(np.uint16) & 0x7FFF).max().view(np.float16)
    else:
        largest = np.abs(planes).max()
    return max(3.01 * float(largest), 4.0)


class TileEvaluator:
    """Runs batches through query filling and decoder, tile by tile.

    One thread takes a tile through all steps while it is hot in its cache. A row's result
    depends on that row alone, to the bit: not on its tile, nor on the thread that took it.
    """

    def __init__(self, filler: QueryFiller, decoder: Decoder, threads: int) -> None:
        self._filler = filler
        self._decoder = decoder
        self._threads = threads

    def run(self, batch: Batch) -> None:
        """Write `batch.results`."""
        rows = self._tile_rows(len(batch))
        run = partial(self._run_tiles, batch, rows)
        share(run, range(0, len(batch), rows), self._threads)

    def _tile_rows(self, count: int) -> int:
        """Rows a tile: the decoder's best, or less where threads would get fewer than two."""
        share = -(-count // (2 * self._threads if self._threads > 1 else 1))
        return min(self._decoder.tile_rows, max(_SMALLEST_TILE, _rounded_up(share)))

    def _run_tiles(self, batch: Batch, rows: int, starts: Iterator[int]) -> None:
        queries = np.zeros((rows, self._decoder.columns), np.float32)
        valid = np.empty(rows, np.bool_)
        for start in starts:
            tile = slice(start, min(start + rows, len(batch)))
            self._run_tile(batch, tile, queries, valid)

    def _run_tile(self, batch: Batch, tile: slice, queries: Rows, valid: NDArray[np.bool_]) -> None:
        count = tile.stop - tile.start
        self._filler.fill(batch, tile, queries[:count], valid[:count])
        batch.complete(tile, queries[:count], valid[:count])
        batch.write(tile, self._decoder.run(queries[: _rounded_up(count)]), valid[:count])


def _rounded_up(rows: int) -> int:
    return -(-rows // _ROW_STEP) * _ROW_STEP

"""The compiled kernel that makes decoder inputs: rows of `queries` from points of an asset.

`examples/hosts/minimal.py` says the same in numpy and is what tests compare with. LANES rows go
through together; only texels are weighed row by row. Positions and lengths are computed in
float64, the rest in float32.
"""

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from numba import types
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled
from rna_sdk.package.block_table import FEATURES, LEARNED_NORMAL
from rna_sdk.package.decoder.query_arrays import INPUT_ARRAYS
from rna_sdk.runtime.kernels.block_columns import first_three
from rna_sdk.runtime.kernels.input_blocks import halfway, put_fiber, put_surface
from rna_sdk.runtime.kernels.lane_memory import load_lanes, load_vectors, store_mask
from rna_sdk.runtime.kernels.lane_vectors import clamped, total, unit
from rna_sdk.runtime.kernels.lanes import LANES, both, everywhere
from rna_sdk.runtime.kernels.texels import (
    CORNERS,
    PLANES,
    prefetch_texels,
    relative,
    store_footprints,
    weighted_texel_sum,
)
from rna_sdk.runtime.kernels.vectors import Rows

QueryKernel = Callable[..., None]

_TEXELS: dict[str, types.Type] = {
    "int8": types.int8,
    "float16": types.uint16,
    "float32": types.float32,
}

_VECTORS = types.Array(types.float32, 2, "C", readonly=True)
_SCALARS = types.Array(types.float32, 1, "C", readonly=True)
_BOX = types.Array(types.float64, 2, "C", readonly=True)
_COLUMNS = types.Array(types.int64, 1, "C", readonly=True)


@cache
def query_kernel(kind: str, channels: int, precision: str) -> QueryKernel:
    """The kernel for an asset of this kind, with planes of this many channels.

    kind: "surface" or "fiber"; precision: of the planes, a planePrecision. The kernel's
    arguments, all C-contiguous and in object space:

        planes      (3 * R * R * channels,) int8, float32, or float16 seen as uint16;
                    R = resolution, 2 or more
        scales      (3 * channels,) float32 of int8 planes, else empty
        resolution  int
        box         (2, 3) float64, lower corner and 1 / extent of the bounds
        columns     int64, of `block_columns`
        of_lobes    bool, of the blocks of lobes: wi is the mirror direction, the half vector n
        positions, axes, h, wo, wi  those of INPUT_ARRAYS; n is LANES or more
        queries     (n, K) float32, written
        valid       (n,) bool, written: False where an argument is NaN or infinite or a
                    direction has no length; such a row of `queries` is zero
    """
    texel = _TEXELS[precision]
    is_fiber = kind == "fiber"  # a constant when the kernel is compiled, as are the channels

    @compiled(
        types.Array(texel, 1, "C", readonly=True),
        _SCALARS,
        types.intp,
        _BOX,
        _COLUMNS,
        types.boolean,
        *(_SCALARS if array.columns == 1 else _VECTORS for array in INPUT_ARRAYS),
        types.float32[:, ::1],
        types.boolean[::1],
    )
    def fill_queries(
        planes: NDArray[Any],
        scales: NDArray[np.float32],
        resolution: int,
        box: NDArray[np.float64],
        columns: NDArray[np.int64],
        of_lobes: bool,
        positions: Rows,
        axes: Rows,
        h: NDArray[np.float32],
        wo: Rows,
        wi: Rows,
        queries: Rows,
        valid: NDArray[np.bool_],
    ) -> None:
        last, side = len(positions) - LANES, float(resolution)
        # Features that are no columns of `queries` are gathered aside.
        gathers = columns[FEATURES] >= 0 or columns[LEARNED_NORMAL] >= 0
        aside = columns[FEATURES] < 0
        gathered = np.empty((LANES, channels), np.float32) if aside else queries
        stride = np.uintp(gathered.shape[1])
        # Of the block at hand and, since its texels are on their way meanwhile, of the next one.
        texels = np.empty(2 * PLANES * LANES, np.uint32)
        weights = np.empty(2 * PLANES * CORNERS * LANES, np.float32)
        blocks = (len(positions) + LANES - 1) // LANES
        for step in range(-1, blocks):
            if gathers and step + 1 < blocks:
                slot = (step + 1) & 1
                x = load_vectors(positions, np.uintp(min((step + 1) * LANES, last)))
                store_footprints(relative(x, box), side, texels, weights, slot)
                for lane in range(LANES):
                    footprint = texels, weights, slot, lane
                    prefetch_texels(planes, channels, resolution, footprint)  # type: ignore[call-arg]
            if step < 0:
                continue
            # The last block begins early enough to be whole: rows made twice come out the same.
            row = min(step * LANES, last)
            first = np.uintp(0 if aside else row) * stride + np.uintp(max(columns[FEATURES], 0))
            for lane in range(LANES if gathers else 0):
                at = first + np.uintp(lane) * stride
                footprint = texels, weights, step & 1, lane
                weighted_texel_sum(planes, scales, channels, resolution, footprint, gathered, at)  # type: ignore[call-arg]
            start = np.uintp(row)
            x = load_vectors(positions, start)
            axis = unit(load_vectors(axes, start))
            o, l = unit(load_vectors(wo, start)), unit(load_vectors(wi, start))  # noqa: E741
            known = both(_finite(total(x)), _finite(total(axis) + total(o) + total(l)))
            p = relative(x, box)
            if is_fiber:
                offset = load_lanes(h, start)
                known = both(known, _finite(offset))
                put_fiber(queries, row, columns, p, axis, clamped(offset), o, l)
            else:
                f = axis  # where no block reads it
                if columns[LEARNED_NORMAL] >= 0:
                    f = first_three(gathered, first, stride, channels)
                m = halfway(axis, axis) if of_lobes else halfway(o, l)
                put_surface(queries, row, columns, p, axis, f, o, l, m)
            store_mask(valid, start, known)
            if not everywhere(known):
                _clear(queries, row, valid)

    return fill_queries


@compiled()
def _finite(x: Any) -> Any:
    """False for NaN and infinities."""
    return x - x == 0.0


@compiled()
def _clear(queries: Rows, row: int, valid: NDArray[np.bool_]) -> None:
    """Rows of a block that are not valid become 0."""
    for i in range(row, row + LANES):
        if not valid[i]:
            queries[i] = np.float32(0.0)

"""The compiled kernel that makes decoder inputs: rows of `queries` from points of an asset.

`queries_reference.py` says the same in numpy and is what tests compare with. Directions are
computed in float64, which costs next to nothing here and keeps 1 - n.h accurate inside a
highlight.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from numba import types
from numpy.typing import NDArray

from rna_sdk.compiled import compiled
from rna_sdk.package.blocks import INPUT_BLOCKS
from rna_sdk.runtime.fiber_blocks import fiber_blocks
from rna_sdk.runtime.surface_blocks import half_vector, highlight, learned_normal
from rna_sdk.runtime.texels import prefetch_texels, relative, triplane_footprint, weighted_texel_sum
from rna_sdk.runtime.vectors import Rows, clamped, first_three, total, unit, vector, write

QueryKernel = Callable[..., None]

_BLOCKS = tuple(INPUT_BLOCKS)
FEATURES = _BLOCKS.index("features")
POSITION = _BLOCKS.index("position")
NORMAL = _BLOCKS.index("normal")
TANGENT = _BLOCKS.index("tangent")
H = _BLOCKS.index("h")
WO = _BLOCKS.index("wo")
WI = _BLOCKS.index("wi")
HALF_VECTOR = _BLOCKS.index("half_vector")
HIGHLIGHT = _BLOCKS.index("highlight")
LEARNED_NORMAL = _BLOCKS.index("learned_normal")
FIBER_ANGLES = _BLOCKS.index("fiber_angles")
FIBER_LOBES = _BLOCKS.index("fiber_lobes")

_ROWS_AHEAD = 16
"""How far ahead of the row being made its texels are fetched: far enough for memory to answer,
near enough that they are still in the first-level cache."""

_TEXELS: dict[str, types.Type] = {
    "int8": types.int8,
    "float16": types.uint16,
    "float32": types.float32,
}

_VECTORS = types.Array(types.float32, 2, "C", readonly=True)
_SCALARS = types.Array(types.float32, 1, "C", readonly=True)
_BOX = types.Array(types.float64, 2, "C", readonly=True)
_COLUMNS = types.Array(types.int64, 1, "C", readonly=True)


def block_columns(inputs: tuple[str, ...], channels: int) -> NDArray[np.int64]:
    """(b,) int64: for each of INPUT_BLOCKS its first column in `queries`; -1 if not in `inputs`.

    inputs: names of INPUT_BLOCKS in the order of the columns; channels: features a texel.
    """
    columns = np.full(len(_BLOCKS), -1, np.int64)
    column = 0
    for name in inputs:
        columns[_BLOCKS.index(name)] = column
        column += INPUT_BLOCKS[name] or channels
    return columns


@cache
def query_kernel(kind: str, channels: int, precision: str) -> QueryKernel:
    """The kernel for an asset of this kind, with planes of this many channels.

    kind: "surface" or "fiber"; precision: of the planes, a planePrecision. The kernel's
    arguments, all C-contiguous and in object space:

        planes      (3 * R * R * channels,) int8, float32, or float16 seen as uint16;
                    R = resolution
        scales      (3 * channels,) float32 of int8 planes, else empty
        resolution  int
        box         (2, 3) float64, lower corner and 1 / extent of the bounds
        columns     int64, of `block_columns`
        positions, axes, h, wo, wi  as in `Batch`
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
        *(_VECTORS, _VECTORS, _SCALARS, _VECTORS, _VECTORS),
        types.float32[:, ::1],
        types.boolean[::1],
    )
    def fill_queries(
        planes: NDArray[Any],
        scales: NDArray[np.float32],
        resolution: int,
        box: NDArray[np.float64],
        columns: NDArray[np.int64],
        positions: Rows,
        axes: Rows,
        h: NDArray[np.float32],
        wo: Rows,
        wi: Rows,
        queries: Rows,
        valid: NDArray[np.bool_],
    ) -> None:
        at_features, at_position = columns[FEATURES], columns[POSITION]
        at_axis = columns[TANGENT] if is_fiber else columns[NORMAL]
        at_h, at_wo, at_wi = columns[H], columns[WO], columns[WI]
        at_half_vector, at_highlight = columns[HALF_VECTOR], columns[HIGHLIGHT]
        at_learned_normal = columns[LEARNED_NORMAL]
        at_angles, at_lobes = columns[FIBER_ANGLES], columns[FIBER_LOBES]
        last = len(positions) - 1
        # Features that are no columns of `queries` are gathered aside.
        gathers = at_features >= 0 or at_learned_normal >= 0
        gathered = queries if at_features >= 0 else np.empty((1, channels), np.float32)
        first = max(at_features, 0)
        for i in range(len(positions)):
            if gathers:
                soon = relative(vector(positions, min(i + _ROWS_AHEAD, last)), box)
                offsets, _ = triplane_footprint(soon, resolution, channels)
                prefetch_texels(planes, offsets)  # type: ignore[call-arg]
            x = vector(positions, i)
            axis, o, l = unit(axes, i), unit(wo, i), unit(wi, i)  # noqa: E741
            everything = total(x) + total(axis) + total(o) + total(l)
            if is_fiber:
                everything += h[i]
            finite = everything - everything == 0.0  # NaN for any NaN or infinity
            valid[i] = finite
            if not finite:
                queries[i] = np.float32(0.0)
                continue
            p = relative(x, box)
            row = i if at_features >= 0 else 0
            if gathers:
                offsets, weights = triplane_footprint(p, resolution, channels)
                at = np.uintp(row * gathered.shape[1] + first)
                weighted_texel_sum(planes, scales, channels, offsets, weights, gathered, at)  # type: ignore[call-arg]
            if at_position >= 0:
                signed = 2.0 * p[0] - 1.0, 2.0 * p[1] - 1.0, 2.0 * p[2] - 1.0
                write(queries, i, at_position, signed)
            if at_axis >= 0:
                write(queries, i, at_axis, axis)
            if at_wo >= 0:
                write(queries, i, at_wo, o)
            if at_wi >= 0:
                write(queries, i, at_wi, l)
            if is_fiber:
                offset = clamped(h[i])
                if at_h >= 0:
                    queries[i, at_h] = np.float32(offset)
                angles, lobes = fiber_blocks(axis, offset, o, l)
                if at_angles >= 0:
                    write(queries, i, at_angles, angles)
                if at_lobes >= 0:
                    write(queries, i, at_lobes, lobes)
            else:
                if at_half_vector >= 0:
                    write(queries, i, at_half_vector, half_vector(axis, o, l))
                if at_highlight >= 0:
                    write(queries, i, at_highlight, highlight(axis, o, l))
                if at_learned_normal >= 0:
                    bend = first_three(gathered, row, first, channels)
                    write(queries, i, at_learned_normal, learned_normal(axis, bend, o, l))

    return fill_queries

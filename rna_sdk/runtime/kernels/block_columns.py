"""Compiled: which columns of `queries` a block has, and what they hold, LANES rows at a time.

The kernels that evaluate and those that train write them so.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.compiled import compiled
from rna_sdk.package.block_table import (
    FIBER_ANGLES,
    FIBER_LOBES,
    HALF_VECTOR,
    HIGHLIGHT,
    LEARNED_NORMAL,
    NORMAL,
    TANGENT,
    H,
)
from rna_sdk.package.blocks import INPUT_BLOCKS
from rna_sdk.runtime.kernels.fiber_blocks import fiber_blocks
from rna_sdk.runtime.kernels.lane_memory import load_column, store_column
from rna_sdk.runtime.kernels.surface_blocks import half_vector, halfway, highlight, learned_normal
from rna_sdk.runtime.kernels.vectors import Rows

_BLOCKS = tuple(INPUT_BLOCKS)


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


@compiled()
def put(queries: Rows, row: int, column: int, values: Any) -> None:
    """Columns of LANES rows from `column` on; none where it is negative."""
    if column < 0:
        return
    width = np.uintp(queries.shape[1])
    for k in range(len(values)):
        at = np.uintp(row) * width + np.uintp(column + k)
        store_column(queries, at, width, values[k])


@compiled()
def put_surface(
    queries: Rows,
    row: int,
    columns: NDArray[np.int64],
    n: Any,
    wo: Any,
    wi: Any,
    bend: Any,
    of_lobes: bool,
) -> None:
    """The blocks of surfaces alone, in LANES rows from `row` on; bend: of `learned_normal`.

    of_lobes: the half vector is n (12.1), which that of wo and its mirror direction is but for
    its sign.
    """
    put(queries, row, columns[NORMAL], n)
    m, opposite = halfway(n, n) if of_lobes else halfway(wo, wi)
    if columns[HALF_VECTOR] >= 0:
        put(queries, row, columns[HALF_VECTOR], half_vector(n, wo, wi, m, opposite))
    if columns[HIGHLIGHT] >= 0:
        put(queries, row, columns[HIGHLIGHT], (highlight(n, m, opposite),))
    if columns[LEARNED_NORMAL] >= 0:
        put(queries, row, columns[LEARNED_NORMAL], learned_normal(n, bend, m, opposite))


@compiled()
def put_fiber(
    queries: Rows, row: int, columns: NDArray[np.int64], t: Any, h: Any, wo: Any, wi: Any
) -> None:
    """The blocks of fibers alone, in LANES rows from `row` on; h in [-1, 1]."""
    put(queries, row, columns[TANGENT], t)
    put(queries, row, columns[H], (h,))
    if columns[FIBER_ANGLES] >= 0 or columns[FIBER_LOBES] >= 0:
        angles, lobes = fiber_blocks(t, h, wo, wi)
        put(queries, row, columns[FIBER_ANGLES], angles)
        put(queries, row, columns[FIBER_LOBES], lobes)


@compiled()
def first_three(features: Rows, first: Any, stride: Any, channels: int) -> Any:
    """The first three features of LANES rows, 0 for missing ones.

    first: where the first row's are in `features`, seen as flat; stride: from row to row.
    """
    x = load_column(features, first, stride)
    y, z = x - x, x - x
    if channels > 1:
        y = load_column(features, first + np.uintp(1), stride)
    if channels > 2:
        z = load_column(features, first + np.uintp(2), stride)
    return x, y, z

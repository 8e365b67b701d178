"""Compiled: which columns of `queries` a block has, and their writing, LANES rows at a time."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.machine.compiled import compiled
from rna_sdk.package.blocks import INPUT_BLOCKS
from rna_sdk.runtime.kernels.lane_memory import load_column, store_column
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

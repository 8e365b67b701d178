"""The query record: the arrays of a decoder's query, a row for each query.

Whatever lists them reads this: batches and their kernel, decoder forms, the files of the
conformance kit and the readers that answer it.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Rows = NDArray[np.float32]


@dataclass(frozen=True)
class QueryArray:
    """An array of queries, float32: (n, 3), or (n,) for one number.

    Attributes:
        is_direction: of any length but zero.
        kind: the kind of part that it is for alone; "" for both.
        is_factor: multiplies results, and is no input of the decoder.
    """

    name: str
    columns: int
    is_direction: bool = False
    kind: str = ""
    is_factor: bool = False


QUERY_ARRAYS = (
    QueryArray("position", 3),
    QueryArray("axis", 3, is_direction=True),  # normal or tangent
    QueryArray("h", 1, kind="fiber"),
    QueryArray("wo", 3, is_direction=True),
    QueryArray("wi", 3, is_direction=True),
    QueryArray("base_color", 3, kind="surface", is_factor=True),
)
"""In the order of a file's columns."""

NEARBY = QueryArray("nearby", 3, is_factor=True)
"""Nearby light, of a tier part that counts it; where a query lacks it, the part's means count."""

INPUT_ARRAYS = tuple(array for array in QUERY_ARRAYS if not array.is_factor)
"""Arrays of the decoder's blocks, in the order of the kernel's arguments."""

_NONE = np.empty(0, np.float32)


def in_order(arrays: Mapping[str, Rows]) -> tuple[Rows, ...]:
    """One array for each of INPUT_ARRAYS; wo, which is checked anyway, for a missing direction.

    Other missing arrays are empty, (0,).
    """
    instead = {array.name: arrays["wo"] if array.is_direction else _NONE for array in INPUT_ARRAYS}
    return tuple(arrays.get(name, other) for name, other in instead.items())


def column_count(names: Iterable[str]) -> int:
    """Columns of a file of queries with these arrays."""
    return sum(array.columns for array in QUERY_ARRAYS if array.name in set(names))


def arrays_of(queries: Rows, names: Iterable[str]) -> dict[str, Rows]:
    """The arrays of these names in (n, columns) rows of a file of queries."""
    result, column, names = {}, 0, set(names)
    for array in (array for array in QUERY_ARRAYS if array.name in names):
        columns = queries[:, column : column + array.columns]
        column += array.columns
        result[array.name] = np.ascontiguousarray(columns[:, 0] if array.columns == 1 else columns)
    return result

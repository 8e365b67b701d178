"""Checks of callers' arrays before compiled code reads them."""

import numpy as np
from numpy.typing import NDArray

from rna_sdk.errors import QueryError


def vectors(
    name: str, value: object, count: int | None = None, columns: int = 3
) -> NDArray[np.float32]:
    """`value` as a C-contiguous (n, columns) float32 array, copied only if it is not contiguous.

    Raises:
        QueryError: it is not such an array, or does not have `count` rows.
    """
    return _rows(name, value, count, (columns,))


def scalars(name: str, value: object, count: int | None = None) -> NDArray[np.float32]:
    """`value` as a C-contiguous (n,) float32 array, copied only if it is not contiguous.

    Raises:
        QueryError: it is not such an array, or does not have `count` elements.
    """
    return _rows(name, value, count, ())


def indices(name: str, value: object, size: int) -> NDArray[np.int64]:
    """`value` as a C-contiguous (n,) int64 array.

    Raises:
        QueryError: it is not an (n,) array of integers, or one of them is outside [0, size).
    """
    if not isinstance(value, np.ndarray):
        raise QueryError(f"{name}: expected an (n,) integer array, found {type(value).__name__}")
    if value.ndim != 1 or not np.issubdtype(value.dtype, np.integer):
        found = f"{value.shape} {value.dtype}"
        raise QueryError(f"{name}: expected an (n,) integer array, found {found}")
    check_numbers(name, value, size)
    return np.ascontiguousarray(value, np.int64)


def check_numbers(name: str, numbers: NDArray[np.integer], size: int) -> None:
    """Raises QueryError unless all `numbers` of triangles or segments are within [0, size)."""
    if len(numbers) and not 0 <= int(numbers.min()) <= int(numbers.max()) < size:
        raise QueryError(f"{name}: a number is outside [0, {size})")


def first_not_finite(rows: NDArray[np.floating]) -> int | None:
    """The first row of (n, k) with NaN or infinity; None if there is none."""
    finite = np.isfinite(rows).all(axis=1)
    return None if finite.all() else int(np.argmin(finite))


def _rows(name: str, value: object, count: int | None, row: tuple[int, ...]) -> NDArray[np.float32]:
    shape = ", ".join(map(str, ("n" if count is None else count, *row)))
    expected = f"({shape}{'' if row else ','}) float32 array"
    if not isinstance(value, np.ndarray):
        raise QueryError(f"{name}: expected a {expected}, found {type(value).__name__}")
    wrong_shape = value.ndim != 1 + len(row) or value.shape[1:] != row
    if wrong_shape or value.dtype != np.float32 or count not in (None, len(value)):
        raise QueryError(f"{name}: expected a {expected}, found {value.shape} {value.dtype}")
    return np.require(value, requirements=["C", "ALIGNED"])

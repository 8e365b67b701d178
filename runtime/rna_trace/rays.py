"""Checks that every batch of rays passes before compiled code reads it."""

import numpy as np

from rna_sdk.errors import QueryError


def per_ray(
    name: str, values: np.ndarray | float, count: int, dtype: type = np.float32
) -> np.ndarray:
    """`values`, one number or one a ray, as a contiguous (1,) or (count,) array of `dtype`.

    Raises QueryError for another shape.
    """
    array: np.ndarray = np.asarray(values, dtype)
    if array.shape not in ((), (count,)):
        raise QueryError(f"{name}: expected one number or shape ({count},), found {array.shape}")
    return np.ascontiguousarray(array.reshape(-1))

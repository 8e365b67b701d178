"""Blender's attributes as arrays."""

from __future__ import annotations

from typing import Any

import numpy as np


def read(collection: Any, attribute: str, size: int, dtype: type = np.float32) -> np.ndarray:
    """(size,) all values of one attribute of a collection of Blender's."""
    values: np.ndarray = np.empty(size, dtype)
    collection.foreach_get(attribute, values)
    return values

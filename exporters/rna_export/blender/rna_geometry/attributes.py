"""Blender's attributes as arrays."""

from typing import Any

import numpy as np


def read(collection: Any, attribute: str, size: int, dtype: type = np.float32) -> np.ndarray:
    """(size,) all values of one attribute of a collection of Blender's."""
    values: np.ndarray = np.empty(size, dtype)
    collection.foreach_get(attribute, values)
    return values


def uv_map(mesh: Any, name: str) -> np.ndarray | None:
    """(loops, 2) a UV map of a mesh, "" for the one that renders use by default; None without."""
    layers = mesh.uv_layers
    layer = (
        layers.get(name) if name else next((each for each in layers if each.active_render), None)
    )
    return None if layer is None else read(layer.uv, "vector", 2 * len(mesh.loops)).reshape(-1, 2)

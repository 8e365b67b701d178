"""Batches of queries: scattered over an asset, and coherent as from a camera."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Arrays = tuple[Any, ...]
"""Arguments of `evaluate`, float32."""


def random_points(n: int) -> Arrays:
    """Points all over the box and all directions: no query is near the one before it."""
    rng = np.random.default_rng(1)
    positions = rng.uniform(-1, 1, (n, 3)).astype(np.float32)
    return positions, *(unit(rng.normal(size=(n, 3))) for _ in range(3))


def sphere_scan(n: int) -> Arrays:
    """Camera hits on a ball, row of pixels by row, under one distant light."""
    side = int(np.ceil(np.sqrt(n)))
    x, y = np.meshgrid(np.linspace(-0.7, 0.7, side), np.linspace(0.7, -0.7, side))
    normals = unit(np.stack([x, y, np.sqrt(1 - x**2 - y**2)], axis=2).reshape(-1, 3)[:n])
    positions = np.float32(0.95) * normals
    wo = unit(np.array([0, 0, 5]) - positions)
    wi = np.broadcast_to(unit(np.array([[1, 2, 3]])), (n, 3)).copy()
    return positions, normals, wo, wi


def unit(vectors: NDArray[np.floating]) -> NDArray[np.float32]:
    return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32)

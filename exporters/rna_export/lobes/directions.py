"""Sets of directions, and random rotations."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def random_directions(count: int, rng: np.random.Generator) -> np.ndarray:
    """Unit, (count, 3) float64."""
    d = rng.normal(size=(count, 3))
    return np.asarray(d / np.linalg.norm(d, axis=1, keepdims=True))


def even_directions(count: int) -> NDArray[np.float32]:
    """Unit, (count, 3) float32, evenly spread: a Fibonacci spiral."""
    k = np.arange(count) + 0.5
    z, phi = 1 - 2 * k / count, k * np.pi * (3 - np.sqrt(5))
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(phi), z, r * np.sin(phi)], axis=1).astype(np.float32)


def random_rotations(count: int, rng: np.random.Generator) -> NDArray[np.float32]:
    """Uniform, (count, 3, 3) float32: from unit quaternions."""
    q = rng.normal(size=(count, 4))
    w, x, y, z = (q / np.linalg.norm(q, axis=1, keepdims=True)).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows, np.float32), 2, 0)

"""Sets of directions, random rotations, and real spherical harmonics up to degree 3."""

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


def harmonics(directions: NDArray[np.floating]) -> NDArray[np.float32]:
    """All 16 spherical harmonics, orthonormal, in unit directions (n, 3): (n, 16) float32."""
    x, y, z = np.asarray(directions, np.float64).T
    terms = [
        (1.0, np.ones_like(x)),
        (3.0, y),
        (3.0, z),
        (3.0, x),
        (15.0, x * y),
        (15.0, y * z),
        (5.0 / 4.0, 3 * z * z - 1),
        (15.0, x * z),
        (15.0 / 4.0, x * x - y * y),
        (35.0 / 8.0, y * (3 * x * x - y * y)),
        (105.0, x * y * z),
        (21.0 / 8.0, y * (5 * z * z - 1)),
        (7.0 / 4.0, z * (5 * z * z - 3)),
        (21.0 / 8.0, x * (5 * z * z - 1)),
        (105.0 / 4.0, z * (x * x - y * y)),
        (35.0 / 8.0, x * (x * x - 3 * y * y)),
    ]
    columns = [np.sqrt(factor / (4 * np.pi)) * term for factor, term in terms]
    return np.stack(columns, axis=1).astype(np.float32)

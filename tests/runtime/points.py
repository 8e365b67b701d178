"""Points to ask an asset about."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Points:
    """Arguments of Asset.evaluate, each (n, 3) float32."""

    positions: NDArray[np.float32]
    normals: NDArray[np.float32]
    wo: NDArray[np.float32]
    wi: NDArray[np.float32]

    def __getitem__(self, rows: slice | NDArray[np.int64]) -> Points:
        return Points(*(array[rows] for array in self))

    def __iter__(self) -> Iterator[NDArray[np.float32]]:
        return iter((self.positions, self.normals, self.wo, self.wi))


def random_points(n: int, seed: int = 0, reach: float = 1.2) -> Points:
    """Positions in a cube of half-side `reach`, and uniform directions."""
    rng = np.random.default_rng(seed)
    positions = rng.uniform(-reach, reach, (n, 3)).astype(np.float32)
    return Points(positions, *(unit_vectors(rng, n) for _ in range(3)))


def unit_vectors(rng: np.random.Generator, n: int) -> NDArray[np.float32]:
    """Uniform directions, (n, 3) float32."""
    vectors = rng.normal(size=(n, 3))
    return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32)

"""Points to ask an asset about."""

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Self

import numpy as np
from numpy.typing import NDArray

from rna_sdk.runtime import Asset

Rows = NDArray[np.float32]


class Arrays:
    """The arguments of an asset's `evaluate`, in order."""

    def __iter__(self) -> Iterator[Rows]:
        return (getattr(self, field.name) for field in fields(self))  # type: ignore[arg-type]

    def __getitem__(self, rows: slice | NDArray[np.int64]) -> Self:
        return type(self)(*(array[rows] for array in self))


@dataclass(frozen=True)
class Points(Arrays):
    """Arguments of SurfaceAsset.evaluate, each (n, 3) float32."""

    positions: Rows
    normals: Rows
    wo: Rows
    wi: Rows


@dataclass(frozen=True)
class FiberPoints(Arrays):
    """Arguments of FiberAsset.evaluate, (n, 3) float32 each but h, (n,) float32."""

    positions: Rows
    tangents: Rows
    h: Rows
    wo: Rows
    wi: Rows


def random_points(n: int, seed: int = 0, reach: float = 1.2) -> Points:
    """Positions in a cube of half-side `reach`, and uniform directions."""
    rng = np.random.default_rng(seed)
    positions = rng.uniform(-reach, reach, (n, 3)).astype(np.float32)
    return Points(positions, *(unit_vectors(rng, n) for _ in range(3)))


def random_fiber_points(n: int, seed: int = 0, reach: float = 1.2) -> FiberPoints:
    """The like of `random_points`, with h from -1 to 1."""
    points = random_points(n, seed, reach)
    h = np.random.default_rng(seed).uniform(-1, 1, n).astype(np.float32)
    return FiberPoints(points.positions, points.normals, h, points.wo, points.wi)


def points_for(asset: Asset, n: int, seed: int = 0, reach: float = 1.2) -> Points | FiberPoints:
    """Random points of the asset's kind."""
    draw = random_fiber_points if asset.kind == "fiber" else random_points
    return draw(n, seed, reach)


def unit_vectors(rng: np.random.Generator, n: int) -> Rows:
    """Uniform directions, (n, 3) float32."""
    vectors = rng.normal(size=(n, 3))
    return (vectors / np.linalg.norm(vectors, axis=1, keepdims=True)).astype(np.float32)

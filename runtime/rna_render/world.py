"""The scene as it is traced: instances of bodies, in an order that keeps each asset's together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numba import njit, prange

from rna_render.bodies import Asset, make_body
from rna_render.instances import InstanceScene
from rna_sdk.runtime.transforms import Transform


@dataclass(frozen=True)
class Placement:
    """An asset, and where it stands."""

    asset: Asset
    world_from_object: np.ndarray  # (4, 4), a similarity


class World:
    """Instances of assets, in an order of their own: all instances of an asset are neighbours.

    So hits sorted by instance are sorted by asset too, and `asset_ranges` can cut them.

    placements: the scene's assets, in the order of its file; the same object twice is one asset
    with two instances. Raises QueryError for a transform that is not a similarity.

    Attributes:
        bodies: the assets, each once.
        scene: all instances, in Embree.
        number: (k,) int32, for each instance its place in `placements`, counted from 1.
        scale: (k,) float32, world units an object unit.
    """

    def __init__(self, placements: Sequence[Placement]) -> None:
        groups: dict[int, list[int]] = {}
        for index, placement in enumerate(placements):
            groups.setdefault(id(placement.asset), []).append(index)
        order = [index for group in groups.values() for index in group]
        self.bodies = [make_body(placements[group[0]].asset) for group in groups.values()]
        # Asset a has the instances from first[a] up to first[a + 1].
        self._first = np.cumsum([0] + [len(group) for group in groups.values()])
        self.number = np.asarray(order, np.int32) + 1
        transforms = [Transform(placements[index].world_from_object) for index in order]
        scale = np.array([transform.scale for transform in transforms])
        self.scale = scale.astype(np.float32)
        self._matrices = np.array([transform.matrix for transform in transforms])
        self._rotations = self._matrices[:, :3, :3] / scale[:, None, None]
        owners = np.repeat(np.arange(len(self.bodies)), np.diff(self._first))
        self.scene = InstanceScene(
            [
                (self.bodies[owner].scene, matrix)
                for owner, matrix in zip(owners, self._matrices, strict=True)
            ]
        )

    def asset_ranges(self, instance: np.ndarray) -> list[tuple[int, slice]]:
        """For each asset that is hit, its place in `bodies` and its rows.

        instance: (n,) int32, ascending.
        """
        cuts = np.searchsorted(instance, self._first)
        return [
            (asset, slice(start, stop))
            for asset, (start, stop) in enumerate(pairwise(cuts))
            if start < stop
        ]

    def to_world_points(self, instance: np.ndarray, points: np.ndarray) -> np.ndarray:
        """Object-space points (n, 3) float32 of the given instances, in the world."""
        linear, translation = self._matrices[:, :3, :3], self._matrices[:, :3, 3]
        return _transformed(linear, translation, instance, points)

    def to_world_normals(self, instance: np.ndarray, normals: np.ndarray) -> np.ndarray:
        """Object-space unit normals (n, 3) float32 of the given instances, in the world."""
        return _transformed(self._rotations, self._no_shift, instance, normals)

    def to_object_directions(
        self, instance: np.ndarray, directions_world: np.ndarray
    ) -> np.ndarray:
        """World-space unit directions (n, 3) float32, in the given instances' object space."""
        inverse = self._rotations.transpose(0, 2, 1)
        return _transformed(inverse, self._no_shift, instance, directions_world)

    @property
    def _no_shift(self) -> np.ndarray:
        return np.zeros((len(self.number), 3))


def _transformed(
    linear: np.ndarray, shift: np.ndarray, instance: np.ndarray, vectors: np.ndarray
) -> np.ndarray:
    result = np.empty_like(vectors)
    _transform(np.ascontiguousarray(linear), np.ascontiguousarray(shift), instance, vectors, result)
    return result


@njit(cache=True, parallel=True)
def _transform(linear, shift, instance, vectors, result):
    for i in prange(len(instance)):
        k = instance[i]
        for row in range(3):
            value = shift[k, row]
            for column in range(3):
                value += linear[k, row, column] * vectors[i, column]
            result[i, row] = value

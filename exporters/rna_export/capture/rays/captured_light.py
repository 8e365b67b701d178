"""Lights of a capture: distant suns, and lamps near the asset."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.capture_directions import sphere

NEAREST, FARTHEST = 0.3, 10.0
"""Distances of lamps from the asset's middle, in its sizes."""
_CLEARANCE = 0.05  # least distance from the asset, sizes
_OPEN = 0.1  # least share of the directions from a lamp that miss the asset
_PROBES, _TRIES = 256, 32


@dataclass(frozen=True)
class Sun:
    """A distant light of irradiance 1; wi: (3,) float32, unit, towards it."""

    wi: np.ndarray

    def directions(self, x: np.ndarray) -> np.ndarray:
        """Unit directions towards the light from points (n, 3): (n, 3) float32."""
        return np.ascontiguousarray(np.broadcast_to(self.wi.astype(np.float32), x.shape))

    def distances(self, x: np.ndarray) -> np.ndarray:
        """(n,) float32."""
        return np.full(len(x), np.inf, np.float32)

    def inverse_distances(self, x: np.ndarray) -> np.ndarray:
        """1 over the distances from points (n, 3) in sizes of the asset, (n,) float32."""
        return np.zeros(len(x), np.float32)


@dataclass(frozen=True)
class Lamp:
    """A point light at `position`, (3,) float32; size: the asset's, its box's longest side."""

    position: np.ndarray
    size: float

    def directions(self, x: np.ndarray) -> np.ndarray:
        """Unit directions towards the light from points (n, 3): (n, 3) float32."""
        towards = self.position - x
        unit = towards / np.linalg.norm(towards, axis=1, keepdims=True)
        return np.ascontiguousarray(unit, np.float32)

    def distances(self, x: np.ndarray) -> np.ndarray:
        """(n,) float32."""
        return np.asarray(np.linalg.norm(self.position - x, axis=1), np.float32)

    def inverse_distances(self, x: np.ndarray) -> np.ndarray:
        """1 over the distances from points (n, 3) in sizes of the asset, (n,) float32."""
        return np.asarray(self.size / self.distances(x), np.float32)


Light = Sun | Lamp


def is_near(number: int, share: float) -> bool:
    """Whether the light of this number is a lamp: evenly spread, this share of any range."""
    return int((number + 1) * share) > int(number * share)


def lamp_near(scene: AssetScene, wi: np.ndarray, rng: np.random.Generator) -> Lamp:
    """A lamp in direction wi (3,) from the asset's middle, outside of the asset.

    Its distance d, in sizes, is uniform in 1 / (1 + d) from NEAREST to FARTHEST.
    """
    low, high = 1.0 / (1.0 + FARTHEST), 1.0 / (1.0 + NEAREST)
    for _ in range(_TRIES):
        d = 1.0 / rng.uniform(low, high) - 1.0
        lamp = lamp_at(scene, wi, d)
        if _is_outside(scene, lamp, rng):
            return lamp
    return lamp_at(scene, wi, FARTHEST)


def lamp_at(scene: AssetScene, wi: np.ndarray, distance: float) -> Lamp:
    """A lamp in direction wi (3,) from the asset's middle, `distance` of its sizes away."""
    position = scene.centre + np.float32(distance * scene.size) * wi
    return Lamp(position.astype(np.float32), scene.size)


def _is_outside(scene: AssetScene, lamp: Lamp, rng: np.random.Generator) -> bool:
    """Whether a lamp is neither inside the asset nor next to its surface."""
    directions = sphere(rng.random((_PROBES, 2)))
    distance = scene.distance(np.tile(lamp.position, (_PROBES, 1)), directions)
    is_clear = distance.min() > _CLEARANCE * scene.size
    return bool(is_clear and np.isinf(distance).mean() > _OPEN)

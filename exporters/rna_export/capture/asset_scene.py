"""The exported geometry in Embree: the very intersection code that the renderer uses."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Protocol

import numpy as np


class ShadePoints(Protocol):
    """Where rays met the asset; every array has one row a ray, rows without a hit are zero."""

    hit: np.ndarray  # (n,) bool
    position: np.ndarray  # (n, 3) float32
    geometric_normal: np.ndarray  # (n, 3) float32

    def sample_fields(self) -> Mapping[str, np.ndarray]:
        """What a sample records of the point, but for its directions: name -> rows."""


class AssetScene(ABC):
    """Ray queries against one asset's geometry.

    Attributes:
        centre: (3,) float32, of the bounding box; radius: of the sphere around it.
    """

    centre: np.ndarray
    radius: float

    @abstractmethod
    def distance(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """How far rays (n, 3) go before they meet the asset, (n,); inf: never."""

    @abstractmethod
    def shade_points(self, origins: np.ndarray, directions: np.ndarray) -> ShadePoints:
        """First hits of rays (n, 3), with everything that a sample records."""

    @abstractmethod
    def sample_points(self, n: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """n points uniform by area and their geometric normals, (n, 3) float32 each."""

    @abstractmethod
    def highlight_views(
        self, points: ShadePoints, wi: np.ndarray, rng: np.random.Generator
    ) -> tuple[np.ndarray, np.ndarray]:
        """View directions at which light from wi (3,) makes highlights on the points.

        Returns the rows (k,) that have one, and the unit directions (k, 3).
        """

    @abstractmethod
    def visible(self, points: ShadePoints, wi: np.ndarray) -> np.ndarray:
        """Whether wi (n, 3) is free of the asset itself at each point, (n,) bool."""

    def hit_mask(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """Which rays hit, (n,) bool."""
        return np.isfinite(self.distance(origins, directions))

    def free_distance(self, points: np.ndarray, normals: np.ndarray, wo: np.ndarray) -> np.ndarray:
        """How far a ray leaves points (n, 3) along wo before it meets the asset; inf: never."""
        return self.distance(points + np.float32(1e-4 * self.radius) * normals, wo)

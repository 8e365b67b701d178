"""The image while it is rendered: the mean of the finished samples, with its AOVs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np


@dataclass
class Layers:
    """One sample, or the mean of many, of every pixel in row-major order.

    beauty: (n, 4) float, RGB radiance with the background in it, and coverage by assets and
        visible background.
    hit: (n,) float, coverage by assets.
    normal_world: (n, 3) float, where an asset is hit the shading normal of the surface or the
        outward normal of the fiber, else 0.
    position_world: (n, 3) float, likewise.
    visibility: (n,) float, likewise: whether the first directional or point light is seen.
    asset: (n,) uint32, number of the instance in the scene file, from 1; 0 for none.
    """

    beauty: np.ndarray
    hit: np.ndarray
    normal_world: np.ndarray
    position_world: np.ndarray
    visibility: np.ndarray
    asset: np.ndarray

    @classmethod
    def empty(cls, count: int, dtype: type) -> Layers:
        """All zero, for `count` pixels."""
        widths = {"beauty": (4,), "normal_world": (3,), "position_world": (3,)}
        floats = {
            name: np.zeros((count, *widths.get(name, ())), dtype)
            for name in ("beauty", "hit", "normal_world", "position_world", "visibility")
        }
        return cls(**floats, asset=np.zeros(count, np.uint32))

    @classmethod
    def concatenate(cls, bands: Sequence[Layers]) -> Layers:
        """The bands, one after the other."""
        names = [field.name for field in fields(cls)]
        return cls(*(np.concatenate([getattr(band, name) for band in bands]) for name in names))


class Film:
    """Sums samples. A sample enters whole or not at all, so a stopped image is a fair mean."""

    def __init__(self, resolution: tuple[int, int]) -> None:
        self.width, self.height = resolution
        self.samples = 0
        self._sum = Layers.empty(self.width * self.height, np.float64)

    def add(self, sample: Layers) -> None:
        """Add one sample of every pixel."""
        total = self._sum
        total.beauty += sample.beauty
        total.hit += sample.hit
        total.normal_world += sample.normal_world
        total.position_world += sample.position_world
        total.visibility += sample.visibility
        # The id of the first sample that hit anything: ids have no mean.
        np.copyto(total.asset, sample.asset, where=total.asset == 0)
        self.samples += 1

    def channels(self) -> dict[str, np.ndarray]:
        """The image, (height, width) a channel; float32, but uint32 for assetId.

        R, G, B, A are means over all samples, so RGB is premultiplied. The other channels are
        means over the samples that hit an asset: normal.X/Y/Z (unit, or zero), position.X/Y/Z
        and visibility; assetId is that of the first sample that did.
        """
        total, count = self._sum, max(self.samples, 1)
        hits = np.maximum(total.hit, 1.0)[:, None]
        length = np.linalg.norm(total.normal_world, axis=1, keepdims=True)
        normal = total.normal_world / np.where(length > 0.0, length, 1.0)
        named = [
            ("RGBA", "", total.beauty / count),
            ("XYZ", "normal.", normal),
            ("XYZ", "position.", total.position_world / hits),
        ]
        result = {
            prefix + letter: self._plane(values[:, column].astype(np.float32))
            for letters, prefix, values in named
            for column, letter in enumerate(letters)
        }
        result["visibility"] = self._plane((total.visibility / hits[:, 0]).astype(np.float32))
        result["assetId"] = self._plane(total.asset)
        return result

    def _plane(self, values: np.ndarray) -> np.ndarray:
        return np.ascontiguousarray(values.reshape(self.height, self.width))

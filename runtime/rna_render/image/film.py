"""The image while it is rendered: the mean of the finished samples, with its AOVs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np

from rna_render.image.halves import Halves
from rna_sdk.machine.compiled import compiled
from rna_sdk.machine.memory import check_memory


@dataclass
class Layers:
    """One sample, or the sum of many, of every pixel in row-major order.

    beauty: (n, 4) float, RGB radiance with the background in it, and coverage by objects and
        visible background.
    groups: (n, g, 3) float, the part of beauty that comes from each group of lights.
    hit: (n,) float, coverage by objects.
    normal_world: (n, 3) float, where an object is hit the shading normal of the surface or the
        outward normal of the fiber, else 0.
    position_world: (n, 3) float, likewise.
    motion: (n, 2) float, likewise, pixels to the right and down to where the point is in the next
        frame.
    light_samples: (n, 2) float, how many samples of lights were taken at the first hit, and how
        many of them nothing stood in the way of.
    caught: (n, 2) float, where a shadow catcher is hit the light that it receives, and what it
        would receive if nothing stood in the way.
    behind_catcher: (n, 4) float, as beauty, the visible background where a catcher is hit.
    groups_behind: (n, g, 3) float, as groups, the same.
    catcher: (n,) float, coverage by shadow catchers.
    clamped: (n,) float, mean of RGB of the radiance that the clamp on indirect light took.
    squares: (n, 3) float64, squares of the RGB of beauty, of each sample by itself.
    asset: (n,) uint32, number of the object, from 1; 0 for none. Of several samples the
        first hit counts.
    """

    beauty: np.ndarray
    groups: np.ndarray
    hit: np.ndarray
    normal_world: np.ndarray
    position_world: np.ndarray
    motion: np.ndarray
    light_samples: np.ndarray
    caught: np.ndarray
    behind_catcher: np.ndarray
    groups_behind: np.ndarray
    catcher: np.ndarray
    clamped: np.ndarray
    squares: np.ndarray
    asset: np.ndarray

    @classmethod
    def empty(cls, count: int, groups: int, dtype: type) -> Layers:
        """All zero, for `count` pixels."""
        shapes = {
            "beauty": (4,),
            "groups": (groups, 3),
            "hit": (),
            "normal_world": (3,),
            "position_world": (3,),
            "motion": (2,),
            "light_samples": (2,),
            "caught": (2,),
            "behind_catcher": (4,),
            "groups_behind": (groups, 3),
            "catcher": (),
            "clamped": (),
        }
        floats: dict[str, np.ndarray] = {
            name: np.zeros((count, *shape), dtype) for name, shape in shapes.items()
        }
        return cls(**floats, squares=np.zeros((count, 3)), asset=np.zeros(count, np.uint32))

    @classmethod
    def concatenate(cls, bands: Sequence[Layers]) -> Layers:
        """The bands, one after the other."""
        if len(bands) == 1:
            return bands[0]
        names = [field.name for field in fields(cls)]
        return cls(*(np.concatenate([getattr(band, name) for band in bands]) for name in names))


class Film:
    """Sums samples. A sample enters whole or not at all, so a stopped image is a fair mean.

    resolution: width and height. groups: names of the groups of lights. Raises RnaError where it
    does not fit into memory.
    """

    def __init__(self, resolution: tuple[int, int], groups: Sequence[str] = ()) -> None:
        self.width, self.height = resolution
        self.samples = 0
        self.groups = tuple(groups)
        count = self.width * self.height
        pixel = Layers.empty(1, len(groups), np.float64)
        bytes_a_pixel = sum(getattr(pixel, field.name).nbytes for field in fields(Layers))
        bytes_a_pixel += Halves.empty(1).nbytes
        check_memory(count * bytes_a_pixel, f"an image of {self.width} x {self.height} pixels")
        self._sum = Layers.empty(count, len(groups), np.float64)
        self._halves = Halves.empty(count)

    def add(self, bands: Sequence[Layers], samples: int = 1) -> None:
        """Add one sample of every pixel, or the sum of several: bands, one after the other."""
        start = 0
        for band in bands:
            self._add(slice(start, start := start + len(band.hit)), band)
        self.samples += samples
        self._halves.follow(self._sum.beauty[:, :3], self.samples)

    def _add(self, pixels: slice, band: Layers) -> None:
        for field in fields(Layers):
            values = getattr(band, field.name)
            total = getattr(self._sum, field.name)[pixels]
            if field.name == "asset":
                _keep_first(total, values)  # numbers have no mean
            elif values.size:
                _add_to(*(v.reshape(len(v), -1) for v in (total, values)))

    def put(self, start: int, part: Film) -> None:
        """Take over all samples of some pixels from `start` on, of which another film is made."""
        end = start + part.width * part.height
        for field in fields(Layers):
            getattr(self._sum, field.name)[start:end] = getattr(part._sum, field.name)
        self._halves.put(slice(start, end), part._halves)
        self.samples = part.samples

    def arrays(self) -> dict[str, np.ndarray]:
        """State from which `of_arrays` restores a film of the same pixels."""
        layers = {field.name: getattr(self._sum, field.name) for field in fields(Layers)}
        return {**layers, **self._halves.arrays(), "samples": np.array([self.samples])}

    @classmethod
    def of_arrays(cls, arrays: dict[str, np.ndarray], groups: Sequence[str]) -> Film:
        """The film of a row of pixels, from its `arrays`."""
        film = cls((len(arrays["asset"]), 1), groups)
        film._sum = Layers(**{field.name: arrays[field.name] for field in fields(Layers)})
        film._halves = Halves.of_arrays(arrays)
        film.samples = int(arrays["samples"][0])
        return film

    def variance(self) -> np.ndarray | None:
        """Variance of RGB, the mean of all samples, (height, width, 3) float32; None of one sample.

        See `Halves`. The variance in `channels` is of independent samples, several times
        larger.
        """
        if self._halves.samples < 2:
            return None
        variance = self._halves.variance * (self._halves.samples / self.samples)
        return _float32(variance.reshape(self.height, self.width, 3))

    @property
    def clamped_share(self) -> float:
        """Light removed by the clamp on indirect light, as a share of the image's light."""
        taken = float(self._sum.clamped.sum())
        kept = float(self._sum.beauty[:, :3].sum()) / 3.0
        return taken / (taken + kept) if taken > 0.0 else 0.0

    def not_finite(self) -> np.ndarray:
        """Pixels with a value that is NaN or infinite, in row-major order: (k,) int64."""
        layers = [getattr(self._sum, field.name) for field in fields(Layers)]
        bad = [~np.isfinite(v.reshape(len(v), -1)).all(1) for v in layers if v.size]
        return np.flatnonzero(np.any(bad, axis=0))

    def channels(self) -> dict[str, np.ndarray]:
        """The image, (height, width) a channel; float32, but uint32 for assetId.

        R, G, B, A are means over all samples, so RGB is premultiplied; variance.R/G/B are the
        variances of these means, taken as if samples were independent; light.<group>.R/G/B the
        parts of groups of lights. The other channels are means over the samples that hit a
        object: normal.X/Y/Z (unit, or zero), position.X/Y/Z, forward.u/v (pixels to the right and
        up, to the next frame) and visibility; assetId is of the first of these.
        """
        total, count = self._sum, max(self.samples, 1)
        lit = self._lit()
        groups = (total.groups + total.groups_behind * lit[:, None, None]) / count
        hits = np.maximum(total.hit, 1.0)[:, None]
        length = np.linalg.norm(total.normal_world, axis=1, keepdims=True)
        normal = total.normal_world / np.where(length > 0.0, length, 1.0)
        mean = total.beauty / count
        spread = np.maximum(total.squares / count - np.square(mean[:, :3]), 0.0)
        named = [
            ("RGBA", "", mean + self._shadows(lit) / count),
            ("RGB", "variance.", spread / max(count - 1, 1)),
            *(("RGB", f"light.{name}.", groups[:, g]) for g, name in enumerate(self.groups)),
            ("XYZ", "normal.", normal),
            ("XYZ", "position.", total.position_world / hits),
            ("uv", "forward.", total.motion / hits * [1.0, -1.0]),
        ]
        result = {
            prefix + letter: self._plane(_float32(values[:, column]))
            for letters, prefix, values in named
            for column, letter in enumerate(letters)
        }
        taken, arrived = total.light_samples.T
        result["visibility"] = self._plane((arrived / np.maximum(taken, 1.0)).astype(np.float32))
        result["assetId"] = self._plane(total.asset)
        return result

    def _lit(self) -> np.ndarray:
        """Part of the light that arrives at shadow catchers: (n,)."""
        received, unblocked = self._sum.caught.T
        lit: np.ndarray = np.ones_like(received)
        np.divide(received, unblocked, out=lit, where=unblocked > 0.0)
        return lit

    def _shadows(self, lit: np.ndarray) -> np.ndarray:
        """Contribution of shadow catchers to the sum of beauty: darkened background and alpha."""
        result: np.ndarray = self._sum.behind_catcher * lit[:, None]
        result[:, 3] += (1.0 - lit) * self._sum.catcher
        return result

    def _plane(self, values: np.ndarray) -> np.ndarray:
        return np.ascontiguousarray(values.reshape(self.height, self.width))


def _float32(values: np.ndarray) -> np.ndarray:
    """Variances are squares: those of light near the largest number stay finite, too."""
    largest = np.finfo(np.float32).max
    return np.asarray(np.clip(values, -largest, largest), np.float32)


@compiled(fastmath=())
def _add_to(total: np.ndarray, values: np.ndarray) -> None:
    """Add (n, c) values to (n, c) float64 sums.

    Memory of layers that a scene lacks, which are 0, is never touched. One thread: memory sets the
    pace, and the others render.
    """
    for k in range(len(values)):
        for c in range(values.shape[1]):
            if values[k, c] != 0.0:
                total[k, c] += values[k, c]


@compiled(fastmath=())
def _keep_first(stored: np.ndarray, numbers: np.ndarray) -> None:
    """Take over (n,) numbers where (n,) those stored are still 0."""
    for k in range(len(numbers)):
        if stored[k] == 0:
            stored[k] = numbers[k]

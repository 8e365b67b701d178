"""Captured images under one light: of one part, and of all parts together."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Protocol

import numpy as np

from rna_export.capture.dataset.asset_arguments import (
    Arguments,
    emission_arguments,
    evaluate_arguments,
)
from rna_sdk.runtime import FiberAsset, SurfaceAsset

_NO_QUERY = ("radiance", "direct", "visible", "pixel", "weight")


class CapturedImage(Protocol):
    """A reference image that a model is scored against."""

    @property
    def index(self) -> int:
        """Number of the image in its dataset."""

    @property
    def resolution(self) -> int:
        """Pixels along a side."""

    @property
    def reference(self) -> np.ndarray:
        """Captured radiance of the rows, (n, 3) float32."""

    @property
    def halves(self) -> np.ndarray:
        """Two independent estimates of it, (2, n, 3) float32."""

    @property
    def is_of_strands(self) -> bool:
        """Whether all that it shows is strands."""

    def image(self, values: np.ndarray) -> np.ndarray:
        """Rows (n, 3) as an image (resolution, resolution, 3), zero where there is no row."""


@dataclass(frozen=True)
class ValidationView:
    """One part in a captured image; rows are the pixels that hit the part."""

    index: int
    resolution: int
    pixel: np.ndarray  # (n,) int32, row * resolution + column
    samples: dict[str, np.ndarray]  # fields of SAMPLE_FIELDS; radiance is the mean of both halves
    halves: np.ndarray  # (2, n, 3) float32, two independent estimates of radiance
    # (samples, lengths) -> nearby light of the rows, (n, 3) float32; None where rows are not traced
    trace_nearby: Callable[[dict[str, np.ndarray], tuple[float, ...]], np.ndarray] | None = None

    def nearby(self, lengths: tuple[float, ...] | None) -> np.ndarray | None:
        """Nearby light of the rows for these lengths, (n, 3) float32; None for none."""
        if not lengths or self.trace_nearby is None:
            return None
        return self.trace_nearby(self.samples, lengths)

    @property
    def reference(self) -> np.ndarray:
        """See `CapturedImage`."""
        return self.samples["radiance"]

    @property
    def visible(self) -> np.ndarray:
        """Visibility of the light through the asset, (n,) or (n, 3)."""
        return self.samples["visible"]

    @property
    def is_of_strands(self) -> bool:
        """See `CapturedImage`."""
        return "tangent" in self.samples

    @property
    def queries(self) -> dict[str, np.ndarray]:
        """The model's queries, by name."""
        return queries_of(self.samples)

    def pick(self, visible: np.ndarray, shadowed: np.ndarray) -> np.ndarray:
        """A model's two outputs, (n, 3) each, blended by each row's visibility."""
        return picked(self.samples["visible"], visible, shadowed)

    def shaded_by(self, asset: SurfaceAsset | FiberAsset) -> np.ndarray:
        """Radiance of the rows, (n, 3) float32, as the runtime answers."""
        part: Any = asset  # of either kind, as the arguments are
        nearby = self.nearby(asset.nearby_lengths)
        return self.pick(*part.evaluate(*evaluate_arguments(self.samples), nearby=nearby))

    def image(self, values: np.ndarray) -> np.ndarray:
        """See `CapturedImage`."""
        return _image(self.resolution, self.pixel, values)


@dataclass(frozen=True)
class EmissionView(ValidationView):
    """One part in a captured image of emission; its `samples` have no light."""

    def shaded_by(self, asset: SurfaceAsset | FiberAsset) -> np.ndarray:
        """Radiance of the rows, (n, 3) float32, as the runtime answers."""
        emitted: np.ndarray = asset.emission(*emission_arguments(self.samples))
        return emitted


@dataclass(frozen=True)
class WhiteView(ValidationView):
    """Samples of one part in a white world: rays from outside, each with several directions wi.

    `radiance` is the ray's in light of radiance 1 from all sides of the domain; `weight`
    (n,), times what a model has for wi, is an unbiased estimate of it. Rows are no pixels.
    """

    @property
    def cosine(self) -> np.ndarray:
        """Cosine of the angle between wo and the normal, or the plane across the strand: (n,)."""
        axis = self.samples["tangent" if self.is_of_strands else "normal"]
        along = np.minimum(np.abs(np.sum(axis * self.samples["wo"], axis=1)), 1.0)
        return np.asarray(np.sqrt(1.0 - along**2) if self.is_of_strands else along)


@dataclass(frozen=True)
class WholeView:
    """All parts in a captured image; rows of the parts, one part after the other."""

    parts: tuple[ValidationView, ...]  # in the dataset's order; some may have no row

    @property
    def index(self) -> int:
        return self.parts[0].index

    @property
    def resolution(self) -> int:
        return self.parts[0].resolution

    @cached_property
    def reference(self) -> np.ndarray:
        """See `CapturedImage`."""
        return np.concatenate([part.reference for part in self.parts])

    @property
    def visible(self) -> np.ndarray:
        """Mean visibility of the light over its channels, (n,)."""
        return np.concatenate(
            [part.visible.reshape(len(part.pixel), -1).mean(axis=1) for part in self.parts]
        )

    @cached_property
    def halves(self) -> np.ndarray:
        """See `CapturedImage`."""
        return np.concatenate([part.halves for part in self.parts], axis=1)

    @property
    def is_of_strands(self) -> bool:
        """See `CapturedImage`."""
        return all(part.is_of_strands for part in self.parts)

    def image(self, values: np.ndarray) -> np.ndarray:
        """See `CapturedImage`."""
        return _image(self.resolution, np.concatenate([p.pixel for p in self.parts]), values)


def _image(resolution: int, pixel: np.ndarray, values: np.ndarray) -> np.ndarray:
    image = np.zeros((resolution**2, 3), np.float32)
    image[pixel] = values
    return image.reshape(resolution, resolution, 3)


def picked(v: np.ndarray, visible: np.ndarray, shadowed: np.ndarray) -> np.ndarray:
    """Two outputs (n, 3), blended by visibility v: (n,) bool or integer, or (n, 3)."""
    if v.ndim == 1:
        return np.where(v.astype(bool)[:, None], visible, shadowed)
    mixed: np.ndarray = v * visible + (1.0 - v) * shadowed
    return mixed


def is_lit(visible: np.ndarray) -> np.ndarray:
    """(n,) bool: whether more than half of the light is visible, of (n,) or (n, 3)."""
    share: np.ndarray = visible.reshape(len(visible), -1).mean(axis=1)
    return share > 0.5


def queries_of(samples: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The query fields of captured samples, without the reference fields."""
    return {name: rows for name, rows in samples.items() if name not in _NO_QUERY}


def all_queries(views: list[ValidationView]) -> Arguments:
    """The arguments of `evaluate` for every pixel of the images."""
    names = [n for n, v in evaluate_arguments(views[0].samples)._asdict().items() if v is not None]
    return evaluate_arguments({n: np.concatenate([v.samples[n] for v in views]) for n in names})

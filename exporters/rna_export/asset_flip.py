"""How far an asset is from its reference: FLIP of its pixels alone, exposed as in a scene."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from rna_export.metrics import IRRADIANCE, flip
from rna_render.lights import LUMINANCE
from rna_sdk.commands.error_words import error_text

DEFINITION = (
    "FLIP of the sRGB images over black, the asset's pixels alone, without the references' noise; "
    "mean over images, and 95th percentile of all these pixels; each image is exposed so that 95% "
    "of the asset's pixels have a luminance below 0.8, at most 3 stops more than the image at the "
    "upper quartile; images 5 stops darker than that one are without light and do not count"
)
SHOWN_AT = 0.8
"""Displayed luminance, linear, of the 95th percentile of the asset's pixels in a picture."""

MOST_STOPS = 3
"""That a picture is exposed more than the typical one of its set: from behind it shows a rim."""

UNLIT_STOPS = 5
"""That a picture is darker than the typical one of its set and counts as one without light."""

_TYPICAL = 75.0  # percentile of a set's levels: neither bright close-ups nor dark backs rule it

_POWER = 2.0 / 0.7  # FLIP is a colour distance to the power 0.7 (Andersson et al. 2020, q_c)
_LEAST = 0.25  # of FLIP with noise, which the extrapolation cannot tell from nothing
COVERED = 0.5
"""Share of a pixel from which it shows the asset."""


@dataclass(frozen=True)
class AssetFlip:
    """An asset's error: see `DEFINITION`.

    Attributes:
        mean: mean over images of the mean over the asset's pixels.
        p95: 95th percentile of the asset's pixels of all images.
        images: how many there are, without those of `unlit`.
        unlit: images without light, which do not count.
    """

    mean: float
    p95: float
    images: int
    unlit: int = 0

    def __str__(self) -> str:
        return error_text(self.mean, self.p95)


class Exposure(NamedTuple):
    """Exposure of a picture of a set: `factor` for `metrics.display`; whether it is lit."""

    factor: float
    is_lit: bool = True


@dataclass(frozen=True)
class ImageFlip:
    """FLIP at the asset's pixels of one image.

    Attributes:
        errors: (n,) float32, against the mean of both halves of the reference.
        noisier: (2 n,) float32, against each half, whose noise has twice the variance.
    """

    errors: np.ndarray
    noisier: np.ndarray

    @classmethod
    def of(
        cls, image: np.ndarray, halves: np.ndarray, covered: np.ndarray, exposure: float
    ) -> "ImageFlip":
        """image: (h, w, 3) radiance at irradiance 1. halves: (2, h, w, 3), independent references.

        covered: (h, w), the asset's share of each pixel.
        """
        asset = covered >= COVERED
        references = [halves.mean(axis=0), *halves]
        errors, *noisier = (flip(image, r, exposure)[1][asset] for r in references)
        return cls(errors, np.concatenate(noisier))

    @property
    def mean(self) -> float:
        """Mean of FLIP without the reference's noise; 0 of no pixel."""
        if not len(self.errors):
            return 0.0
        return float(without_noise(self.errors.mean(), self.noisier.mean()))


def asset_flip(images: Sequence[ImageFlip], unlit: int = 0) -> AssetFlip:
    """The error over images; those without a pixel of the asset are left out.

    unlit: how many further images are without light.
    """
    shown = [image for image in images if len(image.errors)]
    if not shown:
        return AssetFlip(0.0, 0.0, 0, unlit)
    both = [image.errors for image in shown], [image.noisier for image in shown]
    mean = without_noise(*(np.mean([rows.mean() for rows in of]) for of in both))
    p95 = without_noise(*(np.percentile(np.concatenate(of), 95.0) for of in both))
    return AssetFlip(float(mean), float(p95), len(shown), unlit)


def without_noise(error: ArrayLike, noisier: ArrayLike) -> np.ndarray:
    """FLIP against a reference without noise, from FLIP against noise of variance v and of 2 v.

    Colour distances of independent errors add up in squares, so FLIP to the power 2 / 0.7 is
    linear in v. Never above `error`, nor below a quarter of it, where noise hides the rest.
    """
    error = np.asarray(error, np.float64)
    noiseless = np.maximum(2.0 * error**_POWER - np.asarray(noisier, np.float64) ** _POWER, 0.0)
    return np.clip(noiseless ** (1.0 / _POWER), _LEAST * error, error)


def luminance_level(reference: np.ndarray) -> float:
    """95th percentile of the luminance of the asset's pixels, (n, 3) radiance; 0 of none."""
    return float(np.percentile(reference @ LUMINANCE, 95.0)) if len(reference) else 0.0


def scene_exposures(levels: Sequence[float]) -> list[Exposure]:
    """Exposures of a set of pictures: see `DEFINITION`; of 1 where all are black.

    levels: `luminance_level` of each picture's reference.
    """
    lit = [level for level in levels if level > 0.0]
    if not lit:
        return [Exposure(1.0)] * len(levels)
    typical = float(np.percentile(lit, _TYPICAL))
    least = typical / 2.0**MOST_STOPS
    return [
        Exposure(SHOWN_AT / (IRRADIANCE * max(level, least)), level > typical / 2.0**UNLIT_STOPS)
        for level in levels
    ]

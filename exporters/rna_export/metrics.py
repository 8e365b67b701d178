"""Image error metrics; every number states its definition."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import flip_evaluator
import numpy as np

from rna_render import encode_srgb

PSNR_DEFINITION = (
    "PSNR of linear radiance under a light of irradiance pi, clamped to [0, 1], over the asset's "
    "pixels only; mean over images"
)
"""Exposed as `exposure_of` says, where the references are dark."""

WITHOUT_NOISE_DEFINITION = (
    "the same PSNR against what two independent halves of the reference would converge to: the "
    "mean over the asset's pixels and channels of the product of the clamped image's differences "
    "from both halves, as far as a half is within [0, 1], and nowhere more than the squared error "
    "of the PSNR itself, which it is never below; 95% interval; a lower bound (high: null) where "
    "that mean is not above its own error"
)
FLIP_DEFINITION = "mean LDR-FLIP of the sRGB image over black, whole image"
P99_DEFINITION = (
    "99th percentile over the asset's pixels of |error| / (reference + a tenth of its image's "
    "mean), each the mean of RGB; mean over images"
)
IRRADIANCE = np.pi
DARK = 0.25
"""Displayed level, linear: where 99% of all references' channels are below, the asset is dark, and
scores are taken at the exposure that shows this percentile so. At any other, a model scores by the
asset's darkness."""

RAYS_ALONG_A_PIXEL = 4
"""Rays along a side of a pixel that shows several strands, as pictures do."""

_BLACK = 1e-4  # displayed level below which nothing is to be seen at any exposure
_ONE_COLOUR = 2.0 / 255.0  # displayed difference
_LEAST_ERROR = 1e-12  # mean squared: 120 dB, float32's rounding


def display(radiance: np.ndarray, exposure: float = 1.0) -> np.ndarray:
    """Radiance at irradiance 1 as displayed under irradiance pi: linear, in [0, 1]."""
    return np.clip(radiance * (IRRADIANCE * exposure), 0.0, 1.0)


def exposure_of(references: Sequence[np.ndarray]) -> float:
    """Exposure that scores are taken at: above 1 for dark references, see `DARK`.

    references: (n, 3) each, at irradiance 1, the asset's pixels only.
    """
    level = _level(references)
    return max(1.0, DARK / level) if level > _BLACK else 1.0


def emission_exposure(references: Sequence[np.ndarray]) -> float:
    """Exposure of emission, whose radiance has any scale: the 99th percentile is white."""
    level = _level(references)
    return 1.0 / level if level > 0.0 else 1.0


def _level(references: Sequence[np.ndarray]) -> float:
    """99th percentile of all channels as displayed, not clamped."""
    values = np.concatenate([np.zeros(0), *(r.ravel() for r in references)])
    return IRRADIANCE * float(np.percentile(values, 99.0)) if values.size else 0.0


def plain(references: Sequence[np.ndarray]) -> str | None:
    """ "black" or "of one colour" for references for which a PSNR has no meaning."""
    rows = np.concatenate([np.zeros((0, 3)), *references])
    if not len(rows) or _level(references) <= _BLACK:
        return "black"
    shown = display(rows, exposure_of(references))
    return "of one colour" if np.ptp(shown, axis=0).max() < _ONE_COLOUR else None


def psnr(radiance: np.ndarray, reference: np.ndarray, exposure: float = 1.0) -> float:
    """See `PSNR_DEFINITION`; both (n, 3), at irradiance 1, the asset's pixels only."""
    return _decibels(float(_squared_error(radiance, reference, exposure).mean()))


def _squared_error(radiance: np.ndarray, reference: np.ndarray, exposure: float) -> np.ndarray:
    error = display(radiance, exposure).astype(np.float64) - display(reference, exposure)
    return np.asarray(error**2)


@dataclass(frozen=True)
class NoiselessPsnr:
    """See `WITHOUT_NOISE_DEFINITION`; dB.

    Attributes:
        db: the estimate, or the lower bound, `low`, where `high` is None.
        low, high: 95% interval; `high` is None where the error may as well be 0.
    """

    db: float
    low: float
    high: float | None

    @classmethod
    def of_error(cls, error: float, margin: float, most: float = math.inf) -> NoiselessPsnr:
        """The PSNR of an estimated mean squared error with the half width of its 95% interval.

        most: what the error is not above.
        """
        low = _decibels(min(max(error, 0.0) + margin, most))
        if error <= margin:
            return cls(low, low, None)
        return cls(_decibels(error), low, _decibels(error - margin))

    @classmethod
    def mean(cls, images: Sequence[NoiselessPsnr]) -> NoiselessPsnr:
        """Mean of the decibels of images with independent noise."""
        db = math.fsum(i.db for i in images) / len(images)
        low = db - math.hypot(*(i.db - i.low for i in images)) / len(images)
        above = [i.high - i.db for i in images if i.high is not None]
        if len(above) < len(images):
            return cls(low, low, None)
        return cls(db, low, db + math.hypot(*above) / len(images))

    def __str__(self) -> str:
        if self.high is None:
            return f"at least {self.db:.2f} dB"
        return f"{self.db:.2f} dB ({self.low:.2f} to {self.high:.2f})"


def psnr_without_noise(
    radiance: np.ndarray, half: np.ndarray, other: np.ndarray, exposure: float = 1.0
) -> NoiselessPsnr:
    """See `WITHOUT_NOISE_DEFINITION`; all (n, 3), at irradiance 1, the asset's pixels only.

    Noise of two independent halves has the product's mean 0. A number that one half alone puts
    into the display range counts half: the other half's noise does not know of that choice, so a
    perfect model's mean is 0 wherever the noise carries the reference across white. What is white
    in both halves has no noise as displayed.
    """
    if not len(radiance):
        return NoiselessPsnr.of_error(0.0, 1.0)
    with_noise = _squared_error(radiance, (half + other) / 2.0, exposure)
    shown = display(radiance, exposure).astype(np.float64)
    halves = [IRRADIANCE * exposure * h.astype(np.float64) for h in (half, other)]
    weight = np.mean([h <= 1.0 for h in halves], axis=0)
    products = weight * (shown - halves[0]) * (shown - halves[1])
    products = np.minimum(np.where(weight > 0.0, products, with_noise), with_noise)
    of_pixels = products.mean(axis=1)  # whose channels are not independent
    spread = float(of_pixels.std() / math.sqrt(len(of_pixels)))
    return NoiselessPsnr.of_error(
        float(of_pixels.mean()), 1.96 * spread, most=float(with_noise.mean())
    )


def _decibels(error: float) -> float:
    return -10.0 * math.log10(max(error, _LEAST_ERROR))


def relative_mse(radiance: np.ndarray, reference: np.ndarray) -> float:
    """Mean squared error over the mean squared reference; unclamped."""
    reference = reference.astype(np.float64)
    return float(np.mean((radiance - reference) ** 2) / max(np.mean(reference**2), 1e-12))


def relative_error_p99(radiance: np.ndarray, reference: np.ndarray) -> float:
    """See `P99_DEFINITION`; both (n, 3) at irradiance 1, the asset's pixels only."""
    reference = reference.astype(np.float64)
    floor = 0.1 * max(float(reference.mean()), 1e-12)
    error = np.abs(radiance - reference).mean(axis=1) / (reference.mean(axis=1) + floor)
    return float(np.percentile(error, 99.0))


def flip(
    image: np.ndarray, reference: np.ndarray, exposure: float = 1.0
) -> tuple[float, np.ndarray]:
    """LDR-FLIP of sRGB images (h, w, 3) of radiance at irradiance 1: mean and map (h, w)."""
    shown = [np.ascontiguousarray(display(i, exposure), np.float32) for i in (reference, image)]
    error, mean, _ = flip_evaluator.evaluate(*shown, "LDR", inputsRGB=False, applyMagma=False)
    return float(mean), np.asarray(error).reshape(image.shape[:2])


def reduced(image: np.ndarray, factor: int) -> np.ndarray:
    """Means of blocks of `factor` x `factor` pixels of an image (h, w, 3).

    Rows and columns that do not fill a block are left out.
    """
    height, width = (side // factor for side in image.shape[:2])
    whole = image[: height * factor, : width * factor]
    blocks = whole.reshape(height, factor, width, factor, 3)
    return np.asarray(blocks.mean(axis=(1, 3)))


def to_png(radiance: np.ndarray, exposure: float = 1.0) -> np.ndarray:
    """Radiance image (h, w, 3) at irradiance 1 as uint8 sRGB under irradiance pi."""
    return (255.0 * encode_srgb(display(radiance, exposure)) + 0.5).astype(np.uint8)

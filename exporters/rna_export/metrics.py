"""Image error metrics; every number states its definition."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import flip_evaluator
import numpy as np

from rna_render.srgb import encode_srgb

PSNR_DEFINITION = (
    "PSNR of linear radiance under a light of irradiance pi, clamped to [0, 1], over the asset's "
    "pixels only; mean over images"
)
WITHOUT_NOISE_DEFINITION = (
    "PSNR of linear radiance under a light of irradiance pi against what two independent halves of "
    "the reference would converge to: mean over the asset's pixels and channels of the unclamped "
    "product of the differences from both halves, where the reference is within [0, 1]; 95% "
    "interval; a lower bound (high: null) where that mean is not above its own error"
)
FLIP_DEFINITION = "mean LDR-FLIP of the sRGB image over black, whole image"
P99_DEFINITION = (
    "99th percentile over the asset's pixels of |error| / (reference + a tenth of its image's "
    "mean), each the mean of RGB; mean over images"
)
IRRADIANCE = np.pi

_LEAST_ERROR = 1e-12  # mean squared: 120 dB, float32's rounding


def display(radiance: np.ndarray) -> np.ndarray:
    """Radiance at irradiance 1 as displayed under irradiance pi: linear, in [0, 1]."""
    return np.clip(radiance * IRRADIANCE, 0.0, 1.0)


def psnr(radiance: np.ndarray, reference: np.ndarray) -> float:
    """See `PSNR_DEFINITION`; both (n, 3), at irradiance 1, the asset's pixels only."""
    error = display(radiance).astype(np.float64) - display(reference)
    return _decibels(float(np.mean(error**2)))


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
    def of_error(cls, error: float, margin: float) -> NoiselessPsnr:
        """The PSNR of an estimated mean squared error with the half width of its 95% interval."""
        low = _decibels(max(error, 0.0) + margin)
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


def psnr_without_noise(radiance: np.ndarray, half: np.ndarray, other: np.ndarray) -> NoiselessPsnr:
    """See `WITHOUT_NOISE_DEFINITION`; all (n, 3), at irradiance 1, the asset's pixels only.

    Noise of two independent halves has the product's mean 0. A number that one half alone puts
    into the display range counts half: the other half's noise does not know of that choice, so a
    perfect model's mean is 0 wherever the noise carries the reference across white.
    """
    errors = [IRRADIANCE * (radiance.astype(np.float64) - h) for h in (half, other)]
    weight = np.mean([IRRADIANCE * h <= 1.0 for h in (half, other)], axis=0)
    products, counts = (weight * errors[0] * errors[1]).sum(axis=1), weight.sum(axis=1)
    total = counts.sum()
    if not total:
        return NoiselessPsnr.of_error(0.0, 1.0)  # nothing is within the display range
    mean = float(products.sum() / total)
    # Of a ratio of two sums over pixels, whose channels are not independent.
    spread = float(np.sqrt(np.sum((products - mean * counts) ** 2)) / total)
    return NoiselessPsnr.of_error(mean, 1.96 * spread)


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


def flip(image: np.ndarray, reference: np.ndarray) -> tuple[float, np.ndarray]:
    """See `FLIP_DEFINITION`; images (h, w, 3) of radiance at irradiance 1. Mean and map (h, w)."""
    shown = [np.ascontiguousarray(display(i), np.float32) for i in (reference, image)]
    error, mean, _ = flip_evaluator.evaluate(*shown, "LDR", inputsRGB=False, applyMagma=False)
    return float(mean), np.asarray(error).reshape(image.shape[:2])


def to_png(radiance: np.ndarray) -> np.ndarray:
    """Radiance image (h, w, 3) at irradiance 1 as uint8 sRGB under irradiance pi."""
    return (255.0 * encode_srgb(display(radiance)) + 0.5).astype(np.uint8)

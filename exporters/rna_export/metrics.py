"""Image error as this project reports it; every number says which definition it follows."""

from __future__ import annotations

import flip_evaluator
import numpy as np

from rna_render.srgb import encode_srgb

PSNR_DEFINITION = (
    "PSNR of linear radiance under a light of irradiance pi, clamped to [0, 1], over the asset's "
    "pixels only; mean over images"
)
FLIP_DEFINITION = "mean LDR-FLIP of the sRGB image over black, whole image"
P99_DEFINITION = (
    "99th percentile over the asset's pixels of |error| / (reference + a tenth of its image's "
    "mean), each the mean of RGB; mean over images"
)
IRRADIANCE = np.pi


def display(radiance: np.ndarray) -> np.ndarray:
    """Radiance at irradiance 1 as displayed under irradiance pi: linear, in [0, 1]."""
    return np.clip(radiance * IRRADIANCE, 0.0, 1.0)


def psnr(radiance: np.ndarray, reference: np.ndarray) -> float:
    """See `PSNR_DEFINITION`; both (n, 3), at irradiance 1, the asset's pixels only."""
    error = display(radiance).astype(np.float64) - display(reference)
    return -10.0 * float(np.log10(max(np.mean(error**2), 1e-12)))


def psnr_without_noise(radiance: np.ndarray, half: np.ndarray, other: np.ndarray) -> float:
    """`psnr` against what two independent estimates of the reference would converge to.

    The product of both errors has the noise's mean, which is 0, in place of its square.
    """
    errors = [display(radiance).astype(np.float64) - display(h) for h in (half, other)]
    return -10.0 * float(np.log10(max(np.mean(errors[0] * errors[1]), 1e-12)))


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

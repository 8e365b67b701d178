"""Error of a model of strands in validation images: by kind of light, and by size of the pixels."""

from __future__ import annotations

from typing import Any

import numpy as np

from rna_bench.accuracy.strand_light import strand_light
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.metrics import IRRADIANCE, display, psnr_without_noise, reduced
from rna_export.training.model.neural_asset import NeuralAsset

SIZES = (1, 2, 4, 8)
"""Rays along a side of a pixel."""


def view_parts(model: NeuralAsset, view: ValidationView) -> dict[str, Any]:
    """Errors of one image, PSNR without noise in dB, and what it shows."""
    light = strand_light(model, view.queries, view.visible)
    direct = view.samples["direct"]
    ours, (one, other) = light.direct + light.scattered, view.halves
    lit = view.visible.astype(bool)

    def decibels(shown: np.ndarray, rows: np.ndarray | slice = slice(None)) -> float:
        return round(psnr_without_noise(shown[rows], one[rows], other[rows]).db, 2)

    return {
        "view": view.index,
        "wo_wi": round(float((view.samples["wo"] * view.samples["wi"]).sum(axis=1).mean()), 2),
        "brightness": round(IRRADIANCE * float(view.reference.mean()), 4),
        "share_scattered": round(1.0 - float(direct.mean() / view.reference.mean()), 3),
        "psnr": decibels(ours),
        "psnr_with_direct_of_cycles": decibels(direct + light.scattered),
        "psnr_lit": decibels(ours, lit),
        "psnr_shadowed": decibels(ours, ~lit),
        "psnr_of_pixels": [
            round(-10.0 * np.log10(error), 2) for error in pixel_errors(view, ours, SIZES)
        ],
    }


def pixel_errors(view: ValidationView, ours: np.ndarray, sizes: tuple[int, ...]) -> list[float]:
    """Mean squared errors, as displayed, of pixels that are the mean of size x size rays.

    By the area that the asset covers; black is around it. The noise of both halves of the reference
    is in no product of them, but for what they lose where they are clamped.

    ours: (n, 3) radiance of the view's rows.
    """
    images = [view.image(radiance) for radiance in (ours, *view.halves)]
    errors = []
    for size in sizes:
        shown, one, other = (display(reduced(image, size)).astype(np.float64) for image in images)
        product = float(((shown - one) * (shown - other)).sum())
        errors.append(max(product, 1e-12) * size**2 / ours.size)
    return errors

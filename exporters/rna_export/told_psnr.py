"""How commands tell a PSNR of validation images."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from rna_export.capture.dataset.validation_view import CapturedImage
from rna_export.psnr_words import psnr_in_words
from rna_export.training.validation import RAYS_ALONG_A_PIXEL, mean_psnr_of_pixels


def told_psnr(
    db: float, radiance: list[np.ndarray], views: Sequence[CapturedImage], strands_alone: bool
) -> str:
    """A PSNR, dB, in figures and words.

    Of strands alone the words are those of pixels of several rays: the images have one ray a pixel,
    which shows one strand, where a picture shows the mean of several.
    """
    if not strands_alone:
        return f"{db:.2f} dB ({psnr_in_words(db)})"
    of_pixels = mean_psnr_of_pixels(radiance, views)
    rays = RAYS_ALONG_A_PIXEL**2
    return f"{db:.2f} dB a ray, {of_pixels:.1f} dB in pixels of {rays} ({psnr_in_words(of_pixels)})"

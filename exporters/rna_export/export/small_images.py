"""Error of an asset at small image sizes, from downsampled validation images."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from rna_export.capture.dataset.validation_view import CapturedImage
from rna_export.metrics import flip
from rna_export.training.validation import exposure
from rna_sdk.package import FlipAtHeight

_SMALLEST = 8  # pixels; an image of fewer says little
_HALVINGS = 4


def flip_at_heights(
    radiance: list[np.ndarray], views: Sequence[CapturedImage]
) -> tuple[FlipAtHeight, ...]:
    """Mean FLIP of shaded rows, (n, 3) a view, at the images' height, half of it, and so on.

    Pixels are averaged as radiance, as a renderer's samples of a pixel are; rows and columns that
    a height does not divide are left out.
    """
    images = [(v.image(r), v.image(v.reference)) for r, v in zip(radiance, views, strict=True)]
    result, e = [], exposure(views)
    for factor in (2**k for k in range(_HALVINGS)):
        height = views[0].resolution // factor
        if height < _SMALLEST and factor > 1:
            break
        errors = [
            flip(_reduced(ours, factor), _reduced(theirs, factor), e)[0] for ours, theirs in images
        ]
        result.append(FlipAtHeight(height=height, flip=float(np.mean(errors))))
    return tuple(result)


def _reduced(image: np.ndarray, factor: int) -> np.ndarray:
    """Means of blocks of `factor` x `factor` pixels."""
    height, width = (side // factor for side in image.shape[:2])
    whole = image[: height * factor, : width * factor]
    blocks = whole.reshape(height, factor, width, factor, 3)
    return np.asarray(blocks.mean(axis=(1, 3)))

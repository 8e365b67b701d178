"""An asset's error over its validation images: of reflected light and of emission."""

from collections.abc import Sequence

import numpy as np

from rna_export.asset_flip import (
    AssetFlip,
    Exposure,
    ImageFlip,
    asset_flip,
    luminance_level,
    scene_exposures,
)
from rna_export.capture.dataset.validation_view import CapturedImage, EmissionView
from rna_export.metrics import RAYS_ALONG_A_PIXEL, display, emission_exposure, reduced

_GLOWS = 2.0 / 255.0  # displayed level, linear


def asset_error(
    radiance: Sequence[np.ndarray], views: Sequence[CapturedImage], factor: int = 1
) -> AssetFlip:
    """Error of shaded rows, (n, 3) a view, in pixels of `factor` x `factor` of the images'.

    Of strands alone, whose images have one ray a pixel, which shows one strand, pixels are those
    of 4 x 4 rays at least, as pictures show strands. Of emission, only pixels count that glow in
    one of both.
    """
    factor *= smallest_factor(views)
    exposures = picture_exposures(views)
    images = [
        image_flip(rows, view, e.factor, factor)
        for rows, view, e in zip(radiance, views, exposures, strict=True)
        if e.is_lit
    ]
    return asset_flip(images, unlit=len(views) - len(images))


def smallest_factor(views: Sequence[CapturedImage]) -> int:
    """Rays along a side of the pixels that errors are of."""
    return RAYS_ALONG_A_PIXEL if all(view.is_of_strands for view in views) else 1


def picture_exposures(views: Sequence[CapturedImage]) -> list[Exposure]:
    """Exposure of each view: of a scene, or with the 99th percentile of glow at white."""
    references = [view.reference for view in views]
    if all(isinstance(view, EmissionView) for view in views):
        return [Exposure(emission_exposure(references))] * len(views)
    return scene_exposures([luminance_level(reference) for reference in references])


def image_flip(rows: np.ndarray, view: CapturedImage, exposure: float, factor: int) -> ImageFlip:
    """FLIP of one view's shaded rows (n, 3), in pixels of `factor` x `factor` of the image's."""
    shows = np.ones_like(rows)
    if isinstance(view, EmissionView):
        brightest = np.maximum(*(display(r, exposure).max(axis=1) for r in (rows, view.reference)))
        shows *= (brightest > _GLOWS)[:, None]
    image, covered, *halves = (
        reduced(view.image(of), factor) for of in (rows, shows, *view.halves)
    )
    return ImageFlip.of(image, np.stack(halves), covered[..., 0], exposure)


def worse_error(
    transport: AssetFlip, emitted: Sequence[tuple[np.ndarray, EmissionView]], factor: int = 1
) -> AssetFlip:
    """The error of reflected light, or `asset_error` of emission where that is larger.

    emitted: rows and views of all parts that emit.
    """
    if not emitted:
        return transport
    rows, glowing = zip(*emitted, strict=True)
    emission = asset_error(rows, glowing, factor)
    return emission if emission.mean > transport.mean else transport

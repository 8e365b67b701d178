"""Light that a model returns from a white world, over Cycles': the energy of its highlights.

Validation lights are suns and end at display white, so no other score sees how much of a highlight
there is above that.
"""

from collections.abc import Iterable, Sequence

import numpy as np

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import WhiteView
from rna_render.lights import LUMINANCE
from rna_sdk.package import Albedo

DEFINITION = (
    "luminance that rays from all sides meet in a uniform white world, over Cycles' luminance; "
    "facing: below 50 degrees from the normal, at60: 50 to 70, at80: above"
)
_BANDS = ("facing", "at60", "at80")
_LIMITS_DEG = (50.0, 70.0)
_LEAST = 1e-6  # of radiance: a band that returns less is black

Shaded = tuple[np.ndarray, WhiteView]
"""A model's radiance of a view's rows, (n, 3), and the view."""


def albedo(parts: Iterable[Shaded]) -> Albedo | None:
    """Albedo of all parts of an asset together; None if Cycles' asset is black."""
    sums = np.zeros((2, len(_BANDS)))
    rays = np.zeros(len(_BANDS))
    for radiance, view in parts:
        angle_deg = np.degrees(np.arccos(np.clip(view.cosine, 0.0, 1.0)))
        band = np.searchsorted(_LIMITS_DEG, angle_deg, side="right")
        returned = view.samples["weight"] * (radiance @ LUMINANCE)
        for k, rows in enumerate((returned, view.reference @ LUMINANCE)):
            sums[k] += np.bincount(band, rows, len(_BANDS))
        rays += np.bincount(band, minlength=len(_BANDS))
    ours, cycles = sums
    if not cycles.sum() > _LEAST * rays.sum():
        return None
    ratios = {
        name: float(a / b)
        for name, a, b, n in zip(_BANDS, ours, cycles, rays, strict=True)
        if b > _LEAST * n
    }
    return Albedo(ratio=float(ours.sum() / cycles.sum()), **ratios)


def white_views(parts: Sequence[DatasetPart]) -> list[WhiteView] | None:
    """Rays in a white world of each part; None for a dataset without such rays."""
    views = [view for part in parts if (view := part.white_view()) is not None]
    return views if len(views) == len(parts) else None

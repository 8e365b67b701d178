"""What a model of strands says of direct and of scattered light."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.validation import in_batches
from rna_sdk.errors import CaptureError


class StrandLight(NamedTuple):
    """Radiance under irradiance 1, (n, 3) float32 each."""

    direct: np.ndarray
    scattered: np.ndarray


def strand_light(
    model: NeuralAsset, queries: dict[str, np.ndarray], visible: np.ndarray
) -> StrandLight:
    """Direct and scattered light of n queries, as `ValidationView.queries` has them.

    visible: (n,) of the light. Raises CaptureError for a model without an output for direct light.
    """
    if not model.config.separates_direct:
        raise CaptureError("found a model that does not tell direct light from scattered light")
    direct, lit, shadowed = in_batches(model, queries, model.colours).swapaxes(0, 1)
    is_lit = visible.astype(bool)[:, None]
    return StrandLight(np.where(is_lit, direct, 0.0), np.where(is_lit, lit, shadowed))

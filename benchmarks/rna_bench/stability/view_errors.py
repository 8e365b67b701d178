"""Errors on validation images: of a model, and of shaded samples over any choice of rows."""

from collections.abc import Sequence

import numpy as np

from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.metrics import display
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.validation import Scores, score, shade


def scores_of(model: NeuralAsset, views: Sequence[ValidationView]) -> Scores:
    """Scores of all views together, as `rna-train` reports them."""
    return score([shade(model, view) for view in views], views)


def relative_error(radiance: np.ndarray, halves: np.ndarray) -> float:
    """RMSE over the mean, both of displayed radiance, without the references' noise.

    nan where all is black.

    radiance: (n, 3). halves: (2, n, 3), two independent estimates of the reference: the product
    of the errors against both has no noise in the mean.
    """
    shown, references = display(radiance).astype(np.float64), display(halves)
    product = np.mean((shown - references[0]) * (shown - references[1]))
    mean = float(references.mean())
    return float(np.sqrt(max(product, 0.0))) / mean if mean > 0.0 else float("nan")


def joined_views(views: list[ValidationView]) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """The samples of all views, one array a field, and their halves, (2, n, 3)."""
    names = views[0].samples
    samples = {name: np.concatenate([v.samples[name] for v in views]) for name in names}
    return samples, np.concatenate([v.halves for v in views], axis=1)

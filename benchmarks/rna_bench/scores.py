"""A trained model's scores on validation images."""

from __future__ import annotations

from collections.abc import Sequence

from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.validation import Scores, score, shade


def scores_of(model: NeuralAsset, views: Sequence[ValidationView]) -> Scores:
    """Scores of all views together, as `rna-train` reports them."""
    return score([shade(model, view) for view in views], views)

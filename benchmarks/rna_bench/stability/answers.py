"""One interface for all that answers queries: a trained model or a package."""

from collections.abc import Callable

import numpy as np

from rna_bench.one_part import OnePart
from rna_export.capture.dataset import validation_view
from rna_export.capture.dataset.asset_arguments import evaluate_arguments
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.validation import answer

Queries = dict[str, np.ndarray]
"""Fields of a sample by name, in the order of `Asset.evaluate`'s arguments; float32."""

Answers = Callable[[Queries], tuple[np.ndarray, np.ndarray]]
"""Queries of n rows -> radiance where the light is visible, and where not, (n, 3) each."""


def picked(answers: Answers, samples: dict[str, np.ndarray]) -> np.ndarray:
    """Radiance (n, 3), lit or shadowed by each sample's `visible`."""
    visible, shadowed = answers(validation_view.queries_of(samples))
    return validation_view.picked(samples["visible"], visible, shadowed)


def of_package(asset: OnePart) -> Answers:
    """A package's, through the runtime."""

    def ask(queries: Queries) -> tuple[np.ndarray, np.ndarray]:
        rows = {name: np.ascontiguousarray(v, np.float32) for name, v in queries.items()}
        return asset.evaluate(*evaluate_arguments(rows))

    return ask


def of_model(model: NeuralAsset) -> Answers:
    """A model's, in PyTorch."""

    return lambda queries: answer(model, queries)

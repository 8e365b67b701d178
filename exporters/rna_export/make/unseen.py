"""Binned error of a model on held-out rays, which guides the next round.

The error is that of PSNR: of displayed radiance. It has the noise of the rays' few paths in it.
That is meant: where targets are noisy, a fit needs more of them, too.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_export.capture.dataset import Dataset
from rna_export.capture.dataset_part import DatasetPart
from rna_export.capture.guide import Guide, relative_errors
from rna_export.capture.validation_view import picked, queries_of
from rna_export.metrics import display
from rna_export.training.model import NeuralAsset
from rna_export.training.validation import answer

_MOST = 400_000  # samples of a part that are asked about


def guide_from(
    dataset: Dataset, models: Sequence[NeuralAsset], shards: Sequence[Path], seed: int
) -> Guide:
    """From the errors of the models of the parts on shards that they have not seen."""
    parts = tuple(part.captured for part in dataset.parts)
    errors = []
    for part, model in zip(dataset.parts, models, strict=True):
        samples = _some(part, shards, np.random.default_rng(seed))
        errors.append(relative_errors(part.captured, samples, squared_errors(model, samples)))
    return Guide(parts, tuple(errors))


def squared_errors(model: NeuralAsset, samples: dict[str, np.ndarray]) -> np.ndarray:
    """(n,) mean over the channels, of displayed radiance."""
    shaded = picked(samples["visible"], *answer(model, queries_of(samples)))
    error = display(shaded) - display(samples["radiance"])
    squared: np.ndarray = np.mean(error.astype(np.float64) ** 2, axis=1)
    return squared


def _some(
    part: DatasetPart, shards: Sequence[Path], rng: np.random.Generator
) -> dict[str, np.ndarray]:
    samples = part.samples_of(shards)
    n = len(samples["visible"])
    if n <= _MOST:
        return samples
    rows = rng.choice(n, _MOST, replace=False)
    return {name: values[rows] for name, values in samples.items()}

"""Noise of captured radiance, and the choice of loss."""

from __future__ import annotations

import numpy as np

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.training.presets import Preset

MOST_DARKENED = 0.05
"""Part of the brightness that the log loss may cost; the end of a run puts it right."""


def darkening(dataset: DatasetPart, unit: float) -> float:
    """Relative darkening that the log loss would cause, to second order in the noise.

    The mean of log(x / unit + 1) over noisy x is lower than that of their mean, by half their
    variance over (x + unit)^2. The variance of a training sample follows from both halves of the
    validation images, which have more paths.
    """
    settings = dataset.manifest.settings
    lost = total = 0.0
    for view in dataset.validation_views():
        halves = view.halves.astype(np.float64)
        x = halves.mean(axis=0)
        of_half = (halves[0] - halves[1]) ** 2 / 2.0
        of_sample = of_half * (settings.validation_samples / 2.0 / settings.samples)
        lost += float(np.sum(of_sample / 2.0 / (x + unit)))
        total += float(np.sum(x))
    return lost / total if total > 0.0 else 0.0


def with_fitting_loss(preset: Preset, dataset: DatasetPart, unit: float) -> Preset:
    """The preset with a loss chosen for the dataset's noise, where it leaves that open."""
    if preset.training.loss != "auto":
        return preset
    too_dark = darkening(dataset, unit) > MOST_DARKENED
    return preset.with_training(loss="unbiased" if too_dark else "log")

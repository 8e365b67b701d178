"""The loss is chosen by how noisy the capture is, and how much light it has in shadow."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.dataset import Dataset, ValidationView
from rna_export.training.loss_choice import (
    SHADOW_WEIGHT,
    darkening,
    light_in_shadow,
    with_fitting_loss,
)
from rna_export.training.presets import PRESETS
from tests.exporters.synthetic import make_dataset, tiny

UNIT = 0.3


class NoisyDataset(Dataset):
    """The same, with noise in its validation images, of this relative deviation a sample.

    Shadowed radiance is `glow` times what it was.
    """

    deviation = 0.0
    glow = 1.0

    def validation_views(self) -> list[ValidationView]:
        rng = np.random.default_rng(4)
        settings, noisy = self.manifest.settings, []
        scale = self.deviation * np.sqrt(2.0 * settings.samples / settings.validation_samples)
        for view in super().validation_views():
            shadowed = view.samples["visible"][:, None] == 0
            true = view.samples["radiance"] * np.where(shadowed, self.glow, 1.0)
            samples = {**view.samples, "radiance": true.astype(np.float32)}
            halves = (true * (1.0 + scale * rng.normal(size=(2, *true.shape)))).astype(np.float32)
            noisy.append(dataclasses.replace(view, samples=samples, halves=halves))
        return noisy


@pytest.fixture
def dataset(tmp_path: Path) -> NoisyDataset:
    return NoisyDataset(make_dataset(tmp_path / "ball.rays").folder)


def learnt(x: np.ndarray, deviation: float) -> np.ndarray:
    """Where the log loss settles for samples of mean x, by drawing them."""
    draws = deviation * np.random.default_rng(0).normal(size=(1000, 1))
    draws = 1.0 + np.concatenate([draws, -draws])
    y = np.log1p(np.maximum(x.reshape(1, -1) * draws, 0.0) / UNIT).mean(axis=0)
    return UNIT * np.expm1(y)


@pytest.mark.parametrize("deviation", [0.0, 0.1, 0.3])
def test_darkening_is_what_the_log_loss_loses(dataset: NoisyDataset, deviation: float) -> None:
    dataset.deviation = deviation
    x = np.concatenate([v.samples["radiance"] for v in dataset.validation_views()]).astype(float)
    lost = 1.0 - learnt(x, deviation).sum() / x.sum()
    assert darkening(dataset, UNIT) == pytest.approx(lost, rel=0.15, abs=1e-3)


@pytest.mark.parametrize(("deviation", "loss"), [(0.05, "log"), (0.5, "unbiased")])
def test_presets_of_surfaces_choose(dataset: NoisyDataset, deviation: float, loss: str) -> None:
    dataset.deviation = deviation
    assert PRESETS["surface"]["small"].training.loss == "auto"
    assert with_fitting_loss(tiny(), dataset, UNIT).training.loss == loss
    asked = tiny(loss="log")
    assert with_fitting_loss(asked, dataset, UNIT) is asked
    assert {PRESETS[kind]["paper-hq"].training.loss for kind in PRESETS} == {"log"}


def test_light_in_shadow(dataset: NoisyDataset) -> None:
    views = [view.samples for view in dataset.validation_views()]
    lit = sum(float(v["radiance"][v["visible"] > 0].sum()) for v in views)
    shadowed = sum(float(v["radiance"][v["visible"] == 0].sum()) for v in views)
    assert shadowed > 0.0
    for glow in (0.0, 1.0, 3.0):
        dataset.glow = glow
        expected = glow * shadowed / (lit + glow * shadowed)
        assert light_in_shadow(dataset) == pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize(("glow", "weight"), [(0.0, 1.0), (9.0, SHADOW_WEIGHT)])
def test_shadows_count_where_much_light_is_in_them(
    dataset: NoisyDataset, glow: float, weight: float
) -> None:
    dataset.glow = glow
    chosen = with_fitting_loss(tiny(), dataset, UNIT).training
    assert (chosen.loss, chosen.shadow_weight) == ("log", weight)
    asked = tiny(loss="log")
    assert with_fitting_loss(asked, dataset, UNIT).training.shadow_weight == 1.0

"""The loss is chosen by how noisy the capture is."""

import dataclasses
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.make.round_images import RoundImages
from rna_export.training.optimization.losses import darkening, with_fitting_loss
from rna_export.training.presets import PRESETS
from rna_export.training.validation import mean_psnr, noiseless_psnr
from tests.exporters.synthetic import make_dataset, tiny

UNIT = 0.3


class NoisyPart(DatasetPart):
    """The dataset with noise in its validation images: of this relative deviation a sample."""

    deviation = 0.0

    def validation_views(self) -> list[ValidationView]:
        rng = np.random.default_rng(4)
        settings, noisy = self.manifest.settings, []
        scale = self.deviation * np.sqrt(2.0 * settings.samples / settings.validation_samples)
        for view in super().validation_views():
            true = view.samples["radiance"]
            halves = true * (1.0 + scale * rng.normal(size=(2, *true.shape)))
            noisy.append(dataclasses.replace(view, halves=halves.astype(np.float32)))
        return noisy


@pytest.fixture
def dataset(tmp_path):
    part = make_dataset(tmp_path / "ball.rays")
    return NoisyPart(part.dataset, part.captured)


def learnt(x: np.ndarray, deviation: float) -> np.ndarray:
    """Where the log loss settles for samples of mean x, by drawing them."""
    draws = deviation * np.random.default_rng(0).normal(size=(1000, 1))
    draws = 1.0 + np.concatenate([draws, -draws])
    y = np.log1p(np.maximum(x.reshape(1, -1) * draws, 0.0) / UNIT).mean(axis=0)
    return UNIT * np.expm1(y)


@pytest.mark.parametrize("deviation", [0.0, 0.1, 0.3])
def test_darkening_is_what_the_log_loss_loses(dataset, deviation):
    dataset.deviation = deviation
    x = np.concatenate([v.samples["radiance"] for v in dataset.validation_views()]).astype(float)
    lost = 1.0 - learnt(x, deviation).sum() / x.sum()
    assert darkening(dataset, UNIT) == pytest.approx(lost, rel=0.15, abs=1e-3)


@pytest.mark.parametrize(("deviation", "loss"), [(0.05, "log"), (0.9, "unbiased")])
def test_presets_of_surfaces_choose(dataset, deviation, loss):
    dataset.deviation = deviation
    assert PRESETS["surface"]["small"].training.loss == "auto"
    assert with_fitting_loss(tiny(), dataset, UNIT).training.loss == loss
    requested = tiny(loss="log")
    assert with_fitting_loss(requested, dataset, UNIT) is requested
    assert {PRESETS[kind]["paper-hq"].training.loss for kind in PRESETS} == {"log"}


@pytest.mark.parametrize(
    ("samples", "given", "noisy"),
    [(16, (), True), (64, (), False), (16, ("validation_samples",), False)],
)
def test_images_of_few_paths_are_noisy_unless_they_were_asked_for(samples, given, noisy):
    settings = CaptureSettings(validation_samples=samples)
    dataset = SimpleNamespace(manifest=SimpleNamespace(settings=settings))
    rays: Any = SimpleNamespace(dataset=dataset)
    state: Any = SimpleNamespace()
    assert RoundImages(rays, state, given).are_noisy == noisy


def test_images_that_took_longer_than_planned_stay_small():
    dataset = SimpleNamespace(manifest=SimpleNamespace(settings=CaptureSettings()))
    rays: Any = SimpleNamespace(dataset=dataset)
    state: Any = SimpleNamespace(images=(64, 176, 128), image_seconds=40.0, image_paths=10_000)
    assert not RoundImages(rays, state, ()).grow(spent=90.0)
    assert state.images is None


def test_noise_of_few_paths_does_not_count_against_a_goal_in_rounds(dataset):
    """`rna-make --min-psnr` judges its small images by what they would converge to."""
    true = [view.samples["radiance"] for view in dataset.validation_views()]
    shaded = [0.97 * rows for rows in true]
    dataset.deviation, clean = 0.12, dataset.validation_views()
    noisy = [
        dataclasses.replace(v, samples={**v.samples, "radiance": v.halves.mean(axis=0)})
        for v in dataset.validation_views()
    ]
    expected = mean_psnr(shaded, clean)
    assert mean_psnr(shaded, noisy) < expected - 2.0
    assert noiseless_psnr(shaded, noisy).db == pytest.approx(expected, abs=1.0)

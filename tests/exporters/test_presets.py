"""The paper's presets are the paper's."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import pytest
import torch

from rna_export.training.lightning_module import NeuralAssetTraining
from rna_export.training.model import NeuralAsset
from rna_export.training.presets import PRESETS

BOUNDS = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])
PLANES = 3 * 512 * 512 * 8
K = 8 + 3 + 3 + 3  # features, normal, wo, wi


def mlp(width: int) -> int:
    return (K * width + width) + 3 * (width * width + width) + (width * 6 + 6)


def count(preset: str) -> tuple[int, int]:
    model = NeuralAsset(PRESETS[preset].model, BOUNDS)
    return tuple(
        sum(p.numel() for p in part.parameters()) for part in (model.triplane, model.decoder)
    )


@pytest.mark.parametrize(("preset", "width"), [("paper-hq", 512), ("paper-small", 64)])
def test_parameters_of_the_paper(preset: str, width: int) -> None:
    assert count(preset) == (PLANES, mlp(width))


def test_ours_ask_no_dearer_decoder() -> None:
    """`small` adds five inputs to the paper's decoder; `hq` is about a quarter of the paper's."""
    assert count("small")[1] == count("paper-small")[1] + 5 * 64
    assert count("hq")[1] < 0.27 * count("paper-hq")[1]


@pytest.mark.parametrize("preset", ["paper-hq", "paper-small"])
def test_training_of_the_paper(preset: str) -> None:
    config = PRESETS[preset].training
    assert config.steps == 100_000
    assert config.learning_rate == config.plane_learning_rate == 1e-3
    assert config.blur == 4.0


@pytest.mark.parametrize("preset", ["paper-hq", "paper-small"])
def test_the_learning_rate_is_halved_each_fifth(preset: str) -> None:
    rates = learning_rates(preset, steps=100)
    for fifth in range(5):
        assert rates[20 * fifth : 20 * fifth + 20] == [1e-3 * 0.5**fifth] * 20


def test_our_learning_rate_falls_to_nothing() -> None:
    rates = learning_rates("small", steps=100)
    assert all(a >= b for a, b in pairwise(rates))
    assert rates[-1] < 0.01 * rates[0]


def learning_rates(preset: str, steps: int) -> list[float]:
    full = PRESETS[preset]
    small = full.model.model_copy(update={"resolution": 16, "width": 8})
    module = NeuralAssetTraining(
        full.model_copy(update={"model": small}), BOUNDS, 1.0, 1.0, steps, [], Path(), {}
    )
    configured = module.configure_optimizers()
    optimizer, scheduler = configured["optimizer"], configured["lr_scheduler"]["scheduler"]
    rates = []
    for _ in range(steps):
        rates.append(optimizer.param_groups[0]["lr"])
        optimizer.step()
        scheduler.step()
    return rates


@pytest.mark.parametrize("preset", PRESETS)
def test_blur_goes_from_4_to_1_over_the_first_fifth(
    preset: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    full = PRESETS[preset]
    small = full.model.model_copy(update={"resolution": 16, "width": 8})
    module = NeuralAssetTraining(
        full.model_copy(update={"model": small}), BOUNDS, 1.0, 1.0, 100, [], Path(), {}
    )
    monkeypatch.setattr(module, "log", lambda *_, **__: None)
    used = []
    forward = module.model.forward
    monkeypatch.setattr(module.model, "forward", lambda *a: used.append(a[4]) or forward(*a))
    rows = torch.rand(4, 16)
    for step in (0, 5, 10, 19, 20, 50, 99):
        monkeypatch.setattr(NeuralAssetTraining, "global_step", step)
        module.training_step(rows, 0)
    assert used == pytest.approx([4.0, 3.25, 2.5, 1.15, 1.0, 1.0, 1.0])


@pytest.mark.parametrize("preset", PRESETS)
def test_the_planes_start_small_and_the_answer_finite(preset: str) -> None:
    small = PRESETS[preset].model.model_copy(update={"resolution": 8})
    model = NeuralAsset(small, BOUNDS)
    n = torch.tensor([[0.0, 1.0, 0.0]])
    y = model(torch.zeros(1, 3), n, n, n)
    assert y.shape == (1, 2, 3)
    assert y.abs().max() < math.log1p(10.0)

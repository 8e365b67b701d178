"""The paper's presets are the paper's."""

from __future__ import annotations

import math
from itertools import pairwise
from pathlib import Path

import pytest
import torch

from rna_export.capture.manifest import SAMPLE_FIELDS
from rna_export.training.lightning_module import NeuralAssetTraining
from rna_export.training.model import NeuralAsset
from rna_export.training.pace import StepPace
from rna_export.training.presets import PRESETS

ALL = [(kind, preset) for kind in PRESETS for preset in PRESETS[kind]]
PAPER = [(kind, preset) for kind, preset in ALL if preset.startswith("paper")]
BOUNDS = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])
PLANES = 3 * 512 * 512 * 8
COLUMNS = {  # of the paper: features, normal, wo, wi; features, tangent, h, wo, wi
    "surface": 8 + 3 + 3 + 3,
    "fiber": 8 + 3 + 1 + 3 + 3,
}


def mlp(columns: int, width: int) -> int:
    return (columns * width + width) + 3 * (width * width + width) + (width * 6 + 6)


def count(kind: str, preset: str) -> tuple[int, int]:
    model = NeuralAsset(PRESETS[kind][preset].model, BOUNDS)
    return tuple(
        sum(p.numel() for p in part.parameters()) for part in (model.triplane, model.decoder)
    )


@pytest.mark.parametrize("kind", PRESETS)
@pytest.mark.parametrize(("preset", "width"), [("paper-hq", 512), ("paper-small", 64)])
def test_parameters_of_the_paper(kind: str, preset: str, width: int) -> None:
    assert count(kind, preset) == (PLANES, mlp(COLUMNS[kind], width))


def test_ours_ask_no_dearer_decoder() -> None:
    """`small` adds few inputs to the paper's decoder; `hq` is about a quarter of the paper's."""
    assert count("surface", "small")[1] == count("surface", "paper-small")[1] + 8 * 64
    assert count("fiber", "small")[1] == count("fiber", "paper-small")[1] + (8 + 9) * 64 + 3 * 65
    for kind in PRESETS:
        assert count(kind, "hq")[1] < 0.28 * count(kind, "paper-hq")[1]


@pytest.mark.parametrize(("kind", "preset"), PAPER)
def test_training_of_the_paper(kind: str, preset: str) -> None:
    config = PRESETS[kind][preset].training
    assert config.steps == 100_000
    assert config.learning_rate == config.plane_learning_rate == 1e-3
    assert config.blur == 4.0


@pytest.mark.parametrize(("kind", "preset"), PAPER)
def test_the_learning_rate_is_halved_each_fifth(kind: str, preset: str) -> None:
    rates = learning_rates(kind, preset, steps=100)
    for fifth in range(5):
        assert rates[20 * fifth : 20 * fifth + 20] == [1e-3 * 0.5**fifth] * 20


@pytest.mark.parametrize("kind", PRESETS)
def test_our_learning_rate_falls_to_nothing(kind: str) -> None:
    rates = learning_rates(kind, "small", steps=100)
    assert all(a >= b for a, b in pairwise(rates))
    assert rates[-1] < 0.01 * rates[0]


def make_training(kind: str, preset: str, steps: int) -> NeuralAssetTraining:
    small = PRESETS[kind][preset].with_model(resolution=16, width=8).with_training(loss="log")
    fields = SAMPLE_FIELDS[kind]
    pace = StepPace(steps)
    return NeuralAssetTraining(small, BOUNDS, 1.0, 1.0, pace, fields, [], Path(), {})


def learning_rates(kind: str, preset: str, steps: int) -> list[float]:
    module = make_training(kind, preset, steps)
    configured = module.configure_optimizers()
    optimizer, scheduler = configured["optimizer"], configured["lr_scheduler"]["scheduler"]
    rates = []
    for _ in range(steps):
        rates.append(optimizer.param_groups[0]["lr"])
        optimizer.step()
        scheduler.step()
    return rates


@pytest.mark.parametrize(("kind", "preset"), ALL)
def test_blur_goes_from_4_to_1_over_the_first_fifth(
    kind: str, preset: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = make_training(kind, preset, steps=100)
    monkeypatch.setattr(module, "log", lambda *_, **__: None)
    used = []
    forward = module.model.forward
    monkeypatch.setattr(module.model, "forward", lambda *a: used.append(a[1]) or forward(*a))
    rows = torch.rand(4, sum(SAMPLE_FIELDS[kind].values()))
    for step in (0, 5, 10, 19, 20, 50, 99):
        monkeypatch.setattr(NeuralAssetTraining, "global_step", step)
        module.training_step(rows, 0)
    assert used == pytest.approx([4.0, 3.25, 2.5, 1.15, 1.0, 1.0, 1.0])


@pytest.mark.parametrize(("kind", "preset"), ALL)
def test_the_planes_start_small_and_the_answer_finite(kind: str, preset: str) -> None:
    small = PRESETS[kind][preset].model.model_copy(update={"resolution": 8})
    model = NeuralAsset(small, BOUNDS)
    n, zero = torch.tensor([[0.0, 1.0, 0.0]]), torch.zeros(1, 3)
    at = {"position": zero, "normal": n, "tangent": n, "h": zero[:, 0], "wo": n, "wi": n}
    y = model(at)
    assert y.shape == (1, 3 if small.separates_direct else 2, 3)
    assert y.abs().max() < math.log1p(10.0)

"""The paper's presets are the paper's."""

import pytest
import torch

from rna_export.capture.dataset.dataset_manifest import SAMPLE_FIELDS
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization import fitting as fitting_module
from rna_export.training.optimization.fitting import Fitting, rate
from rna_export.training.optimization.optimizers import muon_matrices
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
def test_parameters_of_the_paper(kind, preset, width):
    assert count(kind, preset) == (PLANES, mlp(COLUMNS[kind], width))


def test_ours_ask_no_dearer_decoder():
    """`small` adds few inputs to the paper's decoder; `hq` is about a quarter of the paper's."""
    # Visible light alone; that of shadowed light is small, and asked in its place.
    assert count("surface", "small")[1] == count("surface", "paper-small")[1] + 11 * 64 - 3 * 65
    assert count("fiber", "small")[1] == count("fiber", "paper-small")[1] + (8 + 9) * 64 + 3 * 65
    for kind in PRESETS:
        assert count(kind, "hq")[1] < 0.28 * count(kind, "paper-hq")[1]


@pytest.mark.parametrize(("kind", "preset"), PAPER)
def test_the_learning_rate_is_halved_each_fifth(kind, preset):
    rates = learning_rates(kind, preset, steps=100)
    for fifth in range(5):
        assert rates[20 * fifth : 20 * fifth + 20] == [1e-3 * 0.5**fifth] * 20


def test_planes_of_few_samples_are_smoothed_more():
    small, fiber = PRESETS["surface"]["small"], PRESETS["fiber"]["small"]
    smoothings = [small.for_rows(rows).training.smoothing for rows in (10_000_000, 3_200_000, 1000)]
    assert smoothings == pytest.approx([0.25, 0.5, 2.0])
    for preset in (fiber, PRESETS["surface"]["paper-small"]):
        assert preset.for_rows(1000) == preset


def learning_rates(kind: str, preset: str, steps: int) -> list[float]:
    config = PRESETS[kind][preset].training
    return [config.learning_rate * rate(config, step / steps) for step in range(steps)]


@pytest.mark.parametrize(("kind", "preset"), ALL)
def test_a_step_takes_the_rates_of_the_schedule(kind, preset):
    fitting, rows = make_fitting(kind, preset)
    config = PRESETS[kind][preset].training
    before = [p.detach().clone() for p in fitting.model.parameters()]
    fitting.step(rows, 0.7)
    muon = {id(m) for m in muon_matrices(fitting.model, config)}
    of_muon = {name for name, p in fitting.model.named_parameters() if id(p) in muon}
    # The first step of Adam is as long as the rate, wherever there is a gradient.
    moved = {
        name: (after - old).abs().max().item()
        for (name, after), old in zip(fitting.model.named_parameters(), before, strict=True)
        if name not in of_muon
    }
    assert moved.pop("triplane.planes") == pytest.approx(
        config.plane_learning_rate * rate(config, 0.7), rel=0.02
    )
    assert max(moved.values()) == pytest.approx(config.learning_rate * rate(config, 0.7), rel=0.02)


def make_fitting(kind: str, preset: str) -> tuple[Fitting, torch.Tensor]:
    small = PRESETS[kind][preset].with_model(resolution=16, width=8).with_training(loss="log")
    fields = SAMPLE_FIELDS[kind]
    torch.manual_seed(0)
    rows = torch.rand(200, sum(fields.values()))
    return Fitting(small, BOUNDS, 1.0, 1.0, fields), rows


@pytest.mark.parametrize(("kind", "preset"), ALL)
def test_blur_goes_from_4_to_1_over_the_first_fifth(kind, preset, monkeypatch):
    fitting, rows = make_fitting(kind, preset)
    used, sample_loss = [], fitting_module.sample_loss
    monkeypatch.setattr(
        fitting_module, "sample_loss", lambda *a: used.append(a[2]) or sample_loss(*a)
    )
    for progress in (0.0, 0.05, 0.1, 0.19, 0.2, 0.5, 0.99):
        fitting.step(rows, progress)
    assert used == pytest.approx([4.0, 3.25, 2.5, 1.15, 1.0, 1.0, 1.0])


@pytest.mark.parametrize("kind", PRESETS)
@pytest.mark.parametrize(("preset", "ending"), [("small", "unbiased"), ("paper-small", "log")])
def test_ours_end_with_the_unbiased_loss(kind, preset, ending, monkeypatch):
    fitting, rows = make_fitting(kind, preset)
    used, sample_loss = [], fitting_module.sample_loss
    monkeypatch.setattr(
        fitting_module, "sample_loss", lambda *a: used.append(a[3]) or sample_loss(*a)
    )
    for progress in (0.0, 0.89, 0.91):
        fitting.step(rows, progress)
    assert used == ["log", "log", ending]

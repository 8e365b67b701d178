"""The grids of models: what they hold, and how they are named."""

import pytest
import torch

from rna_bench.frontier.trials.feature_network import NetworkAsset
from rna_bench.frontier.trials.grid import PAPER_ARCHITECTURES, full_grid, short_grid
from rna_bench.frontier.trials.trial import Trial
from rna_export.training.model.neural_asset import NeuralAsset

KINDS = ("surface", "fiber")


def of_table(trials: list[Trial], table: str) -> list[tuple[int, int, int]]:
    models = [trial.preset.model for trial in trials if table in trial.tables]
    return [(m.hidden_layers, m.width, m.channels) for m in models]


@pytest.mark.parametrize("kind", KINDS)
def test_full_grid_holds_the_papers_tables_row_for_row(kind):
    grid = full_grid(kind)
    actual = of_table(grid, "architecture")
    assert sorted(actual) == sorted((*shape, 8) for shape in PAPER_ARCHITECTURES)
    assert sorted(c for _, _, c in of_table(grid, "channels")) == [4, 8, 16, 32]
    assert all(t.preset.training.schedule == "halving" for t in grid if t.family == "paper")


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("grid", [full_grid, short_grid])
def test_names_are_unique_and_steps_equal(grid, kind):
    trials = grid(kind, 123)
    assert len({trial.name for trial in trials}) == len(trials)
    assert {trial.preset.training.steps for trial in trials} == {123}


@pytest.mark.parametrize("kind", KINDS)
def test_short_grid_is_part_of_the_full_one(kind):
    full = {trial.name: trial for trial in full_grid(kind, 100)}
    assert all(full[trial.name] == trial for trial in short_grid(kind, 100))
    assert {t.preset.model.width for t in short_grid(kind)} == {16, 32, 64, 128, 256, 512}


@pytest.mark.parametrize("kind", KINDS)
def test_nrhints_costs_what_paper_hq_does(kind):
    trials = {trial.name: trial for trial in short_grid(kind)}
    network = trials["nrhints"]
    assert not network.has_planes
    bounds = torch.tensor([[0.0] * 3, [1.0] * 3])
    counts = [
        NetworkAsset(network.preset.model, bounds).multiply_adds,
        NeuralAsset(trials[network.cost_as].preset.model, bounds).multiply_adds,
    ]
    assert abs(counts[0] / counts[1] - 1.0) < 0.02


def test_fibers_without_h_have_no_input_of_it():
    (trial,) = [t for t in short_grid("fiber") if "no-h" in t.tables]
    assert not {"h", "fiber_lobes"} & set(trial.preset.model.inputs)

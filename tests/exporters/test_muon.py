"""Muon against its definition and PyTorch's, and what of a model it takes."""

import pytest
import torch

from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization.muon import Muon, orthogonalised
from rna_export.training.optimization.optimizers import (
    load_states,
    muon_matrices,
    optimizers_of,
    set_rates,
)
from rna_export.training.presets import PRESETS

BOUNDS = torch.tensor([[-1.0] * 3, [1.0] * 3])
SHAPES = (32, 32), (32, 18), (32, 50), (20, 7)


def random(shape: tuple[int, ...], seed: int = 0) -> torch.Tensor:
    return torch.randn(shape, generator=torch.Generator().manual_seed(seed))


@pytest.mark.parametrize("shape", SHAPES)
def test_singular_values_become_one(shape):
    matrix = random((1, *shape))
    u, s, vh = torch.linalg.svd(orthogonalised(matrix)[0], full_matrices=False)
    assert 0.6 < s[s > 0.3].min() and s.max() < 1.3
    assert (s > 0.6).float().mean() > 0.9  # except for values near 0
    old_u, _, old_vh = torch.linalg.svd(matrix[0], full_matrices=False)
    assert torch.allclose(u @ s.diag() @ vh, orthogonalised(matrix)[0], atol=1e-5)
    along = (old_u.T @ orthogonalised(matrix)[0] @ old_vh.T).diag()
    assert torch.allclose(along.sort().values, s.sort().values, atol=1e-3)


def test_columns_of_zeros_change_nothing():
    matrix = random((1, 32, 18))
    padded = torch.nn.functional.pad(matrix, (0, 14))
    actual = orthogonalised(padded)
    assert torch.allclose(actual[:, :, :18], orthogonalised(matrix), atol=1e-4)
    assert not actual[:, :, 18:].any()


def test_steps_are_those_of_torch():
    """PyTorch's, which iterates in bfloat16 over one matrix at a time."""
    start = [random(shape, k) for k, shape in enumerate(SHAPES)]
    ours = [m.clone().requires_grad_() for m in start]
    twins = [m.clone().requires_grad_() for m in start]
    optimizers = Muon(ours, 0.1), torch.optim.Muon(twins, 0.1, weight_decay=0.0)
    for k in range(6):
        for matrices in (ours, twins):
            for i, matrix in enumerate(matrices):
                matrix.grad = random(matrix.shape, 10 * k + i)
        for optimizer in optimizers:
            optimizer.step()
    for one, twin, first in zip(ours, twins, start, strict=True):
        assert (one - twin).norm() < 0.05 * (one - first).norm()


def test_it_goes_on_from_its_state():
    matrices = [torch.ones(8, 8, requires_grad=True) for _ in range(2)]
    optimizers = [Muon([m], 0.1) for m in matrices]
    for k in range(6):
        if k == 3:
            matrices[1] = matrices[1].detach().clone().requires_grad_()
            saved = optimizers[1].state_dict()
            optimizers[1] = Muon([matrices[1]], 0.1)
            optimizers[1].load_state_dict(saved)
        for matrix, optimizer in zip(matrices, optimizers, strict=True):
            matrix.grad = random((8, 8), k)
            optimizer.step()
    assert torch.equal(*matrices)


@pytest.mark.parametrize("preset", ["tiny", "small", "hq"])
@pytest.mark.parametrize("kind", PRESETS)
def test_it_takes_all_matrices_but_the_last(kind, preset):
    chosen = PRESETS[kind][preset].with_model(resolution=4, emission_inputs=("features", "wo"))
    model = NeuralAsset(chosen.model, BOUNDS)
    names = {id(p): name for name, p in model.named_parameters()}
    taken = {names[id(m)] for m in muon_matrices(model, chosen.training)}
    layers = chosen.model.hidden_layers
    layers_of = {"decoder": layers, "emission.decoder": 2}
    layers_of |= {"shadow.decoder": 3} if chosen.model.shadow_width else {}
    assert taken == {f"{name}.{2 * k}.weight" for name, n in layers_of.items() for k in range(n)}
    groups = [g for o in optimizers_of(model, chosen.training) for g in o.param_groups]
    owned = [names[id(p)] for group in groups for p in group["params"]]
    assert sorted(owned) == sorted(names.values())  # each once


@pytest.mark.parametrize("preset", ["paper-small", "paper-hq"])
def test_the_papers_models_have_adam(preset):
    chosen = PRESETS["surface"][preset].with_model(resolution=4)
    model = NeuralAsset(chosen.model, BOUNDS)
    assert not muon_matrices(model, chosen.training)
    assert muon_matrices(model, chosen.with_training(optimizer="muon").training)


def test_rates_may_be_tensors():
    """As in a CUDA graph, which reads what they hold when it is launched."""
    matrices = [torch.zeros(8, 8, requires_grad=True) for _ in range(2)]
    rates = 0.1, torch.tensor(0.1)
    for matrix, lr in zip(matrices, rates, strict=True):
        optimizer = Muon([matrix], lr)
        optimizer.param_groups[0]["initial_lr"] = 0.1
        set_rates([optimizer], 0.5)
        matrix.grad = random((8, 8))
        optimizer.step()
    assert torch.equal(*matrices) and float(rates[1]) == pytest.approx(0.05)


def test_momentum_of_units_that_are_dead_ends_at_zero():
    """Subnormal numbers made steps three times as slow after 1,500 of them."""
    matrix = torch.zeros(16, 16, requires_grad=True)
    optimizer = Muon([matrix], 0.01)
    for k in range(1600):
        matrix.grad = random((16, 16), k)
        if k > 0:
            matrix.grad[3] = 0.0
        optimizer.step()
    momentum = optimizer.state[matrix]["momentum"]
    assert not momentum[3].any() and momentum[2].all()


def test_what_is_negligible_in_a_matrix_is_zero():
    matrix = random((1, 16, 16))
    matrix[0, 3] *= 1e-12
    assert not orthogonalised(matrix)[0, 3].any()


def test_rates_stay_the_same_tensors_when_a_run_goes_on():
    """A checkpoint is read into the host's memory; a GPU's optimizer wants its rate there."""
    matrices = [torch.zeros(8, 8, requires_grad=True) for _ in range(2)]
    rate = torch.tensor(0.1)
    first, second = Muon(matrices[:1], torch.tensor(0.3)), Muon(matrices[1:], rate)
    load_states([second], [first.state_dict()])
    assert second.param_groups[0]["lr"] is rate

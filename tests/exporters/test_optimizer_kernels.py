"""What a step of training does in kernels of its own, against PyTorch's."""

from itertools import pairwise

import pytest
import torch
from torch import nn

from rna_export.training.model.layers import through
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization import fitting
from rna_export.training.optimization.optimizers import PlaneAdam
from rna_export.training.presets import PRESETS


@pytest.mark.parametrize("size", [7, 5000])
def test_adam_is_that_of_torch(size):
    generator = torch.Generator().manual_seed(0)
    start = torch.randn(size, generator=generator)
    ours, twin = start.clone().requires_grad_(), start.clone().requires_grad_()
    optimizers = PlaneAdam(ours, lr=1e-2), torch.optim.Adam([twin], lr=1e-2)
    for k in range(50):
        gradient = torch.randn(size, generator=generator) * 10.0 ** (k % 5 - 4)
        gradient[k % 3 :: 3] = 0.0
        ours.grad += gradient
        twin.grad = gradient
        for optimizer in optimizers:
            optimizer.param_groups[0]["lr"] = 1e-2 / (1 + k)
            optimizer.step()
        assert not ours.grad.any()
    assert torch.allclose(ours, twin, rtol=1e-4, atol=1e-6)


def test_adam_goes_on_from_its_state():
    planes = [torch.ones(10, requires_grad=True) for _ in range(2)]
    whole = PlaneAdam(planes[0], lr=0.1)
    for k in range(6):
        planes[0].grad += k
        whole.step()
    first = PlaneAdam(planes[1], lr=0.1)
    for k in range(3):
        planes[1].grad += k
        first.step()
    second = PlaneAdam(planes[1], lr=0.1)
    second.load_state_dict(first.state_dict())
    for k in range(3, 6):
        planes[1].grad += k
        second.step()
    assert torch.equal(planes[0], planes[1])


def test_layers_are_those_of_autograd():
    torch.manual_seed(0)
    layers = nn.Sequential(nn.Linear(5, 9), nn.ReLU(), nn.Linear(9, 8), nn.ReLU(), nn.Linear(8, 3))
    x = torch.randn(40, 5, requires_grad=True)
    weights = torch.randn(40, 3)
    gradients = []
    for function in (lambda: through(layers, x), lambda: layers(x)):
        actual = function()
        gradients.append(torch.autograd.grad((actual * weights).sum(), [x, *layers.parameters()]))
    assert torch.allclose(actual, through(layers, x), atol=1e-6)
    for ours, expected in zip(*gradients, strict=True):
        assert torch.allclose(ours, expected, atol=1e-5)


def test_bfloat16_layers_are_near_those_in_float32():
    torch.manual_seed(0)
    sizes = [5, 128, 128, 128, 3]
    linear = [nn.Linear(a, b) for a, b in pairwise(sizes)]
    layers = nn.Sequential(*(part for layer in linear for part in (layer, nn.ReLU())))[:-1]
    x, weights = torch.randn(400, 5, requires_grad=True), torch.randn(400, 3)
    answers, gradients = [], []
    for bfloat16 in (False, True):
        answers.append(through(layers, x, bfloat16))
        loss = (answers[-1] * weights).sum()
        gradients.append(torch.autograd.grad(loss, [x, *layers.parameters()]))
    assert not torch.equal(*answers)
    assert (answers[1] - answers[0]).norm() / answers[0].norm() < 0.01
    for exact, actual in zip(*gradients, strict=True):
        assert actual.dtype == torch.float32
        assert (actual - exact).norm() / exact.norm() < 0.1


@pytest.mark.parametrize(
    ("width", "products", "has_instructions", "expected"),
    [
        (128, "auto", True, True),
        (64, "auto", True, False),
        (128, "float32", True, False),
        (128, "auto", False, False),
    ],
)
def test_bfloat16_is_for_wide_decoders_where_the_processor_has_it(
    monkeypatch,
    width,
    products,
    has_instructions,
    expected,
):
    monkeypatch.setattr(fitting, "multiplies_bfloat16", lambda: has_instructions)
    monkeypatch.setattr(torch.cuda, "is_bf16_supported", lambda: has_instructions)
    preset = PRESETS["surface"]["small"].with_model(width=width).with_training(products=products)
    for device in ("cpu", "cuda"):
        assert fitting.multiplies_in_bfloat16(preset, device) == expected


def test_only_steps_are_in_bfloat16():
    config = PRESETS["surface"]["small"].model.model_copy(update={"width": 128, "resolution": 8})
    torch.manual_seed(0)
    model = NeuralAsset(config, torch.tensor([[-1.0] * 3, [1.0] * 3]))
    at = {name: torch.nn.functional.normalize(torch.randn(9, 3)) for name in ("normal", "wo", "wi")}
    at["position"] = torch.rand(9, 3)
    in_steps = model(at).detach()
    with torch.no_grad():
        in_float32 = model(at)
    model.multiplies_in_bfloat16 = True
    assert not torch.equal(model(at), in_steps)
    with torch.no_grad():
        assert torch.equal(model(at), in_float32)

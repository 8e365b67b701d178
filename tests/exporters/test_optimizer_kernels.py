"""What a step of training does in kernels of its own, against PyTorch's."""

from __future__ import annotations

import pytest
import torch
from torch import nn

from rna_export.training.layers import through
from rna_export.training.plane_adam import PlaneAdam


@pytest.mark.parametrize("size", [7, 5000])
def test_adam_is_that_of_torch(size: int) -> None:
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


def test_adam_goes_on_from_its_state() -> None:
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


def test_layers_are_those_of_autograd() -> None:
    torch.manual_seed(0)
    layers = nn.Sequential(nn.Linear(5, 9), nn.ReLU(), nn.Linear(9, 8), nn.ReLU(), nn.Linear(8, 3))
    x = torch.randn(40, 5, requires_grad=True)
    weights = torch.randn(40, 3)
    gradients = []
    for function in (lambda: through(layers, x), lambda: layers(x)):
        found = function()
        gradients.append(torch.autograd.grad((found * weights).sum(), [x, *layers.parameters()]))
    assert torch.allclose(found, through(layers, x), atol=1e-6)
    for ours, expected in zip(*gradients, strict=True):
        assert torch.allclose(ours, expected, atol=1e-5)

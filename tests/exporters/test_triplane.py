"""The planes in PyTorch against the runtime's plain twin, and against PyTorch's own sampler."""

import numpy as np
import pytest
import torch

from rna_export.training.model.triplane import PLANE_AXES, Triplane, blurred, diffused, gathered
from tests.reference.queries import triplane_features

LOW, HIGH = torch.tensor([-1.0, 0.0, 2.0]), torch.tensor([1.0, 3.0, 2.5])


@pytest.fixture
def triplane():
    torch.manual_seed(0)
    result = Triplane(11, 5, LOW, HIGH)
    result.planes.data.normal_()  # far from where training starts, so that errors show
    return result


@pytest.fixture
def positions():
    """Inside, on the box, at texel centres, and outside."""
    p = torch.rand(500, 3, generator=torch.Generator().manual_seed(1))
    edges = torch.cartesian_prod(*[torch.tensor([0.0, 0.5 / 11, 0.5, 1.0])] * 3)
    outside = torch.tensor([[-0.3, 0.5, 0.5], [0.5, 1.7, 0.5], [2.0, -2.0, 9.0]])
    return LOW + (HIGH - LOW) * torch.cat([p, edges, outside])


def test_equals_the_reference(triplane, positions):
    p = ((positions - LOW) / (HIGH - LOW)).clamp(0.0, 1.0).double().numpy()
    expected = triplane_features(triplane.planes.detach().numpy(), p)
    assert np.abs(triplane(positions).detach().numpy() - expected).max() < 1e-5


def test_values_and_gradients_are_those_of_grid_sample(triplane, positions):
    p = 2.0 * (positions - LOW) / (HIGH - LOW) - 1.0
    planes = triplane.planes.detach().requires_grad_()
    expected = torch.zeros(len(p), 5)
    for plane, (column, row) in zip(planes, PLANE_AXES, strict=True):
        sampled = torch.nn.functional.grid_sample(
            plane.permute(2, 0, 1)[None],
            p[None, :, None, [column, row]],
            padding_mode="border",
            align_corners=False,
        )
        expected = expected + sampled[0, :, :, 0].T
    actual = triplane(positions)
    assert torch.allclose(actual, expected, atol=1e-5)
    weights = torch.randn(len(positions), 5, generator=torch.Generator().manual_seed(2))
    (actual * weights).sum().backward()
    (expected * weights).sum().backward()
    assert torch.allclose(triplane.planes.grad, planes.grad, atol=1e-4)


@pytest.mark.parametrize("blur", [1.0, 1.2, 4.0])
def test_compiled_kernels_equal_their_twins(triplane, positions, blur):
    p = (positions - LOW) / (HIGH - LOW)
    weights = torch.randn(len(p), 5, generator=torch.Generator().manual_seed(3))
    twin = triplane.planes.detach().clone().requires_grad_()
    expected = gathered(blurred(twin, blur) if blur > 1.0 else twin, p)
    actual = triplane(positions, blur)
    assert torch.allclose(actual, expected, atol=1e-5)
    (actual * weights).sum().backward()
    (expected * weights).sum().backward()
    assert torch.allclose(triplane.planes.grad, twin.grad, atol=1e-4)


def test_blur_of_one_texel_is_none(triplane, positions):
    assert torch.equal(triplane(positions, blur=1.0), triplane(positions))


def test_blur_fades_to_none(triplane):
    planes = triplane.planes.detach()
    change = [(blurred(planes, b) - planes).abs().max().item() for b in (4.0, 2.0, 1.3, 1.05)]
    assert change == sorted(change, reverse=True)
    assert change[0] > 0.1 and change[-1] < 1e-6


def test_blur_keeps_a_constant_and_the_mean():
    constant = torch.full((3, 12, 12, 2), 0.7)
    assert torch.allclose(blurred(constant, 4.0), constant, atol=1e-6)
    spot = torch.zeros(3, 33, 33, 1)
    spot[:, 16, 16] = 1.0  # far from the edges, where the border repeats
    smooth = blurred(spot, 4.0)
    assert torch.allclose(smooth.sum(dim=(1, 2, 3)), torch.ones(3), atol=1e-5)
    assert smooth.max() < 0.2


def test_blur_has_its_width():
    """Standard deviation of (footprint - 1) / 2 texels."""
    spot = torch.zeros(1, 65, 65, 1)
    spot[:, 32, 32] = 1.0
    row = blurred(spot, 4.0)[0, :, :, 0].sum(dim=0)
    offset = torch.arange(65) - 32.0
    deviation = ((row * offset**2).sum() / row.sum()).sqrt().item()
    assert deviation == pytest.approx(1.5, rel=0.06)  # the kernel ends at 2.5 of it


def test_smoothing_exchanges_between_neighbours(triplane):
    before = triplane.planes.detach().clone()
    expected = diffused(before, 0.2)
    triplane.smooth(0.2)
    actual = triplane.planes.detach()
    assert torch.allclose(actual, expected, atol=1e-6)
    assert torch.allclose(actual.sum((1, 2)), before.sum((1, 2)), atol=1e-4)
    texel = torch.zeros(3, 5, 5, 1)
    texel[:, 2, 0] = 1.0  # at an edge: nothing leaves
    row = torch.tensor([0.8, 0.2, 0.0, 0.0, 0.0])
    column = torch.tensor([0.0, 0.2, 0.6, 0.2, 0.0])
    assert torch.allclose(diffused(texel, 0.2)[0, :, :, 0], column[:, None] * row, atol=1e-6)

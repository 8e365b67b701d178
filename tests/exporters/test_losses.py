from __future__ import annotations

import pytest
import torch
from rna_export.training.losses import LOSSES, log_l2, relative_l2


def settle(loss, targets: torch.Tensor) -> float:
    """The radiance that one prediction comes to rest at, for all these targets."""
    y = torch.tensor(0.3, requires_grad=True)
    optimizer = torch.optim.Adam([y], lr=0.02)
    for step in range(400):
        optimizer.param_groups[0]["lr"] = 0.02 * (1.0 - step / 400)
        optimizer.zero_grad()
        loss(y.expand_as(targets), targets).backward()
        optimizer.step()
    return torch.expm1(y).item()


@pytest.fixture
def noisy() -> torch.Tensor:
    """Targets of mean 0.5, as few paths give them: mostly dark, some very bright."""
    generator = torch.Generator().manual_seed(0)
    bright = torch.rand(3000, 3, generator=generator) < 0.1
    return torch.where(bright, 5.0, 0.0)


def test_noise_does_not_bias_relative_l2(noisy: torch.Tensor) -> None:
    assert settle(relative_l2, noisy) == pytest.approx(noisy.mean().item(), rel=0.01)


def test_noise_darkens_log_l2(noisy: torch.Tensor) -> None:
    # It settles at the mean of log(1 + x): about 6^0.1 - 1 = 0.196, where 0.5 is right.
    settled = settle(log_l2, noisy)
    assert settled == pytest.approx(torch.log1p(noisy).mean().expm1().item(), rel=0.01)
    assert settled < 0.45 * noisy.mean()


@pytest.mark.parametrize("name", LOSSES)
def test_the_target_itself_has_no_loss(name: str) -> None:
    target = torch.rand(50, 3, generator=torch.Generator().manual_seed(1))
    assert LOSSES[name](torch.log1p(target), target).item() < 1e-12


def test_log_l2_is_the_papers() -> None:
    y, target = torch.tensor([[0.1, 0.0, 1.0]]), torch.tensor([[0.0, 1.0, 2.0]])
    expected = ((y - torch.log(target + 1.0)) ** 2).mean()
    assert log_l2(y, target).item() == pytest.approx(expected.item())


def test_relative_l2_weighs_dark_errors_more() -> None:
    off = torch.tensor([[0.05, 0.05, 0.05]])
    dark, bright = torch.full((1, 3), 0.01), torch.full((1, 3), 3.0)
    dark_loss = relative_l2(torch.log1p(dark + off), dark)
    assert dark_loss > 10 * relative_l2(torch.log1p(bright + off), bright)


@pytest.mark.parametrize("name", LOSSES)
def test_gradients_stay_finite_far_off(name: str) -> None:
    y = torch.tensor([[-100.0, 0.0, 100.0]], requires_grad=True)
    LOSSES[name](y, torch.tensor([[0.0, 1e4, 1.0]])).backward()
    assert torch.isfinite(y.grad).all()

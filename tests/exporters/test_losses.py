import pytest
import torch

from rna_export.training.optimization.losses import log_l2, unbiased_l2


def settle(targets: torch.Tensor, loss=log_l2) -> float:
    """The radiance that one prediction comes to rest at, for all these targets."""
    y = torch.tensor(0.3, requires_grad=True)
    optimizer = torch.optim.Adam([y], lr=0.02)
    for step in range(400):
        optimizer.param_groups[0]["lr"] = 0.02 * (1.0 - step / 400)
        optimizer.zero_grad()
        loss(y.expand_as(targets), targets).backward()
        optimizer.step()
    return torch.expm1(y).item()


def test_is_the_papers():
    y, target = torch.tensor([[0.1, 0.0, 1.0]]), torch.tensor([[0.0, 1.0, 2.0]])
    expected = ((y - torch.log(target + 1.0)) ** 2).mean()
    assert log_l2(y, target).item() == pytest.approx(expected.item())


def test_the_target_itself_has_no_loss():
    target = torch.rand(50, 3, generator=torch.Generator().manual_seed(1))
    assert log_l2(torch.log1p(target), target).item() < 1e-12
    assert settle(target[:1, :1]) == pytest.approx(target[0, 0].item(), abs=1e-3)


def test_the_unit_scales_what_counts_as_bright():
    target = torch.rand(50, 3, generator=torch.Generator().manual_seed(1))
    unit = torch.tensor(0.05)
    assert log_l2(torch.log1p(target / unit), target, unit).item() < 1e-12
    dark, error = torch.tensor(0.01), 0.005
    small = log_l2(torch.log1p(dark + error), dark)
    assert log_l2(torch.log1p((dark + error) / unit), dark, unit) > 100.0 * small


@pytest.mark.parametrize("deviation", [0.1, 0.2])
def test_noise_darkens_by_half_its_variance(deviation):
    noise = torch.randn(20_000, generator=torch.Generator().manual_seed(0))
    targets = (0.6 + deviation * noise).clamp(min=0.0)
    darker = targets.mean().item() - settle(targets)
    expected = targets.var().item() / (2.0 * (1.0 + 0.6))  # of x; of log(x + 1) over 1 + x more
    assert darker == pytest.approx(expected, rel=0.1)


def test_noise_of_few_paths_darkens_much():
    """Mostly dark, sometimes bright: hair at one path a point."""
    bright = torch.rand(3000, generator=torch.Generator().manual_seed(0)) < 0.1
    targets = torch.where(bright, 5.0, 0.0)
    assert settle(targets) < 0.45 * targets.mean().item()


def test_noise_does_not_darken_the_unbiased_one():
    bright = torch.rand(3000, generator=torch.Generator().manual_seed(0)) < 0.1
    targets = torch.where(bright, 5.0, 0.0)
    assert settle(targets, unbiased_l2) == pytest.approx(targets.mean().item(), rel=0.02)


def test_near_the_truth_the_unbiased_one_is_the_papers():
    target = torch.rand(50, 3, generator=torch.Generator().manual_seed(1))
    y = torch.log1p(target + 1e-3)
    assert unbiased_l2(y, target).item() == pytest.approx(log_l2(y, target).item(), rel=1e-2)


@pytest.mark.parametrize("loss", [log_l2, unbiased_l2])
def test_gradients_stay_finite_far_off(loss):
    y = torch.tensor([[-100.0, 0.0, 80.0]], requires_grad=True)
    loss(y, torch.tensor([[0.0, 1e4, 1.0]])).backward()
    assert torch.isfinite(y.grad).all()

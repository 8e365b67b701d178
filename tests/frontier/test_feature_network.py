"""The features of NRHints' network: what they see, in which arithmetic, and who trains them."""

import pytest
import torch

from rna_bench.frontier.trials.feature_network import ENCODED_DIRECTIONS, NetworkAsset
from rna_bench.frontier.trials.grid import nrhints, with_our_optimizer
from rna_export.training.optimization.losses import sample_loss
from rna_export.training.optimization.optimizers import muon_matrices, optimizers_of
from tests.exporters.synthetic import tiny

BOUNDS = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])


def model_of(kind: str, **changes: object) -> NetworkAsset:
    torch.manual_seed(0)
    config = tiny(kind=kind).model.model_copy(update={"shadow_width": 0, **changes})
    return NetworkAsset(config, BOUNDS).eval()


def samples(n: int) -> dict[str, torch.Tensor]:
    torch.manual_seed(1)
    unit = torch.nn.functional.normalize(torch.randn(4, n, 3), dim=2)
    names = ("position", "normal", "wo", "wi")
    at = dict(zip(names, unit, strict=True))
    return {
        **at,
        "tangent": at["normal"],
        "h": torch.zeros(n),
        "radiance": torch.rand(n, 3),
        "direct": torch.zeros(n, 3),
        "visible": (torch.rand(n) > 0.5).float(),
    }


@pytest.mark.parametrize("kind", ["surface", "fiber"])
def test_feature_network_sees_position_and_directions(kind):
    channels = 12 + ENCODED_DIRECTIONS
    model = model_of(kind, width=48, channels=channels)
    at = samples(8)
    features = model.queries(at)[:, :channels]
    moved = model.queries({**at, "position": -at["position"]})[:, :channels]
    turned = model.queries({**at, "wi": -at["wi"]})[:, :channels]
    assert (features[:, :12] != moved[:, :12]).all()
    assert torch.equal(features[:, 12:], moved[:, 12:])
    assert torch.equal(features[:, :36], turned[:, :36])  # the position's, then wo's
    assert (features[:, 36:] != turned[:, 36:]).any(dim=1).all()
    sample_loss(model, at, 1.0).backward()
    assert all(p.grad is not None for p in model.network.parameters())


def test_feature_network_in_bfloat16_is_near_that_in_float32():
    model = model_of("surface", width=128, channels=64 + ENCODED_DIRECTIONS)
    at, answers, gradients = samples(400), [], []
    for bfloat16 in (False, True):
        model.multiplies_in_bfloat16 = bfloat16
        answers.append(model(at))
        loss = sample_loss(model, at, 1.0)
        gradients.append(torch.autograd.grad(loss, [*model.network.parameters()]))
    assert not torch.equal(*answers)
    assert (answers[1] - answers[0]).norm() / answers[0].norm() < 0.01
    for exact, actual in zip(*gradients, strict=True):
        assert actual.dtype == torch.float32
        assert (actual - exact).norm() / exact.norm() < 0.1


def test_muon_takes_its_matrices():
    chosen = with_our_optimizer(nrhints("surface")).preset
    model = NetworkAsset(chosen.model, BOUNDS)
    matrices = muon_matrices(model, chosen.training)
    assert len(matrices) == 4 + 8 and all(m.ndim == 2 for m in matrices)
    groups = [g for o in optimizers_of(model, chosen.training) for g in o.param_groups]
    owned = [p for group in groups for p in group["params"]]
    assert sorted(map(id, owned)) == sorted(map(id, model.parameters()))

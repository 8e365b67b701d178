"""Weights in the losses: what is learnt from chosen samples is what all would teach."""

from __future__ import annotations

import pytest
import torch

from rna_export.training.losses import sample_loss
from rna_export.training.model import NeuralAsset
from tests.exporters.synthetic import tiny

UNIT_BOX = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])


def batch(kind: str, target: torch.Tensor, weight: torch.Tensor | None) -> dict[str, torch.Tensor]:
    """Samples at one point, seen and lit alike, of these radiances (n,)."""
    n = len(target)
    up = torch.tensor([[0.0, 0.0, 1.0]]).repeat(n, 1)
    at = {"position": 0.5 * up, "wo": up, "wi": up, "visible": torch.ones(n)}
    at["radiance"] = target[:, None].expand(n, 3)
    if kind == "surface":
        at["normal"] = up
    else:
        at |= {"tangent": up.roll(1, 1), "h": torch.zeros(n), "direct": 0.25 * at["radiance"]}
    return at if weight is None else {**at, "weight": weight}


@pytest.mark.parametrize(
    ("kind", "loss"), [("surface", "log"), ("surface", "unbiased"), ("fiber", "log")]
)
def test_weights_give_the_gradient_of_all_samples(kind: str, loss: str) -> None:
    """Half of the dim samples, of twice the weight, are as good as all of them."""
    torch.manual_seed(0)
    model = NeuralAsset(tiny(kind=kind).model, UNIT_BOX)
    dim, bright = torch.full((8,), 0.2), torch.full((8,), 1.0)
    every = torch.cat([dim, bright])
    chosen, weight = torch.cat([dim[:4], bright]), torch.tensor([2.0] * 4 + [1.0] * 8)

    def gradient(at: dict[str, torch.Tensor], share: float) -> torch.Tensor:
        model.zero_grad()
        (share * sample_loss(model, at, 1.0, loss)).backward()
        return torch.cat([p.grad.reshape(-1) for p in model.decoder.parameters()])

    expected = gradient(batch(kind, every, None), 1.0)
    weighted = gradient(batch(kind, chosen, weight), 12 / 16)
    torch.testing.assert_close(weighted, expected, rtol=1e-4, atol=1e-6)
    assert not torch.allclose(gradient(batch(kind, chosen, None), 1.0), expected, rtol=1e-2)

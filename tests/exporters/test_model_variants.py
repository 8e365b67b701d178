"""Models without the visibility hint, which stand in comparisons."""

from __future__ import annotations

import onnxruntime
import pytest
import torch

from rna_export.export.decoder import compare_decoder, decoders_of, export_decoder, random_queries
from rna_export.training.model.neural_asset import NeuralAsset, new_model
from rna_export.training.optimization.losses import sample_loss
from tests.exporters.synthetic import tiny

BOUNDS = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])


def model_of(kind: str, **changes: object) -> NeuralAsset:
    torch.manual_seed(0)
    config = tiny(kind=kind).model.model_copy(update={"shadow_width": 0, **changes})
    return new_model(config, BOUNDS).eval()


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
@pytest.mark.parametrize("hint", [True, False])
def test_decoder_adds_its_colours_up(kind: str, hint: bool) -> None:
    model = model_of(kind, visibility_hint=hint)
    (main,) = decoders_of(model)
    decoder = export_decoder(main)
    compare_decoder(decoder, main)
    session = onnxruntime.InferenceSession(decoder, providers=["CPUExecutionProvider"])
    queries = random_queries(main, 50, 3).detach().numpy()
    (actual,) = session.run(None, {"queries": queries})
    assert actual.shape == (50, 6)
    assert (abs(actual[:, :3] - actual[:, 3:]).max() < 1e-6) == (not hint)


@pytest.mark.parametrize("kind", ["surface", "fiber"])
def test_loss_without_hint_sees_no_visibility(kind: str) -> None:
    at = samples(64)
    other = {**at, "visible": 1.0 - at["visible"]}
    with_hint, without = model_of(kind), model_of(kind, visibility_hint=False)
    assert sample_loss(without, at, 1.0) == sample_loss(without, other, 1.0)
    assert sample_loss(with_hint, at, 1.0) != sample_loss(with_hint, other, 1.0)

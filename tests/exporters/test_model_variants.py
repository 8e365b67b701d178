"""Models that stand in comparisons only: without the hint, with a uv texture or a network."""

from __future__ import annotations

import onnxruntime
import pytest
import torch

from rna_export.export.decoder import compare_decoder, export_decoder, random_queries
from rna_export.training.model.feature_network import ENCODED_DIRECTIONS
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.model.uv_texture import UvTexture
from rna_export.training.optimization.losses import sample_loss
from tests.exporters.synthetic import tiny

BOUNDS = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])


def model_of(kind: str, **changes: object) -> NeuralAsset:
    torch.manual_seed(0)
    return NeuralAsset(tiny(kind=kind).model.model_copy(update=changes), BOUNDS).eval()


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
    decoder = export_decoder(model)
    compare_decoder(decoder, model)
    session = onnxruntime.InferenceSession(decoder, providers=["CPUExecutionProvider"])
    queries = random_queries(model, 50, 3).detach().numpy()
    (found,) = session.run(None, {"queries": queries})
    assert found.shape == (50, 6)
    assert (abs(found[:, :3] - found[:, 3:]).max() < 1e-6) == (not hint)


@pytest.mark.parametrize("kind", ["surface", "fiber"])
def test_loss_without_hint_sees_no_visibility(kind: str) -> None:
    at = samples(64)
    other = {**at, "visible": 1.0 - at["visible"]}
    with_hint, without = model_of(kind), model_of(kind, visibility_hint=False)
    assert sample_loss(without, at, 1.0) == sample_loss(without, other, 1.0)
    assert sample_loss(with_hint, at, 1.0) != sample_loss(with_hint, other, 1.0)


@pytest.mark.parametrize("kind", ["surface", "fiber"])
def test_feature_network_sees_position_and_directions(kind: str) -> None:
    channels = 12 + ENCODED_DIRECTIONS
    model = model_of(kind, texture="network", width=48, channels=channels)
    at = samples(8)
    features = model.queries(at)[:, :channels]
    moved = model.queries({**at, "position": -at["position"]})[:, :channels]
    turned = model.queries({**at, "wi": -at["wi"]})[:, :channels]
    assert (features[:, :12] != moved[:, :12]).all()
    assert torch.equal(features[:, 12:], moved[:, 12:])
    assert torch.equal(features[:, :36], turned[:, :36])  # the position's, then wo's
    assert (features[:, 36:] != turned[:, 36:]).any(dim=1).all()
    sample_loss(model, at, 1.0).backward()
    assert all(p.grad is not None for p in model.triplane.parameters())


def test_feature_network_in_bfloat16_is_near_that_in_float32() -> None:
    model = model_of("surface", texture="network", width=128, channels=64 + ENCODED_DIRECTIONS)
    at, answers, gradients = samples(400), [], []
    for bfloat16 in (False, True):
        model.multiplies_in_bfloat16 = bfloat16
        answers.append(model(at))
        loss = sample_loss(model, at, 1.0)
        gradients.append(torch.autograd.grad(loss, [*model.triplane.parameters()]))
    assert not torch.equal(*answers)
    assert (answers[1] - answers[0]).norm() / answers[0].norm() < 0.01
    for exact, found in zip(*gradients, strict=True):
        assert found.dtype == torch.float32
        assert (found - exact).norm() / exact.norm() < 0.1


def test_uv_texture_is_bilinear_between_texel_centres() -> None:
    texture = UvTexture(4, 1, BOUNDS[0], BOUNDS[1])
    values = torch.arange(16.0).reshape(1, 1, 4, 4)
    texture.texels.data.copy_(values)
    uv = torch.tensor([[0.125, 0.125], [0.25, 0.125], [0.125, 0.25], [1.0, 1.0], [0.0, 0.0]])
    assert torch.allclose(texture(uv)[:, 0], torch.tensor([0.0, 0.5, 2.0, 15.0, 0.0]))


def test_uv_model_looks_up_uv_alone() -> None:
    model = model_of("surface", texture="uv", inputs=("features",))
    at = {**samples(8), "uv": torch.rand(8, 2)}
    moved = {**at, "position": torch.zeros(8, 3)}
    assert torch.equal(model(at), model(moved))
    assert not torch.equal(model(at), model({**at, "uv": 1.0 - at["uv"]}))

"""Decoder inputs in PyTorch against the runtime's plain twin."""

import numpy as np
import pytest
import torch

from rna_export.training.model.inputs import assemble, assembled
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.presets import PRESETS, ModelConfig
from rna_sdk.package import INPUT_BLOCKS, query_width
from rna_sdk.package.blocks import blocks_for
from tests.reference.queries import fiber_queries_reference, queries_reference
from tests.runtime.points import unit_vectors

BOUNDS = torch.tensor([[-1.0, 0.0, 2.0], [1.0, 3.0, 2.5]])


def make_model(inputs: tuple[str, ...]) -> NeuralAsset:
    torch.manual_seed(0)
    config = ModelConfig(inputs=inputs, width=8, hidden_layers=1, resolution=8, channels=4)
    model = NeuralAsset(config, BOUNDS)
    model.triplane.planes.data.normal_()
    return model


def random_rows(n: int = 397) -> dict[str, np.ndarray]:
    """Queries of both kinds; some at the mirror direction, some opposite to each other."""
    rng = np.random.default_rng(0)
    low, high = BOUNDS.numpy()
    position = low + (high - low) * rng.random((n, 3))
    normal, wo, wi = (unit_vectors(rng, n) for _ in range(3))
    wi[:50] = 2.0 * np.sum(wo[:50] * normal[:50], axis=1, keepdims=True) * normal[:50] - wo[:50]
    wi[50:60] = -wo[50:60]
    h = 2.2 * rng.random(n) - 1.1
    named = {"position": position, "normal": normal, "tangent": normal, "h": h, "wo": wo, "wi": wi}
    return {name: rows.astype(np.float32) for name, rows in named.items()}


@pytest.mark.parametrize(
    ("kind", "inputs"),
    [
        (kind, inputs)
        for kind in PRESETS
        for inputs in (
            *((block,) for block in blocks_for(kind)),
            tuple(blocks_for(kind)),
            *(preset.model.inputs for preset in PRESETS[kind].values()),
        )
    ],
)
def test_equals_the_reference(kind, inputs):
    model, at = make_model(inputs), random_rows()
    planes = model.triplane.planes.detach().numpy()
    reference = fiber_queries_reference if kind == "fiber" else queries_reference
    frame = ("tangent", "h") if kind == "fiber" else ("normal",)
    arguments = [at[name] for name in ("position", *frame, "wo", "wi")]
    expected = reference(planes, BOUNDS.numpy(), inputs, *arguments)
    actual = model.queries({k: torch.from_numpy(v) for k, v in at.items()}).detach().numpy()
    assert actual.shape == (len(expected), query_width(inputs, 4))
    # log2(1 - n.h + 1e-4) turns a rounding of n.h, 6e-8, into up to 2e-4 at the mirror direction.
    mirror = np.zeros(actual.shape, bool)
    mirror[:60] = "half_vector" in inputs or "highlight" in inputs
    if "learned_normal" in inputs:  # which mirrors light anywhere
        first = query_width(inputs[: inputs.index("learned_normal")], 4)
        mirror[:, first : first + INPUT_BLOCKS["learned_normal"]] = True
    assert np.abs(actual - expected)[~mirror].max(initial=0.0) < 1e-5
    assert np.abs(actual - expected).max() < 4e-4


@pytest.mark.parametrize("kind", PRESETS)
def test_gradients_are_those_of_the_twin(kind):
    blocks = tuple(blocks_for(kind))
    at = {name: torch.from_numpy(rows) for name, rows in random_rows().items()}
    generator = torch.Generator().manual_seed(1)
    features = torch.randn(len(at["wo"]), 4, generator=generator)
    p = torch.rand(len(features), 3, generator=generator)
    weights = torch.randn(len(features), query_width(blocks, 4), generator=generator)
    actual, expected = (
        torch.autograd.grad((function(blocks, x, p, at) * weights).sum(), x)[0]
        for function, x in ((f, features.clone().requires_grad_()) for f in (assemble, assembled))
    )
    # The twin's float32 loses 1 - q.h next to a highlight.
    assert torch.allclose(actual, expected, rtol=2e-3, atol=2e-3)


@pytest.mark.parametrize("kind", PRESETS)
def test_opposite_directions_give_finite_gradients(kind):
    model = make_model(tuple(blocks_for(kind)))
    at = {name: torch.from_numpy(rows) for name, rows in random_rows(20).items()}
    model.queries({**at, "wi": -at["wo"]}).square().sum().backward()
    assert torch.isfinite(model.triplane.planes.grad).all()

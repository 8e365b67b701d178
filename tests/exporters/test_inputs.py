"""Decoder inputs in PyTorch against the runtime's plain twin."""

from __future__ import annotations

import numpy as np
import pytest
import torch

from rna_export.training.model import NeuralAsset
from rna_export.training.presets import PRESETS, ModelConfig
from rna_sdk.package import INPUT_BLOCKS, query_width
from rna_sdk.package.blocks import blocks_for
from rna_sdk.runtime.queries_reference import fiber_queries_reference, queries_reference
from tests.render.assets import unit_vectors

BOUNDS = torch.tensor([[-1.0, 0.0, 2.0], [1.0, 3.0, 2.5]])
ALL_BLOCKS = tuple(INPUT_BLOCKS)


def make_model(inputs: tuple[str, ...]) -> NeuralAsset:
    torch.manual_seed(0)
    config = ModelConfig(inputs=inputs, width=8, hidden_layers=1, resolution=8, channels=4)
    model = NeuralAsset(config, BOUNDS)
    model.triplane.planes.data.normal_()
    return model


def random_rows(n: int = 400) -> dict[str, np.ndarray]:
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
def test_equals_the_reference(kind: str, inputs: tuple[str, ...]) -> None:
    model, at = make_model(inputs), random_rows()
    planes = model.triplane.planes.detach().numpy()
    reference = fiber_queries_reference if kind == "fiber" else queries_reference
    frame = ("tangent", "h") if kind == "fiber" else ("normal",)
    arguments = [at[name] for name in ("position", *frame, "wo", "wi")]
    expected = reference(planes, BOUNDS.numpy(), inputs, *arguments)
    found = model.queries({k: torch.from_numpy(v) for k, v in at.items()}).detach().numpy()
    assert found.shape == (len(expected), query_width(inputs, 4))
    # log2(1 - n.h + 1e-4) turns a rounding of n.h, 6e-8, into up to 2e-4 at the mirror direction.
    mirror = np.zeros(found.shape, bool)
    mirror[:60] = "half_vector" in inputs or "highlight" in inputs
    if "learned_normal" in inputs:  # which mirrors light anywhere
        first = query_width(inputs[: inputs.index("learned_normal")], 4)
        mirror[:, first : first + INPUT_BLOCKS["learned_normal"]] = True
    assert np.abs(found - expected)[~mirror].max(initial=0.0) < 1e-5
    assert np.abs(found - expected).max() < 4e-4


def test_opposite_directions_give_finite_gradients() -> None:
    model = make_model(ALL_BLOCKS)
    at = {name: torch.from_numpy(rows) for name, rows in random_rows(20).items()}
    directions = at["wo"].clone().requires_grad_()
    model.queries({**at, "wo": directions, "wi": -at["wo"]}).square().sum().backward()
    assert torch.isfinite(directions.grad).all()


def test_transport_inverts_the_log_and_stays_in_range() -> None:
    model = make_model(("features",))
    model.ceiling.fill_(7.0)
    model.unit.fill_(0.1)
    x = torch.tensor([0.0, 0.001, 1.0, 6.9])
    assert torch.allclose(model.colours(torch.log1p(x / 0.1)), x, atol=1e-5)
    assert model.colours(torch.tensor([-3.0, 50.0])).tolist() == pytest.approx([0.0, 7.0])


def test_separate_direct_light_is_added_where_it_is_seen() -> None:
    config = ModelConfig(
        inputs=("h",), width=8, hidden_layers=1, resolution=8, separates_direct=True
    )
    model = NeuralAsset(config, BOUNDS)
    x = torch.rand(5, 3, 3)
    transport = model.transport(torch.log1p(x))
    assert torch.allclose(transport[:, 0], x[:, 0] + x[:, 1], atol=1e-6)
    assert torch.allclose(transport[:, 1], x[:, 2], atol=1e-6)

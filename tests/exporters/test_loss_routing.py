"""The loss touches only the output that matches the sample's visibility."""

from __future__ import annotations

from pathlib import Path

import pytest
import torch

from rna_export.capture.dataset import SAMPLE_FIELDS
from rna_export.training.lightning_module import NeuralAssetTraining
from rna_export.training.presets import PRESETS
from tests.exporters.synthetic import tiny

ALL = [(kind, preset) for kind in PRESETS for preset in PRESETS[kind]]
BOUNDS = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])


def gradient_of_the_outputs(
    kind: str, preset: str, visible: float, monkeypatch
) -> tuple[float, float]:
    """Largest gradient at the last layer's rows of the visible outputs and of the shadowed one."""
    torch.manual_seed(0)
    fields = SAMPLE_FIELDS[kind]
    module = NeuralAssetTraining(tiny(preset, kind), BOUNDS, 1.0, 1.0, 100, fields, [], Path(), {})
    monkeypatch.setattr(module, "log", lambda *_, **__: None)
    monkeypatch.setattr(NeuralAssetTraining, "global_step", 0)
    rows = torch.rand(64, sum(fields.values()))
    rows[:, -1] = visible
    module.training_step(rows, 0).backward()
    gradient = module.model.decoder[-1].weight.grad.abs()
    return gradient[:-3].max().item(), gradient[-3:].max().item()


@pytest.mark.parametrize(("kind", "preset"), ALL)
def test_visible_samples_leave_the_shadowed_output_alone(
    kind: str, preset: str, monkeypatch
) -> None:
    lit, shadowed = gradient_of_the_outputs(kind, preset, 1.0, monkeypatch)
    assert lit > 0.0 and shadowed == 0.0


@pytest.mark.parametrize(("kind", "preset"), ALL)
def test_shadowed_samples_leave_the_visible_output_alone(
    kind: str, preset: str, monkeypatch
) -> None:
    lit, shadowed = gradient_of_the_outputs(kind, preset, 0.0, monkeypatch)
    assert lit == 0.0 and shadowed > 0.0

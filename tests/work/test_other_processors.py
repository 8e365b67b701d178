"""Captures by processors of other instructions: other bits, and the same radiance within noise."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.cli import main as capture
from rna_export.capture.dataset import Dataset
from rna_sdk.cpu import processor_key
from tests.exporters.scenes import write_scene

BALL = "add(*BALL, principled(Roughness=0.3, Subsurface_Weight=1.0))\n"
WITHOUT_AVX2 = """
import _cycles
bpy.app.debug_value = 256  # Cycles heeds its settings for tests
bpy.context.scene.cycles.debug_use_cpu_avx2 = False
_cycles.debug_flags_update(bpy.context.scene.as_pointer())
"""
SETTINGS = (
    "--lights 32 --rays 512 --samples 4 --validation-views 1 --validation-resolution 24 "
    "--validation-samples 4 --seed 3"
).split()


def radiance(folder: Path, name: str, body: str) -> np.ndarray:
    """(n, 3) float32 of a capture of the ball."""
    source, out = write_scene(folder, name, body), folder / f"{name}.rays"
    assert capture([str(source), "--out", str(out), *SETTINGS]) == 0
    dataset = Dataset(out)
    assert dataset.manifest.processors == (processor_key(),)
    return dataset.only.training_samples()["radiance"]


@pytest.mark.blender
def test_they_differ_within_noise(tmp_path: Path) -> None:
    usual = radiance(tmp_path, "usual", BALL)
    other = radiance(tmp_path, "other", BALL + WITHOUT_AVX2)
    assert usual.shape == other.shape
    assert (usual != other).any(), "the instructions were the same: nothing is tested"
    error = np.sqrt((usual.var(axis=0, ddof=1) + other.var(axis=0, ddof=1)) / len(usual))
    t = (usual.mean(axis=0) - other.mean(axis=0)) / error  # Welch's, of so many degrees normal
    assert np.abs(t).max() < 3.3  # one in a thousand
    assert (error < 0.05 * usual.mean()).all()

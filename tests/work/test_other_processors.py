"""Captures by processors of other instructions: other bits, and the same radiance within noise."""

from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.rna_capture import main as capture
from rna_sdk.machine.cpu import processor_key
from tests.exporters.scenes import write_scene

BALL = "add(*BALL, principled(Roughness=0.3, Subsurface_Weight=1.0))\n"
WITHOUT_AVX2 = "CYCLES_CPU_NO_AVX2"  # of the environment; Cycles heeds it
SETTINGS = (
    "--lights 32 --rays 512 --samples 4 --validation-views 1 --validation-resolution 24 "
    "--validation-samples 4 --seed 3"
).split()


def radiance(source: Path, out: Path) -> np.ndarray:
    """(n, 3) float32 of a capture."""
    assert capture([str(source), "--out", str(out), *SETTINGS]) == 0
    dataset = Dataset(out)
    assert dataset.manifest.processors == (processor_key(),)
    return dataset.only.training_samples()["radiance"]


@pytest.mark.blender
def test_they_differ_within_noise(tmp_path, monkeypatch):
    source = write_scene(tmp_path, "ball", BALL)
    usual = radiance(source, tmp_path / "usual.rays")
    monkeypatch.setenv(WITHOUT_AVX2, "1")
    other = radiance(source, tmp_path / "other.rays")
    assert usual.shape == other.shape
    assert (usual != other).any(), "the instructions were the same: nothing is tested"
    # Paths have the same random numbers, so rows are compared in pairs: highlights, of which few
    # rule the mean, are in both.
    difference = usual.astype(np.float64) - other
    error = difference.std(axis=0, ddof=1) / np.sqrt(len(difference))
    rounding = 1e-4 * usual.mean()
    # One in a thousand is beyond 3.3 standard errors.
    assert (np.abs(difference.mean(axis=0)) < 3.3 * error + rounding).all()
    assert (error < 10.0 * rounding).all()

"""Points on a mesh find their place in its atlas."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from rna_export.trials.grid import short_grid
from rna_export.trials.unwrap import Unwrapped, UnwrappedPart, check_unwrapping
from rna_sdk.errors import TrainingError
from tests.exporters.synthetic import make_dataset
from tests.render.assets import sphere

xatlas = pytest.importorskip("xatlas", reason="pip install xatlas")


def test_uv_are_those_of_the_triangle_that_the_point_is_on() -> None:
    mesh = sphere(2)
    rng = np.random.default_rng(0)
    triangle = rng.integers(len(mesh.triangles), size=200)
    weights = rng.dirichlet(np.full(3, 4.0), size=200).astype(np.float32)
    corners = mesh.positions[mesh.triangles[triangle]]
    position = np.einsum("nc,nck->nk", weights, corners)
    wo = (position / np.linalg.norm(position, axis=1, keepdims=True)).astype(np.float32)
    found = Unwrapped(mesh).uv(position, wo)
    _, triangles, uv = xatlas.parametrize(mesh.positions, mesh.triangles)
    expected = np.einsum("nc,nck->nk", weights, uv[triangles[triangle]])
    assert np.abs(found - expected).max() < 1e-4


def test_dataset_has_uv_in_samples_and_views(tmp_path: Path) -> None:
    dataset = UnwrappedPart(make_dataset(tmp_path / "ball.rays"))
    samples = dataset.training_samples()
    assert samples["uv"].shape == (len(samples["visible"]), 2)
    assert samples["uv"].min() >= 0.0 and samples["uv"].max() <= 1.0
    # The ball of the samples is round, its mesh is not: away from silhouettes, points find it.
    assert (samples["uv"] > 0.0).all(axis=1).mean() > 0.9
    assert "uv" in dataset.validation_views()[0].queries


def test_missing_library_is_told_before_anything_is_trained(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    trials = short_grid("surface")
    check_unwrapping(trials)
    monkeypatch.setitem(sys.modules, "xatlas", None)
    check_unwrapping([trial for trial in trials if trial.packageable])
    with pytest.raises(TrainingError, match="pip install xatlas"):
        check_unwrapping(trials)

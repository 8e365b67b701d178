"""Guided rays: more where a model errs, with weights that leave every mean as it was."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from rna_export.capture.asset_scene import AssetScene
from rna_export.capture.guide import UNIFORM, Guide, relative_errors, thinned
from rna_export.capture.sample_files import write_parts
from rna_export.capture.view_rays import sample_view_rays
from tests.exporters.synthetic import BALL_PART, make_dataset
from tests.render.assets import sphere, unit_vectors

WI = np.float32([0.6, 0.0, 0.8])


def test_thinning_keeps_a_known_integral() -> None:
    rng = np.random.default_rng(1)
    x = rng.random(200_000)
    kept, weight = thinned(0.05 + 0.9 * x**4, rng)
    assert len(np.unique(kept)) == len(kept) < 0.3 * len(x)
    integral = float(np.sum(weight * x[kept] ** 2) / len(x))
    assert integral == pytest.approx(1.0 / 3.0, rel=0.01)
    assert np.mean(x[kept] ** 2) > 0.5  # what it would be without the weights


def test_thinning_has_as_many_rows_as_the_probabilities_add_up_to() -> None:
    rng = np.random.default_rng(2)
    counts = [len(thinned(np.full(10, 0.25), rng)[0]) for _ in range(400)]
    assert set(counts) == {2, 3} and np.mean(counts) == pytest.approx(2.5, abs=0.1)


def lopsided() -> tuple[Guide, dict[str, np.ndarray], np.ndarray]:
    """A guide to a ball of which the half above y = 0 is learnt badly, and what it is made of."""
    rng = np.random.default_rng(3)
    n, wo, wi = (unit_vectors(rng, 60_000) for _ in range(3))
    visible = (np.sum(n * wi, axis=1) > 0.0).astype(np.uint8)
    at = {"position": n, "normal": n, "wo": wo, "wi": wi, "visible": visible}
    squared = np.where(n[:, 1] > 0.0, 0.09, 0.0001)
    return Guide((BALL_PART,), (relative_errors(BALL_PART, at, squared),)), at, squared


def test_errors_are_relative_to_their_mean_and_follow_the_position() -> None:
    guide, at, _ = lopsided()
    (errors,) = guide.errors
    again = relative_errors(BALL_PART, at, np.full(len(at["wi"]), 0.5))
    np.testing.assert_allclose(again, 1.0, rtol=1e-5)
    assert errors.max() > 1.5 and errors.min() < 0.5


def test_guided_rays_keep_a_known_mean() -> None:
    """The mean of x.y over the hits is the same with and without the guide; weights undo it."""
    guide, _, _ = lopsided()
    scene = AssetScene([sphere(3)])
    rng = np.random.default_rng(5)
    free = sample_view_rays(scene, WI, 40_000, "sphere", rng)
    rays, weight = guide.rays(scene, WI, 40_000, "sphere", rng)
    y_free = scene.shade_points(free.origins, free.directions).position[:, 1]
    y = scene.shade_points(rays.origins, rays.directions).position[:, 1]
    assert 0.25 <= weight.min() and weight.max() <= 1.0 / UNIFORM
    assert weight.dtype == np.float32
    assert weight.sum() / 40_000 == pytest.approx(1.0, abs=0.02)
    for f in (lambda v: v, lambda v: v > 0.0, lambda v: v**2):
        assert np.sum(weight * f(y)) / 40_000 == pytest.approx(np.mean(f(y_free)), abs=0.015)
    assert np.mean(y > 0.0) > np.mean(y_free > 0.0) + 0.15


def test_a_guide_is_read_as_it_was_written(tmp_path: Path) -> None:
    guide, _, _ = lopsided()
    guide.save(tmp_path / "guide.safetensors")
    read = Guide.load(tmp_path / "guide.safetensors", [BALL_PART])
    assert read.parts == guide.parts
    np.testing.assert_array_equal(read.errors[0], guide.errors[0])


def test_samples_without_a_weight_count_once(tmp_path: Path) -> None:
    part = make_dataset(tmp_path / "ball.rays", shards=2)
    assert "weight" not in part.training_samples()
    paths = part.dataset.finished_shards()
    samples = part.samples_of(paths[1:])
    weight = np.full(len(samples["visible"]), 0.5, np.float32)
    write_parts(paths[1], {"asset": {**samples, "weight": weight}})
    both = part.training_samples()["weight"]
    assert np.all(both[: -len(weight)] == 1.0) and np.all(both[-len(weight) :] == 0.5)

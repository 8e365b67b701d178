"""Lamps near the asset in captures, and the models that are told of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import torch

from rna_export.capture.blender_process.blender_worker import RenderedRays
from rna_export.capture.geometry.mesh_cleanup import clean_mesh
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.captured_light import (
    FARTHEST,
    NEAREST,
    Lamp,
    Sun,
    is_near,
    lamp_at,
    lamp_near,
)
from rna_export.capture.rays.traced_rays import TracedRays
from rna_export.capture.rays.view_rays import sample_view_rays
from rna_export.export.rna_export import main as export_main
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.loss_curves import Curves
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.rna_train import main as train_main
from tests.exporters.conftest import OpenWorker
from tests.exporters.meshes import ring, sphere
from tests.exporters.synthetic import tiny
from tests.exporters.test_tasks import make, run_all
from tests.render.assets import unit_vectors

WI = np.float32([0.36, 0.8, 0.48])


class LitBall:
    """Answers with the irradiance of a lamp at the point of a ball of radius 1, or 1 for a sun."""

    def __init__(self) -> None:
        self.brightest: list[float] = []

    def render_rays(
        self, origins, directions, wi, samples, seed, reach=None, normals=False, lamp=None
    ):
        along = -np.sum(origins * directions, axis=1)
        beside = 1.0 - np.sum(origins**2, axis=1) + along**2
        t = along - np.sqrt(np.maximum(beside, 0.0))
        x, irradiance = origins + t[:, None] * directions, np.ones(len(origins))
        if lamp is not None:
            position, intensity = lamp
            irradiance = intensity / np.sum((position - x) ** 2, axis=1)
            self.brightest.append(irradiance.max())
        radiance = np.repeat(irradiance[:, None], 3, axis=1).astype(np.float32)
        return RenderedRays(radiance, np.ones(len(origins), np.float32), x, None)


def test_a_lamp_is_at_its_place_and_a_sun_nowhere() -> None:
    x = unit_vectors(np.random.default_rng(0), 50)
    lamp = Lamp(np.float32([0.0, 3.0, 0.0]), size=2.0)
    reached = x + lamp.distances(x)[:, None] * lamp.directions(x)
    np.testing.assert_allclose(reached, np.tile(lamp.position, (50, 1)), atol=1e-5)
    np.testing.assert_allclose(lamp.inverse_distances(x) * lamp.distances(x), 2.0, rtol=1e-6)
    sun = Sun(WI)
    assert (sun.directions(x) == WI).all()
    assert np.isinf(sun.distances(x)).all() and not sun.inverse_distances(x).any()


@pytest.mark.parametrize("share", [0.0, 0.3, 0.5, 1.0])
def test_lamps_have_their_share_of_any_range_of_lights(share: float) -> None:
    near = np.array([is_near(k, share) for k in range(1000)])
    assert near.mean() == pytest.approx(share, abs=0.002)
    assert np.ptp([near[k : k + 20].sum() for k in range(0, 1000, 20)]) <= 1


def test_lamps_stay_outside_of_the_asset() -> None:
    ball, rng = AssetScene([sphere(4)]), np.random.default_rng(0)
    lamps = [lamp_near(ball, wi, rng) for wi in unit_vectors(rng, 200)]
    away = np.array([np.linalg.norm(lamp.position - ball.centre) for lamp in lamps]) / ball.size
    assert ball.size == pytest.approx(2.0, abs=0.01)
    assert away.min() > 0.5 and away.max() <= FARTHEST * 1.001
    assert np.mean(away < 2.0) > 0.4  # most are near
    hollow = [lamp_near(AssetScene([ring()]), WI, rng) for _ in range(50)]
    assert min(np.linalg.norm(lamp.position) for lamp in hollow) < 1.0 + NEAREST


def test_samples_are_of_irradiance_one_at_their_points(tmp_path: Path) -> None:
    dataset, teacher = make(tmp_path, sphere(5), near_lights=0.5, lights=6), LitBall()
    run_all(dataset, teacher)
    at = dataset.training_samples()
    near = at["inverse_distance"] > 0.0
    assert near.mean() == pytest.approx(0.5, abs=0.01)
    np.testing.assert_allclose(at["radiance"], 1.0, rtol=0.02)
    np.testing.assert_allclose(teacher.brightest, 1.0, rtol=0.02)  # so the clamps are a sun's
    assert len(np.unique(at["wi"][~near], axis=0)) == 3
    away = at["position"] + at["wi"] * (2.0 / at["inverse_distance"].clip(1e-9))[:, None]
    places = np.unique(np.round(away[near], 2), axis=0)
    assert len(places) < 200  # of three lamps, but for rounding, and not one a sample
    views = dataset.validation_views()
    assert [bool(v.samples["inverse_distance"].any()) for v in views] == [False, True] * 4


def test_only_what_is_before_a_lamp_shades() -> None:
    scene = AssetScene([ring()])
    point, inwards = np.float32([[0.9, 0.0, 0.0]]), np.float32([[-1.0, 0.0, 0.0]])
    points = scene.shade_points(np.zeros((1, 3), np.float32), -inwards)
    assert points.hit.all() and abs(points.position[0, 0] - point[0, 0]) < 0.2
    assert not scene.visible(points, inwards).any()
    assert scene.visible(points, inwards, np.float32([1.0])).all()


def test_a_model_is_told_how_near_the_light_is() -> None:
    preset = tiny().with_model(near_lights=True)
    model = NeuralAsset(preset.model, torch.tensor([[-1.0] * 3, [1.0] * 3]))
    rng = np.random.default_rng(0)
    at = {
        name: torch.from_numpy(unit_vectors(rng, 64)) for name in ("position", "normal", "wo", "wi")
    }
    far, near = (
        model.queries({**at, "inverse_distance": torch.full((64,), d)}) for d in (0.0, 2.0)
    )
    assert torch.equal(far[:, :-1], near[:, :-1])
    assert (far[:, -1] == 0.0).all() and torch.allclose(near[:, -1], torch.tensor(2.0 / 3.0))
    assert not preset.model.packageable


def test_a_training_with_lamps_has_the_input_and_no_package_takes_it(
    tmp_path, monkeypatch, capsys
) -> None:
    monkeypatch.setattr(Curves, "draw", lambda _: None)
    dataset = make(tmp_path / "ball.rays", sphere(4), near_lights=0.5, validation_resolution=32)
    run_all(dataset, LitBall())
    runs = tmp_path / "run"
    assert train_main([str(dataset.folder), "--steps", "10", "--out", str(runs)]) == 0
    assert "next:" not in capsys.readouterr().out
    assert load_checkpoint(runs / "best.ckpt").model.config.near_lights
    assert export_main([str(runs), "--out", str(tmp_path / "ball.rna")]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert "expected one that is captured without --near-lights" in line


@pytest.mark.blender
def test_cycles_lights_a_plane_as_a_lamp_does(open_worker: OpenWorker) -> None:
    worker = open_worker("add(*square(1), diffuse((0.9, 0.5, 0.1)))")
    scene = AssetScene([clean_mesh(worker.export_corners())])
    rng = np.random.default_rng(1)
    for light in (lamp_at(scene, WI, 0.4), lamp_at(scene, WI, 3.0), Sun(WI)):
        rays = sample_view_rays(scene, light, 1024, "sphere", rng)
        traced = TracedRays.of(scene, worker, rays, light, 1, 0, rng, False)
        cosine = light.directions(traced.points.position)[:, 1]
        above = traced.kept & (rays.directions[:, 1] < 0.0)
        assert above.sum() > 300
        expected = np.array([0.9, 0.5, 0.1]) / np.pi * cosine[above, None]
        assert np.abs(traced.radiance[above] - expected).max() < 1e-3

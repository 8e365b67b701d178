"""The case about energy: on a ball whose integral is known."""

import numpy as np
import pytest

from rna_bench.stability.answers import of_package
from rna_bench.stability.cases import energy
from rna_export.capture.rays.asset_scene import AssetScene
from tests.render.assets import LambertAsset, sphere


@pytest.mark.parametrize(("albedo", "passes"), [(1.0, True), (1.03, False)])
def test_the_integral_of_a_diffuse_ball_is_its_albedo(albedo, passes):
    asset = LambertAsset(sphere(3), albedo=(albedo, 0.5, 0.2))
    scene = AssetScene([asset.mesh])
    rows = energy.furnace(of_package(asset), scene, 100)
    assert len(rows) == 100
    total = np.array([row["integral"] for row in rows])
    np.testing.assert_allclose(total, albedo, atol=0.005)
    of_ball = {"asset": "ball", "albedo": None}
    rows = [{**of_ball, **row, "integral": row["integral"] - 0.01} for row in rows]
    assert energy.judge(rows).passed == passes


@pytest.mark.parametrize(("albedo", "passes"), [(0.98, True), (0.96, False), (0.33, False)])
def test_light_that_is_missing_fails(albedo, passes):
    verdict = energy.judge([{"asset": "ball", "albedo": albedo, "integral": 0.9}])
    assert verdict.passed == passes and f"{albedo:.1%} of Cycles'" in verdict.found


def test_visibility_may_have_a_colour(monkeypatch):
    asset = LambertAsset(sphere(3), albedo=(0.8, 0.5, 0.2))
    scene = AssetScene([asset.mesh])
    expected = energy.furnace(of_package(asset), scene, 20)
    visible = scene.visible
    monkeypatch.setattr(
        scene, "visible", lambda *rays: np.repeat(np.float32(visible(*rays))[:, None], 3, axis=1)
    )
    assert expected and energy.furnace(of_package(asset), scene, 20) == expected

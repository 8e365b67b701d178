"""Cases about numbers and energy."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from rna_bench.stability.answers import of_package
from rna_bench.stability.cases import energy, numbers
from rna_export.capture.rays.asset_scene import AssetScene
from rna_sdk.runtime import load
from tests.package.builders import make_tier, make_tiny_package
from tests.render.assets import LambertAsset, sphere, unit_vectors


def queries(count: int = 200) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(1)
    place = rng.uniform(-0.9, 0.9, (count, 3)).astype(np.float32)
    names = ("normal", "wo", "wi")
    return {"position": place} | {name: unit_vectors(rng, count) for name in names}


def test_a_package_bears_odd_numbers(tmp_path: Path) -> None:
    make_tiny_package(tmp_path / "tiny.rna")
    answers = of_package(load(tmp_path / "tiny.rna", threads=1))
    assert numbers.judge(numbers.odd_inputs(answers, queries())).passed
    bare = numbers.judge(numbers.odd_inputs(lambda q: (q["wo"] + q["wi"],) * 2, queries()))
    assert not bare.passed and "nan" in bare.found


@pytest.mark.parametrize("planes", ["float16", "int8"])
def test_the_decoder_in_double_precision_agrees(planes: str, tmp_path: Path) -> None:
    make_tiny_package(tmp_path / "tiny.rna", make_tier(plane_precision=planes))
    asset, asked = load(tmp_path / "tiny.rna", threads=1), queries()
    exact = numbers.in_float64(tmp_path / "tiny.rna", asset, asked)
    assert exact[0].dtype == np.float64
    found = of_package(asset)(asked)
    assert numbers.judge([numbers.checked("float64", found, exact)]).passed
    off = [1.01 * values for values in found]
    assert not numbers.judge([numbers.checked("float64", off, exact)]).passed


@pytest.mark.parametrize(("albedo", "passes"), [(1.0, True), (1.03, False)])
def test_the_integral_of_a_diffuse_ball_is_its_albedo(albedo: float, passes: bool) -> None:
    asset = LambertAsset(sphere(3), albedo=(albedo, 0.5, 0.2))
    scene = AssetScene([asset.mesh])
    rows = energy.furnace(of_package(asset), scene, 100)
    assert len(rows) == 100
    total = np.array([row["integral"] for row in rows])
    np.testing.assert_allclose(total, albedo, atol=0.005)
    rows = [{"asset": "ball", **row, "integral": row["integral"] - 0.01} for row in rows]
    assert energy.judge(rows).passed == passes


def test_visibility_may_have_a_colour(monkeypatch: pytest.MonkeyPatch) -> None:
    asset = LambertAsset(sphere(3), albedo=(0.8, 0.5, 0.2))
    scene = AssetScene([asset.mesh])
    expected = energy.furnace(of_package(asset), scene, 20)
    visible = scene.visible
    monkeypatch.setattr(
        scene, "visible", lambda *rays: np.repeat(np.float32(visible(*rays))[:, None], 3, axis=1)
    )
    assert expected and energy.furnace(of_package(asset), scene, 20) == expected

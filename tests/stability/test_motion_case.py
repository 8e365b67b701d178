"""The case of shapes that bend: what is seen, how it has moved, what is judged."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from rna_bench.one_part import load_one_part
from rna_bench.stability import moved_references
from rna_bench.stability.cases import motion
from rna_bench.stability.fixtures import ASSETS, Fixtures, Subject
from rna_bench.stability.moved_asset import MovedAsset, joined
from rna_bench.stability.moved_references import Views, references
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.geometry.mesh_cleanup import clean_mesh
from rna_sdk.package import Curves, Tier, write_package
from rna_sdk.runtime import SurfaceAsset, load
from rna_trace import part_geometry
from tests.conftest import REPOSITORY
from tests.package.builders import make_manifest, make_part_data, make_tier_part

TURN = np.float32([[0, 0, 1], [0, 1, 0], [-1, 0, 0]])  # a quarter, about +y


@pytest.fixture(scope="module")
def toy() -> SurfaceAsset:
    asset = load(REPOSITORY / "examples" / "quickstart" / "toy.rna", threads=1)
    assert isinstance(asset, SurfaceAsset)
    return asset


@pytest.mark.parametrize("path", ["quickstart/toy.rna", "fibers/curly_ball.rna"])
def test_a_turned_asset_looks_as_it_does_at_rest(path: str) -> None:
    """All turned: shape, rays and light."""
    asset = load_one_part(REPOSITORY / "examples" / path, threads=1)
    geometry = part_geometry(asset)
    positions = geometry.points if isinstance(geometry, Curves) else geometry.positions
    rest, turned = MovedAsset(asset, positions), MovedAsset(asset, positions @ TURN.T)
    views = Views.around([positions])
    origins, directions = (rays[::23] for rays in views.rays(0))
    before = rest.see(origins, directions, views.wi[0])
    light = np.float32(TURN @ views.wi[0])
    after = turned.see(origins @ TURN.T, directions @ TURN.T, light)
    assert np.isin(before.ray, after.ray).mean() > 0.97 and len(before.ray) > 50
    np.testing.assert_allclose(turned.turned_deg(), 90.0, atol=0.5)
    np.testing.assert_allclose(turned.stretch(), 1.0, atol=2e-3)
    assert rest.turned_deg().max() < 0.1
    error = np.abs(before.radiance.mean(axis=0) - after.radiance.mean(axis=0))
    assert (error < 0.02 * before.radiance.mean()).all()


def test_assets_are_measured_by_choice(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    row = {"where": "moved", "angle_deg": motion.AT_DEG, "error": 3.0, "at_rest": 2.0}
    monkeypatch.setattr(motion, "rows_of", lambda _, name: [{"asset": name, **row}])
    (row,) = motion.measure(Fixtures(tmp_path, Subject(), 10, 1, moving=("tail",)))
    assert row["asset"] == "tail"
    assert motion.judge([row]).found.endswith("tail 1.50; figure not measured; slab not measured")


def test_stretch_counts_longer_and_shorter(toy: SurfaceAsset) -> None:
    wide = MovedAsset(toy, toy.mesh.positions * np.float32([1.0, 1.5, 1.0]))
    flat = MovedAsset(toy, toy.mesh.positions * np.float32([1.0, 0.5, 1.0]))
    assert wide.stretch().max() == pytest.approx(1.5, rel=1e-3)
    assert flat.stretch().max() == pytest.approx(2.0, rel=1e-3)


def test_rays_of_images_are_numbered_on(toy: SurfaceAsset) -> None:
    asset, views = MovedAsset(toy, toy.mesh.positions), Views.around([toy.mesh.positions])
    seen = [asset.see(*views.rays(k), views.wi[k]) for k in (0, 1)]
    both = joined(seen, [views.pixels] * 2)
    assert (both.ray[: len(seen[0].ray)] == seen[0].ray).all()
    assert (both.ray[len(seen[0].ray) :] == seen[1].ray + views.pixels).all()


@pytest.mark.parametrize(("error", "passes"), [(0.124, True), (0.126, False)])
def test_the_moved_part_is_judged_at_thirty_degrees(error: float, passes: bool) -> None:
    errors = {10.0: 0.11, 30.0: error, 60.0: 0.4}
    rows = [
        {"asset": "slab", "where": "moved", "angle_deg": a, "error": e, "at_rest": 0.1}
        for a, e in errors.items()
    ]
    flag = {"asset": "flag", "where": "moved", "angle_deg": 30.0, "error": 9.0, "at_rest": 1.0}
    verdict = motion.judge([*rows, flag])
    assert verdict.passed == passes
    assert "slab 1.10, " in verdict.found and "flag 9.00" in verdict.found


@pytest.mark.blender
def test_cycles_and_we_see_the_same_bent_slab(
    tmp_path: Path, blender_python: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With any decoder: shapes agree at the silhouette, and the ends turn by half of the angle."""
    monkeypatch.setattr(moved_references, "VIEWS", 3)
    monkeypatch.setattr(moved_references, "SIDE", 48)
    source = Source(ASSETS / "motion" / "slab.py")
    with BlenderWorker(blender_python, source, tmp_path / "worker", 1) as worker:
        mesh = clean_mesh(worker.export_corners())
    part = make_tier_part("skin")
    tier = Tier(name="small", parts=(part,))
    path = tmp_path / "slab.rna"
    write_package(path, make_manifest(tier), [mesh], {"small": [make_part_data(part)]})
    package = load(path, threads=1)
    assert isinstance(package, SurfaceAsset)
    fixtures = Fixtures(tmp_path, Subject(), 10, 1, short=True)
    found = references(fixtures, "slab", source.path, package, [1, 61])
    views = Views.around([found["1-positions"], found["61-positions"]])
    for frame in (1, 61):
        asset = MovedAsset(package, found[f"{frame}-positions"])
        hit = np.zeros((3, views.pixels), bool)
        for k in range(3):
            hit[k, asset.see(*views.rays(k), views.wi[k]).ray] = True
        assert (hit.reshape(-1) == (found[f"{frame}-alpha"] > 0.5)).mean() > 0.995
    rest, bent = (motion.shade(package, views, found, frame) for frame in (1, 61))
    assert 28.0 < bent.asset.turned_deg().max() < 32.0
    rows = motion.by_angle(rest, bent, 60.0)
    assert {"moved", "whole"} <= {row["where"] for row in rows}
    assert all(np.isfinite(row["error"]) for row in rows if row["where"] != "touching")

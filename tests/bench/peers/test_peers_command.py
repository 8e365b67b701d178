"""`rna-bench peers` and `peers-data`, at their smallest; NRHints' networks on known geometry."""

import ast
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch

from rna_bench.checkout import TOY
from rna_bench.cli import main
from rna_bench.peers import our_package, peers_command, study
from rna_bench.peers.analytic_known import KnownMaterial
from rna_bench.peers.known_geometry import KnownGeometry
from rna_bench.peers.method import Budget
from rna_bench.peers.methods import METHODS, Setting
from rna_bench.peers.nrhints import nrhints
from rna_bench.peers.nrhints.nrhints_known import KnownNRHints
from rna_bench.peers.scoring import HeldOut
from rna_bench.peers.sphere import lambert_sphere
from rna_bench.peers.sphere.lambert_sphere import sphere_views
from rna_sdk.errors import TrainingError
from rna_sdk.runtime import load


@pytest.fixture(scope="module")
def toy_views():
    """Cameras around the toy, whose images are black."""
    positions = load(TOY, threads=1).parts[0].mesh.positions
    centre = (positions.min(axis=0) + positions.max(axis=0)) / 2
    radius = float(np.linalg.norm(positions - centre, axis=1).max())
    return replace(sphere_views(2, 16), centre=tuple(centre.tolist()), radius=radius)


def test_known_geometry_is_that_of_the_package(toy_views):
    batch = toy_views.batch(np.arange(2 * 256))
    actual = KnownGeometry(TOY, toy_views).hits(batch.origins, batch.directions, batch.lights)
    assert 60 < len(actual.row) < 512 and np.linalg.norm(actual.points, axis=1).max() <= 1.0
    way = actual.points - batch.origins[actual.row]
    along = (way * batch.directions[actual.row]).sum(axis=1)
    np.testing.assert_allclose(np.linalg.norm(way, axis=1), along, rtol=1e-5)
    facing = (actual.normals * (batch.lights[actual.row] - actual.points)).sum(axis=1)
    assert set(np.unique(actual.visible)) == {0.0, 1.0} and actual.visible[facing < -0.5].max() == 0


def test_a_network_on_known_geometry_learns_a_colour(toy_views, tmp_path, monkeypatch):
    monkeypatch.setattr(nrhints, "WARM_UP", 10)
    rgba = np.ones_like(toy_views.rgba) * np.float32([0.6, 0.2, 0.1, 1.0])
    views = replace(toy_views, rgba=rgba)
    torch.manual_seed(0)
    method = KnownNRHints(Setting(geometry=KnownGeometry(TOY, views)))
    done = method.train(views, Budget(1e9, 1e9, steps=30), tmp_path)
    assert done.curve[-1].loss < 0.8 * done.curve[0].loss
    image = method.render(views.camera(0), views.lights[0])
    assert image.shape == (16, 16, 3) and image[0, 0].max() == 0.0 < image[8, 8, 0]
    with pytest.raises(TrainingError, match="needs --package"):
        METHODS["nrhints-known"].make(Setting())


def test_an_analytic_material_on_known_geometry_learns_one(toy_views, tmp_path):
    geometry = KnownGeometry(TOY, toy_views)
    batch = toy_views.batch(np.arange(toy_views.pixels))
    hits = geometry.hits(batch.origins, batch.directions, batch.lights)
    way = batch.lights[hits.row] - hits.points
    cosine = (way * hits.normals).sum(axis=1).clip(0.0) / np.linalg.norm(way, axis=1)
    lit = toy_views.intensity * cosine * hits.visible / (way**2).sum(axis=1)
    rgba = np.zeros_like(toy_views.rgba)
    albedo = np.array([0.8, 0.3, 0.1])
    rgba.reshape(-1, 4)[hits.row, :3] = albedo / np.pi * lit[:, None]
    rgba.reshape(-1, 4)[hits.row, 3] = 1.0
    method = KnownMaterial(Setting(geometry=geometry))
    views = replace(toy_views, rgba=rgba)
    done = method.train(views, Budget(1e9, 1e9, steps=80), tmp_path)
    assert done.curve[-1].loss < 0.35 * done.curve[0].loss
    assert method.model.intensity == pytest.approx(toy_views.intensity)
    assert hits.tangents.max() == 0.0


def test_a_tiny_run_is_measured_and_resumed(tmp_path, monkeypatch, capsys):
    command = ["peers", "sphere", "--methods", "nrhints", "--steps", "2", "--held-out", "1"]
    command += ["--size", "8", "--out", str(tmp_path)]
    monkeypatch.setattr(study, "PARTS", (0.5, 1.0))
    monkeypatch.setattr(peers_command, "_SPHERE_VIEWS", 2)
    monkeypatch.setattr(peers_command, "_SPHERE_SIZE", 16)
    assert main(command) == 0
    report = json.loads((tmp_path / "peers.json").read_text())
    (row,) = report["methods"]
    assert [point["steps"] for point in row["points"]] == [1, 2]
    last = row["points"][-1]
    assert last["share_of_schedule"] == pytest.approx(2 * 32 / (512 * 1e6))
    assert set(last["scores"]) == {"val", "val_collocated"} and last["frame_cpu_seconds"] > 0.0
    assert "e-05% of the schedule" in (tmp_path / "curves.svg").read_text()
    assert {path.name for path in tmp_path.glob("sheet-*.png")} == {
        "sheet-comparison.png",
        "sheet-geometry.png",
    }
    made = {path: path.stat().st_mtime_ns for path in (tmp_path / "nrhints-0").iterdir()}
    assert main(command) == 0
    assert json.loads((tmp_path / "peers.json").read_text())["methods"] == [row]
    assert {p.name for p, at in made.items() if p.stat().st_mtime_ns != at} <= {"settings.json"}
    assert len(made) > 4
    capsys.readouterr()
    assert main([*command, "--size", "4"]) == 1
    assert "size 8, now 4): choose another --out, or --again" in capsys.readouterr().err


def test_several_packages_of_ours_are_told_apart(toy_views, tmp_path, monkeypatch):
    black = [np.zeros((16, 16, 3), np.float32)] * len(toy_views)
    monkeypatch.setattr(our_package, "render_package", lambda *_: (black, 0.5))
    plan = study.Plan(toy_views, None, {"val": HeldOut.of(toy_views)}, 1.0)
    other = tmp_path / "short.rna"
    other.symlink_to(TOY)
    tiers = our_package.tiers_of(TOY)
    rows = our_package.measured([TOY, other], plan, 1)
    expected = [f"ours, {name}, {tier}" for name in ("toy", "short") for tier in tiers]
    assert [row["title"] for row in rows] == expected
    assert our_package.measured([TOY], plan, 1)[0]["title"] == f"ours, {tiers[0]}"


def test_the_sphere_as_an_asset_is_that_of_the_closed_form():
    text = (Path(lambert_sphere.__file__).parent / "sphere_asset.py").read_text()
    made = [node for node in ast.parse(text).body if isinstance(node, ast.Assign)]
    values = {ast.unparse(node.targets[0]): ast.unparse(node.value) for node in made}
    place, radius, albedo = (
        ast.literal_eval(values[name]) for name in ("(X, Y, Z)", "RADIUS", "ALBEDO")
    )
    np.testing.assert_array_equal(place, lambert_sphere.CENTRE)
    assert radius == lambert_sphere.RADIUS
    np.testing.assert_array_equal(albedo, lambert_sphere.ALBEDO)


def test_bad_input_is_one_line(tmp_path, capsys):
    assert main(["peers", str(tmp_path), "--out", str(tmp_path / "out")]) == 1
    error = capsys.readouterr().err
    assert error.count("\n") == 1 and "transforms_train.json: cannot read it" in error
    assert main(["peers-data", "no.py", "--out", str(tmp_path / "views")]) == 1
    assert capsys.readouterr().err == "error: no.py: no such file\n"

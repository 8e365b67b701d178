"""Lobes of the transport: densities, training, errors, and the commands that add them."""

from argparse import Namespace

import numpy as np
import pytest
import torch

from rna_export.environment import environment_training
from rna_export.environment.directions import even_directions, random_rotations
from rna_export.environment.environment_options import lobe_minutes
from rna_export.environment.environment_training import add_lobes
from rna_export.environment.lobe_error import generated_environments, lobe_errors
from rna_export.environment.lobe_export import exported_lobes
from rna_export.environment.lobe_fit import fit_lobes, light_weights, lobe_loss, make_rows
from rna_export.environment.lobe_model import LOBES, LobeModel, densities
from rna_export.environment.lobe_queries import LobeInputs, QueryRows
from rna_export.environment.spherical_harmonics import harmonics
from rna_export.environment.view_points import part_views
from rna_export.export.rna_export import main
from rna_export.training.optimization.pace import StepPace
from rna_render import write_exr
from rna_sdk.package import Package, Unpacked, validate
from rna_sdk.package.manifest.extensions import HARMONICS, Environment, extension
from rna_sdk.runtime import load
from tests.conftest import REPOSITORY

HEAD = REPOSITORY / "spec/conformance/packages/parts-head.rna"
TOY = "examples/quickstart/toy.rna"


@pytest.fixture(scope="module")
def asset():
    return load(TOY, threads=1)


@pytest.fixture(scope="module")
def views(asset):
    (views,) = part_views(asset)
    return views


@pytest.fixture(scope="module")
def queries(asset):
    with Package.open(TOY) as package:
        return QueryRows(package, asset.tier.name, 0, HARMONICS)


@pytest.fixture
def model(queries):
    torch.manual_seed(0)
    return LobeModel(queries.columns, 64, 2)


def test_harmonics_are_orthonormal():
    d = even_directions(20_000)
    products = harmonics(d).T @ harmonics(d) * (4 * np.pi / len(d))
    assert np.abs(products - np.eye(HARMONICS)).max() < 2e-3


def test_densities_sum_up_to_one():
    axis = torch.tensor([[[0.001, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 20.0, 30.0]]])
    d = even_directions(50_000)
    found = densities(axis, torch.from_numpy(d.T)[None]).numpy()
    assert found.sum(axis=2) * 4 * np.pi / len(d) == pytest.approx(np.ones((1, 3)), rel=1e-3)


def test_rotations_keep_lengths_and_handedness():
    r = random_rotations(50, np.random.default_rng(0))
    assert r @ r.transpose(0, 2, 1) == pytest.approx(np.tile(np.eye(3), (50, 1, 1)), abs=1e-6)
    assert np.linalg.det(r) == pytest.approx(1.0, abs=1e-5)


def test_each_light_has_all_of_its_weight():
    assert light_weights().sum(dim=1).numpy() == pytest.approx(1.0, abs=1e-6)


def test_lobes_that_are_the_truth_have_no_loss(views, queries, model):
    *inputs, directions, transport = make_rows(views, queries, 32, np.random.default_rng(0))
    with torch.no_grad():
        amplitude, axis = model(LobeInputs(*inputs))
        truth = amplitude.transpose(1, 2) @ densities(axis, torch.from_numpy(directions))
    assert lobe_loss(model, [*inputs, directions, truth.numpy()], light_weights()) < 1e-10
    assert lobe_loss(model, [*inputs, directions, transport], light_weights()) > 1e-3


def test_training_comes_nearer_to_the_whole_integral(views, queries, model):
    even = {"even": generated_environments()["generated-sky"]}
    pairs = [(views, model.answering(queries))]
    (before,) = lobe_errors(pairs, even, size=10)
    assert fit_lobes(model, views, queries, [StepPace(120)]) == 120
    (after,) = lobe_errors(pairs, even, size=10)
    assert after.psnr > before.psnr + 3.0
    assert after.flip < before.flip
    assert after.brightness == pytest.approx((1.0, 1.0, 1.0), abs=0.3)


def test_a_package_answers_as_the_trained_lobes(views, queries, model, tmp_path):
    lobes = exported_lobes(model, views, queries, "small")
    assert lobes.agreement.max_absolute < 1e-3
    Unpacked.read(TOY).with_environment([lobes]).write(tmp_path / "lit.rna")
    part = load(tmp_path / "lit.rna")
    points = views.points(300, np.random.default_rng(2))
    found = part.lobes(points.position, points.axis, points.wo, points.free, points.visibility)
    for ours, trained in zip(found, model.answering(queries)(points), strict=True):
        assert ours == pytest.approx(trained, rel=1e-3, abs=1e-3)
    assert part.mirror(points.axis, points.wo) == pytest.approx(points.mirror, abs=1e-6)


def test_the_command_adds_lobes_to_a_package(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(environment_training, "SIZE", 6)
    out, forest = tmp_path / "lit.rna", tmp_path / "my forest.exr"
    write_exr(forest, dict.fromkeys("RGB", np.full((8, 16), 0.5, np.float32)), {})
    options = ["--environment", "--environment-minutes", "0.02", "--environment-files", forest]
    assert main([str(word) for word in (HEAD, "--out", out, *options)]) == 0
    assert validate(out) == []
    with Package.open(HEAD) as before, Package.open(out) as package:
        kinds = [part.kind for part in package.manifest.parts]
        data = extension(package.manifest, Environment)
        own = [lobes.record for lobes in map(package.environment, range(len(kinds)))]
        assert before.manifest.entries.items() < package.manifest.entries.items()
        assert before.manifest.tiers == package.manifest.tiers
    assert sorted(kinds) == ["fiber", "surface"]
    for kind, record, planes in zip(kinds, own, package.manifest.tiers[0].parts, strict=True):
        assert (record.lobes, record.planes, record.inputs) == (LOBES, planes.planes, planes.inputs)
        assert (record.visibility is None) == (kind == "fiber")
    names = [one.environment for one in data.validation]
    assert names == ["generated-sky", "generated-studio", "my-forest"]
    said = capsys.readouterr().out
    assert all(f"environment {name}: PSNR " in said for name in names)
    assert said.count(" of 3,000 steps, ") == 2
    assert "warning: the first look by lobes is rough: " in said


def test_a_stopped_training_leaves_no_file(tmp_path, monkeypatch):
    def stopped(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    package = tmp_path / "head.rna"
    package.write_bytes(HEAD.read_bytes())
    monkeypatch.setattr(environment_training, "fit_lobes", stopped)
    with pytest.raises(KeyboardInterrupt):
        add_lobes(package, package, 1.0, ())
    assert [path.name for path in tmp_path.iterdir()] == ["head.rna"]
    assert package.read_bytes() == HEAD.read_bytes()


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ([], "or one package with --environment"),
        (["--environment", "--environment-minutes", "0"], "expected a number above 0"),
        (["--environment-files", "a.hdr"], "expected --environment, too"),
        (["--environment", "--proxies", "32"], "argument --proxies: expected checkpoints"),
    ],
)
def test_options_that_do_not_belong_together(given, told, tmp_path, capsys):
    with pytest.raises(SystemExit):
        main([str(HEAD), "--out", str(tmp_path / "a.rna"), *given])
    assert told in capsys.readouterr().err


def test_the_last_quarter_of_a_make_is_for_lobes():
    def minutes(**given: object) -> float:
        usual = {"environment": True, "environment_minutes": 5.0, "minutes": None}
        return lobe_minutes(Namespace(**(usual | given)))

    assert [minutes(), minutes(minutes=8.0), minutes(minutes=60.0)] == [5.0, 2.0, 5.0]
    assert minutes(environment=False) == 0.0

"""Lobes of the transport: densities, training, errors, and the commands that add them."""

from argparse import Namespace

import numpy as np
import pytest
import torch

from rna_export.export.package_options import lobe_minutes
from rna_export.export.rna_export import main
from rna_export.lobes import environment_training, lobe_fit
from rna_export.lobes.directions import even_directions, harmonics, random_rotations
from rna_export.lobes.environment_training import add_lobes
from rna_export.lobes.lobe_error import LobePictures, generated_environments, lobe_pictures
from rna_export.lobes.lobe_fit import exported_lobes, fit_lobes, make_rows
from rna_export.lobes.lobe_loss import EPSILON, LobeLoss, Targets, even_lights
from rna_export.lobes.lobe_model import LOBES, LobeModel, densities
from rna_export.lobes.lobe_queries import LobeInputs, QueryRows
from rna_export.lobes.view_points import Grid, part_views
from rna_export.training.optimization.muon import Muon
from rna_export.training.optimization.pace import StepPace
from rna_render import write_exr
from rna_sdk.package import Package, Unpacked, validate
from rna_sdk.package.manifest.extensions import HARMONICS, Environment, extension
from rna_sdk.runtime import load
from tests.conftest import REPOSITORY

HEAD = REPOSITORY / "spec/conformance/packages/parts-head.rna"
HAIR = REPOSITORY / "spec/conformance/packages/fiber-int8.rna"
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
    actual = densities(axis, torch.from_numpy(d.T)[None]).numpy()
    assert actual.sum(axis=2) * 4 * np.pi / len(d) == pytest.approx(np.ones((1, 3)), rel=1e-3)


def test_rotations_keep_lengths_and_handedness():
    r = random_rotations(50, np.random.default_rng(0))
    assert r @ r.transpose(0, 2, 1) == pytest.approx(np.tile(np.eye(3), (50, 1, 1)), abs=1e-6)
    assert np.linalg.det(r) == pytest.approx(1.0, abs=1e-5)


def test_the_loss_of_the_narrowest_lobes_is_finite():
    d = np.tile(even_directions(64).T, (4, 1, 1))
    of_four = np.ones((4, 64), np.float32), random_rotations(4, np.random.default_rng(0))
    for kappa in (0.0, 1e-3, 50.0, 1e3):
        lobes = torch.ones(4, 8, 3), torch.full((4, 8, 3), kappa)
        for x in lobes:
            x.requires_grad_()
        loss = LobeLoss.apply(*lobes, np.arange(4), Targets(d, d, *of_four), even_lights())
        loss.backward()
        assert all(bool(torch.isfinite(x).all()) for x in (loss, lobes[0].grad, lobes[1].grad))


@pytest.fixture(scope="module")
def rows(views, queries):
    return make_rows(views, queries, 32, np.random.default_rng(0))


def plain_loss(model, rows):
    """What `LobeLoss` is, by PyTorch's autograd, of all rows in order; and its gradient."""
    inputs, targets = LobeInputs(*rows[:4]), Targets(*rows[4:])
    d, transport, share, rotation = map(torch.from_numpy, targets)
    light = torch.einsum("nij,lj->nli", rotation, torch.from_numpy(even_lights()))
    weight = share[:, None] * torch.exp(light @ d - light.norm(dim=2, keepdim=True))
    weight = (weight / weight.sum(dim=2, keepdim=True)).transpose(1, 2)
    amplitude, axis = model(inputs)
    answer = amplitude.transpose(1, 2) @ densities(axis, d)
    scale = (answer.detach() @ weight).clamp_min(0.0) + EPSILON
    return ((((answer - transport) @ weight) / scale) ** 2).mean()


def test_the_compiled_loss_and_its_gradient_are_those_of_autograd(model, rows):
    ours = LobeLoss.apply(
        *model(LobeInputs(*rows[:4])), np.arange(32), Targets(*rows[4:]), even_lights()
    )
    theirs = plain_loss(model, rows)
    assert ours.item() == pytest.approx(theirs.item(), rel=1e-4)
    actual = torch.autograd.grad(ours, list(model.parameters()))
    expected = torch.autograd.grad(theirs, list(model.parameters()))
    for one, other in zip(actual, expected, strict=True):
        assert one.numpy() == pytest.approx(other.numpy(), abs=1e-3 * float(other.abs().max()))


def test_lobes_that_are_the_truth_have_no_loss(model, rows):
    inputs, targets = LobeInputs(*rows[:4]), Targets(*rows[4:])
    with torch.no_grad():
        lobes = model(inputs)
        truth = lobes[0].transpose(1, 2) @ densities(lobes[1], torch.from_numpy(targets.directions))
    exact = targets._replace(transport=truth.numpy())
    assert LobeLoss.apply(*lobes, np.arange(32), exact, even_lights()) < 1e-10
    assert LobeLoss.apply(*lobes, np.arange(32), targets, even_lights()) > 1e-3


def test_shares_of_directions_add_up_to_the_sphere(rows):
    (strands,) = part_views(load(HAIR, threads=1))
    with Package.open(HAIR) as package:
        queries = QueryRows(package, package.manifest.tiers[0].name, 0, 0)
    for made in (rows, make_rows(strands, queries, 32, np.random.default_rng(0))):
        d, share = made[4], made[6]
        assert share.sum(axis=1) == pytest.approx(np.full(32, 4 * np.pi), rel=0.1)
        moments = np.einsum("nik,njk,nk->ij", d, d, share) / 32
        assert moments == pytest.approx(4 * np.pi / 3 * np.eye(3), abs=0.1)


def test_a_pixel_is_the_mean_of_its_points():
    x, y, pixel = Grid(2, rays=2, finest=8).places()
    assert x[:4] == pytest.approx([-0.5625, -0.4375, 0.4375, 0.5625])
    assert y[::4] == pytest.approx([-0.5625, -0.4375, 0.4375, 0.5625])
    assert pixel.reshape(4, 4).tolist() == [[0, 0, 1, 1]] * 2 + [[2, 2, 3, 3]] * 2
    truth = np.arange(8.0).repeat(3).reshape(1, 8, 3)
    points = LobePictures(["sky"], 2, np.array([3, 0, 0, 3, 1, 0, 3, 3]), truth, truth, truth + 1)
    pixels = points.of_pixels()
    assert pixels.pixel.tolist() == [0, 1, 3]
    assert pixels.truth[0, :, 0] == pytest.approx([8 / 3, 4.0, 4.0])
    assert pixels.both == pytest.approx(pixels.truth + 1)


def test_training_comes_nearer_to_the_whole_integral(views, queries, model):
    even = {"even": generated_environments()["generated-sky"]}
    pairs = [(views, model.answering(queries))]
    (before,) = lobe_pictures(pairs, even, Grid(10)).errors()
    assert fit_lobes(model, views, queries, [StepPace(120)]) == 120
    (after,) = lobe_pictures(pairs, even, Grid(10)).errors()
    assert after.psnr > before.psnr + 3.0
    assert after.flip < before.flip
    assert after.brightness == pytest.approx((1.0, 1.0, 1.0), abs=0.3)


def test_muon_trains_all_layers_of_the_decoder_but_the_last(views, queries, model, monkeypatch):
    made, make = [], lobe_fit.optimizers_of_networks
    monkeypatch.setattr(
        lobe_fit, "optimizers_of_networks", lambda *a: made.extend(make(*a)) or made
    )
    before = [p.detach().clone() for p in model.parameters()]
    fit_lobes(model, views, queries, [StepPace(2)])
    adam, muon = ([p for group in one.param_groups for p in group["params"]] for one in made)
    assert isinstance(made[1], Muon)
    assert [p.shape for p in muon] == [(64, queries.columns), (64, 64)]
    assert {id(p) for p in [*adam, *muon]} == {id(p) for p in model.parameters()}
    assert not any(map(torch.equal, before, model.parameters()))


def test_a_package_answers_as_the_trained_lobes(views, queries, model, tmp_path):
    lobes = exported_lobes(model, views, queries, "small")
    assert lobes.agreement.max_absolute < 1e-3
    Unpacked.read(TOY).with_environment([lobes]).write(tmp_path / "lit.rna")
    part = load(tmp_path / "lit.rna")
    points = views.points(300, np.random.default_rng(2))
    actual = part.lobes(points.position, points.axis, points.wo, points.free, points.visibility)
    for ours, trained in zip(actual, model.answering(queries)(points), strict=True):
        assert ours == pytest.approx(trained, rel=1e-3, abs=1e-3)
    assert part.mirror(points.axis, points.wo) == pytest.approx(points.mirror, abs=1e-6)


def test_the_command_adds_lobes_to_a_package(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(environment_training, "grid_of", lambda parts: Grid(3, rays=2))
    out, forest = tmp_path / "lit.rna", tmp_path / "my forest.exr"
    write_exr(forest, dict.fromkeys("RGB", np.full((8, 16), 0.5, np.float32)), {})
    options = ["--environment", "--environment-minutes", "0.02", "--environment-files", forest]
    assert main([str(word) for word in (HEAD, "--out", out, *options)]) == 0
    assert validate(out) == []
    with Package.open(HEAD) as before, Package.open(out) as package:
        kinds = [part.kind for part in package.manifest.parts]
        data = extension(package.manifest, Environment)
        records = [lobes.record for lobes in map(package.environment, range(len(kinds)))]
        assert before.manifest.entries.items() < package.manifest.entries.items()
        assert before.manifest.tiers == package.manifest.tiers
    assert sorted(kinds) == ["fiber", "surface"]
    for kind, record, planes in zip(kinds, records, package.manifest.tiers[0].parts, strict=True):
        assert (record.lobes, record.planes, record.inputs) == (LOBES, planes.planes, planes.inputs)
        assert (record.visibility is None) == (kind == "fiber")
    names = [one.environment for one in data.validation]
    assert names == ["generated-sky", "generated-studio", "my-forest"]
    said = capsys.readouterr().out
    assert all(f"environment {name}: PSNR " in said for name in names)
    assert said.count(" of 5,000 steps, ") == 2
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
    ("given", "output"),
    [
        ([], "or one package with --environment"),
        (["--environment", "--environment-minutes", "0"], "expected a number above 0"),
        (["--environment-files", "a.hdr"], "expected --environment as well"),
        (["--environment", "--proxies", "32"], "argument --proxies: expected checkpoints"),
    ],
)
def test_options_that_do_not_belong_together(given, output, tmp_path, capsys):
    with pytest.raises(SystemExit):
        main([str(HEAD), "--out", str(tmp_path / "a.rna"), *given])
    assert output in capsys.readouterr().err


def test_the_last_quarter_of_a_make_is_for_lobes():
    def minutes(**given: object) -> float:
        usual = {"environment": True, "environment_minutes": 5.0, "minutes": None, "more": None}
        return lobe_minutes(Namespace(**(usual | given)))

    assert [minutes(), minutes(minutes=8.0), minutes(minutes=60.0)] == [5.0, 2.0, 5.0]
    assert minutes(more=8.0) == 2.0 and minutes(environment=False) == 0.0

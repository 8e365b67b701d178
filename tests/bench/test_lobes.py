"""Lobes of the transport: densities, what is split off an environment, training, errors."""

import numpy as np
import pytest
import torch

from rna_bench.lobes.directions import even_directions, random_rotations
from rna_bench.lobes.lobe_error import generated_environments, lobe_errors
from rna_bench.lobes.lobe_fit import fit_lobes, light_weights, lobe_loss, make_rows
from rna_bench.lobes.lobe_model import LobeInputs, LobeModel, QueryRows, densities
from rna_bench.lobes.spherical_harmonics import COUNT, harmonics
from rna_bench.lobes.view_points import PartViews
from rna_render.lights.bright_directions import MOST, cell_directions, split_environment
from rna_sdk.package import Package
from rna_sdk.runtime import load

TOY = "examples/quickstart/toy.rna"


@pytest.fixture(scope="module")
def asset():
    return load(TOY, threads=1)


@pytest.fixture(scope="module")
def views(asset):
    return PartViews(asset, 0)


@pytest.fixture(scope="module")
def queries(asset):
    with Package.open(TOY) as package:
        return QueryRows(package, asset.tier.name, 0, COUNT)


@pytest.fixture
def model(queries):
    torch.manual_seed(0)
    return LobeModel(queries.columns, 64, 2)


def test_harmonics_are_orthonormal():
    d = even_directions(20_000)
    products = harmonics(d).T @ harmonics(d) * (4 * np.pi / len(d))
    assert np.abs(products - np.eye(COUNT)).max() < 2e-3


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


def test_split_light_is_all_of_the_light():
    texels = np.full((64, 128, 3), 0.1, np.float32)
    texels[10:12, 20:22], texels[40, 100] = (50.0, 40.0, 30.0), (0.0, 0.0, 90.0)
    split = split_environment(texels)
    whole = (split.rest / split.share[..., None]).sum(axis=(0, 1))
    assert split.flux.sum(axis=0) + split.rest.sum(axis=(0, 1)) == pytest.approx(whole, rel=1e-4)
    assert len(split.directions) <= MOST
    assert np.linalg.norm(split.directions, axis=1) == pytest.approx(1.0)


def test_split_light_is_where_it_shines():
    texels = np.zeros((64, 128, 3), np.float32)
    texels[16, 96] = 1.0  # 45 degrees above the horizon, a quarter of a turn to the right
    split = split_environment(texels)
    brightest = split.directions[np.argmax(split.flux.sum(axis=1))]
    assert brightest == pytest.approx((0.7, 0.7, 0.0), abs=0.06)


def test_an_even_environment_is_not_split():
    split = split_environment(np.ones((32, 64, 3), np.float32))
    assert len(split.directions) == 0
    assert split.rest.sum(axis=(0, 1)) == pytest.approx(4 * np.pi, rel=1e-3)
    assert np.abs(np.linalg.norm(cell_directions(), axis=1) - 1.0).max() < 1e-9


def test_lobes_that_are_the_truth_have_no_loss(views, queries, model):
    *inputs, directions, transport = make_rows(views, queries, 32, np.random.default_rng(0))
    with torch.no_grad():
        amplitude, axis = model(LobeInputs(*inputs))
        truth = amplitude.transpose(1, 2) @ densities(axis, torch.from_numpy(directions))
    assert lobe_loss(model, [*inputs, directions, truth.numpy()], light_weights()) < 1e-10
    assert lobe_loss(model, [*inputs, directions, transport], light_weights()) > 1e-3


def test_training_comes_nearer_to_the_whole_integral(views, queries, model):
    even = {"even": generated_environments()["sky"]}
    (before,) = lobe_errors(views, queries, model, even, size=10)
    fit_lobes(model, views, queries, 120)
    (after,) = lobe_errors(views, queries, model, even, size=10)
    assert after.psnr > before.psnr + 3.0
    assert after.flip < before.flip
    assert after.brightness == pytest.approx((1.0, 1.0, 1.0), abs=0.3)

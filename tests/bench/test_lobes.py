"""Lobes of the transport: closed forms against sums over the sphere, gradients, training."""

import numpy as np
import pytest
import torch

from rna_bench.lobes.directions import directions_of_lights, even_directions, log_c
from rna_bench.lobes.full_integral import Integrals, cell_directions, cell_flux
from rna_bench.lobes.lobe_fit import fit_lobes, make_rows
from rna_bench.lobes.lobe_kernels import answer, difference, gradients
from rna_bench.lobes.lobe_model import LOBES, LobeModel
from rna_bench.lobes.spherical_harmonics import harmonics
from rna_bench.lobes.view_points import AssetViews
from rna_bench.one_part import load_one_part
from rna_sdk.package import Package

TOY = "examples/quickstart/toy.rna"


@pytest.fixture(scope="module")
def views():
    return AssetViews(load_one_part(TOY, threads=1))


def random_lobes(n=3, lobes=4, lights=2):
    rng = np.random.default_rng(0)
    amplitude = rng.random((n, lobes, 3)).astype(np.float32)
    axis = rng.normal(scale=3, size=(n, lobes, 3)).astype(np.float32)
    return amplitude, axis, rng.normal(scale=2, size=(n, lights, 3)).astype(np.float32)


def answered(amplitude, axis, lights):
    answers = np.empty(lights.shape, np.float32)
    shares = np.empty((*lights.shape[:2], axis.shape[1], 4), np.float32)
    answer(amplitude, axis, lights, answers, shares)
    return answers, shares


def densities(axes, d):
    kappa = np.linalg.norm(axes, axis=-1)
    return np.exp(log_c(kappa)[..., None] + axes @ d.T)


def test_harmonics_are_orthonormal():
    d = even_directions(20_000)
    products = harmonics(d).T @ harmonics(d) * (4 * np.pi / len(d))
    assert np.abs(products - np.eye(16)).max() < 2e-3


def test_answers_are_integrals_of_products():
    amplitude, axis, lights = random_lobes()
    d = even_directions(50_000)
    both = np.einsum("njd,nkd->nkj", densities(axis, d), densities(lights, d)) * 4 * np.pi / len(d)
    expected = np.einsum("nkj,njc->nkc", both, amplitude)
    assert np.allclose(answered(amplitude, axis, lights)[0], expected, rtol=1e-3)


def test_gradients_are_slopes():
    amplitude, axis, lights = random_lobes()
    towards = np.random.default_rng(1).normal(size=lights.shape).astype(np.float32)
    _, shares = answered(amplitude, axis, lights)
    of_amplitude, of_axis = np.empty_like(amplitude), np.empty_like(axis)
    gradients(amplitude, towards, shares, of_amplitude, of_axis)
    step = np.float32(1e-2)
    for array, gradient in ((amplitude, of_amplitude), (axis, of_axis)):
        place = 1, 2, 0
        array[place] += step
        above = (answered(amplitude, axis, lights)[0] * towards).sum()
        array[place] -= 2 * step
        below = (answered(amplitude, axis, lights)[0] * towards).sum()
        array[place] += step
        assert gradient[place] == pytest.approx((above - below) / (2 * step), rel=2e-2)


def test_difference_of_lobes_and_themselves_is_none():
    amplitude, axis, lights = random_lobes()
    d = np.ascontiguousarray(np.broadcast_to(even_directions(64), (len(axis), 64, 3)))
    truth = np.einsum("njd,njc->ndc", densities(axis, d[0]), amplitude).astype(np.float32)
    weights, found = np.ones((len(axis), 2, 64), np.float32), np.empty_like(lights)
    difference(amplitude, axis, d, truth, weights, found)
    assert np.abs(found).max() < 1e-4
    difference(amplitude, axis, d, truth - np.float32(1.0), weights, found)
    assert np.allclose(found, 64.0, rtol=1e-4)


def test_directions_of_lights_are_about_them():
    axis = np.broadcast_to((0.0, 0.6, 0.8), (2000, 1, 3))
    d = directions_of_lights(axis, np.full((2000, 1), 5.0), 4, np.random.default_rng(0))
    assert np.allclose(np.linalg.norm(d, axis=-1), 1.0)
    mean = d.reshape(-1, 3).mean(axis=0)
    assert mean == pytest.approx((1 / np.tanh(5.0) - 0.2) * axis[0, 0], abs=0.01)


def test_cells_hold_the_light_of_an_image():
    flux = cell_flux(np.ones((128, 256, 3)))
    assert flux.sum(axis=0) == pytest.approx(4 * np.pi, rel=1e-3)
    texels = np.zeros((128, 256, 3))
    texels[32, 64] = 1.0  # 45 degrees above the horizon, a quarter of a turn about
    (place,) = np.flatnonzero(cell_flux(texels).sum(axis=1))
    assert cell_directions()[place] == pytest.approx((0.0, 0.7, 0.7), abs=0.05)


def test_weights_sum_up_to_the_lights(views):
    rows = make_rows(views, 400, np.random.default_rng(0))
    assert rows["weights"].sum(axis=2).mean() == pytest.approx(1.0, abs=0.03)


def test_training_comes_nearer_to_the_whole_integral(views):
    torch.manual_seed(0)
    with Package.open(TOY) as package:
        model = LobeModel(package, views.part.tier.name, 64, 4)
    integrals, flux = Integrals(views, count=60), cell_flux(np.ones((64, 128, 3)))
    amplitude, density = integrals.densities(model)
    assert amplitude.shape[1] == LOBES
    before = integrals.score((amplitude, density), flux, 8).psnr
    fit_lobes(model, views, 60)
    after = integrals.score(integrals.densities(model), flux, 8)
    assert after.psnr > before + 3.0
    assert after.brightness == pytest.approx((1.0, 1.0, 1.0), abs=0.3)

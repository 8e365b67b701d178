"""The integrator's compiled steps against plain numpy, and how an image is cut into bands."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from rna_render.lights import LightSamples
from rna_render.lights.equirectangular import EquirectangularImage
from rna_render.paths.bands import BAND, SMALL_BAND, _bands
from rna_render.paths.light_sampling import LightChoice
from rna_render.paths.weighing import (
    Tried,
    clamp_paths,
    weigh_hit,
    weigh_rays,
    weigh_samples,
    worth_tracing,
)
from tests.runtime.points import unit_vectors

RNG = np.random.default_rng(5)


def numbers(*shape: int) -> np.ndarray:
    """Some of them 0."""
    values = RNG.random(shape, np.float32)
    return np.where(RNG.random(shape) < 0.4, np.float32(0.0), values)


def test_samples_worth_tracing():
    n, m = 500, 50
    row, light = np.sort(RNG.integers(0, m, n)), RNG.integers(0, 3, n)
    instance, same_light = RNG.integers(0, 4, m).astype(np.int32), np.int32([-1, 0, 1, 2])
    one_sided = np.array([True, False, True, False])
    wi, wo, ng = unit_vectors(RNG, n), unit_vectors(RNG, m), unit_vectors(RNG, m)
    samples = LightSamples(wi, numbers(n), numbers(n, 3), numbers(n))
    start_instance = RNG.integers(0, 9, m).astype(np.int32)
    vertices: Any = SimpleNamespace(
        instance=instance, wo_world=wo, ng_world=ng, start_instance=start_instance
    )
    world: Any = SimpleNamespace(same_light=same_light, one_sided=one_sided)
    expected = (samples.pdf > 0.0) & samples.radiance.any(axis=1)
    expected &= same_light[instance[row]] != light
    same_side = np.sum(ng[row] * wi, axis=1) * np.sum(ng * wo, axis=1)[row] > 0.0
    expected &= same_side | ~one_sided[instance[row]]
    actual = worth_tracing(samples, LightChoice(row, light, numbers(n, 2)), vertices, world)
    rows = np.flatnonzero(expected)
    assert 0 < len(rows) < n
    assert (actual.sample == rows).all() and (actual.row == row[rows]).all()
    assert (actual.light == light[rows]).all() and (
        actual.start_instance == start_instance[row[rows]]
    ).all()
    assert (actual.wi_world == wi[rows]).all()
    assert (actual.distance == samples.distance[rows]).all()


@pytest.mark.parametrize("channels", [1, 3])
def test_samples_of_which_something_is_left(channels):
    n = 200
    arrays = (RNG.integers(0, 99, n) for _ in range(3))
    tried = Tried(*arrays, numbers(n, 3), numbers(n), RNG.integers(0, 9, n).astype(np.int32))
    visibility = numbers(n, channels)
    actual, left = tried.where_visible(visibility)
    rows = np.flatnonzero(visibility.any(axis=1))
    assert (left == visibility[rows]).all()
    for of_actual, of_tried in zip(actual, tried, strict=True):
        assert (of_actual == of_tried[rows]).all()


@pytest.mark.parametrize("channels", [1, 3])
def test_weights_of_samples(channels):
    n, k, m = 300, 100, 40
    radiance, pdf = numbers(n, 3), RNG.random(n).astype(np.float32) + np.float32(0.1)
    sample, row = np.sort(RNG.choice(n, k, replace=False)), np.sort(RNG.integers(0, m, k))
    light, probability, delta = RNG.integers(0, 3, k), RNG.random(3) + 0.1, RNG.random(3) < 0.5
    transport, visibility, seen, beta = (
        numbers(k, 3),
        numbers(k, channels),
        numbers(k),
        numbers(m, 3),
    )
    light_pdf = numbers(k)
    density = pdf[sample] * probability[light]
    share = np.where(delta[light], np.float32(1.0), 1.0 / (1.0 + np.square(light_pdf / density)))
    weight = (share / density)[:, None]
    expected = beta[row] * transport * radiance[sample] * weight * visibility
    expected_seen = seen * visibility.mean(axis=1)
    samples = LightSamples(numbers(n, 3), numbers(n), radiance, pdf)
    tried = Tried(sample, row, light, numbers(k, 3), numbers(k), np.zeros(k, np.int32))
    weigh_samples(transport, seen, samples, tried, visibility, light_pdf, probability, delta, beta)
    assert transport == pytest.approx(expected, rel=1e-5)
    assert seen == pytest.approx(expected_seen, rel=1e-5)


@pytest.mark.parametrize("both", [True, False])
def test_weights_of_met_light(both):
    n, k = 90, 40
    row = np.sort(RNG.choice(n, k, replace=False))
    radiance, pdf, beta, light_pdf = numbers(k, 3), numbers(k), numbers(n, 3), numbers(n)
    ray_density = light_pdf[row].astype(np.float64)
    share = (
        ray_density**2 / np.maximum(ray_density**2 + (3.0 * pdf) ** 2, 1e-30)
        if both
        else np.ones(k)
    )
    actual = weigh_hit(radiance, pdf, np.full(k, 3.0), light_pdf if both else None, row, beta)
    assert actual == pytest.approx(beta[row] * radiance * share[:, None], rel=1e-5)
    assert actual.any()


@pytest.mark.parametrize("coloured", [True, False])
def test_weights_of_rays(coloured):
    k, m = 100, 40
    row, transport, pdf, beta = RNG.integers(0, m, k), numbers(k, 3), numbers(k), numbers(m, 3)
    passed = numbers(k, 3) if coloured else None
    chance = np.where(pdf > 0.0, 1.0 / np.maximum(pdf, 1e-30), 0.0)[:, None]
    expected = transport * beta[row] * chance * (1.0 if passed is None else passed)
    weigh_rays(transport, pdf, passed, row, beta)
    assert transport == pytest.approx(expected, rel=1e-5)
    assert transport.any()


def test_the_clamp_keeps_hues():
    radiance = np.float32([[0.5, 2.0, 1.0], [0.0, 0.0, 0.0], [0.9, 0.1, 0.0], [0.9, 0.0, 0.3]])
    taken = np.zeros(3, np.float32)
    clamp_paths(radiance, np.float32([1.0, 1.0, 1.0, 0.3]), np.array([2, 1, 0, 2]), taken)
    expected = [[0.25, 1.0, 0.5], [0, 0, 0], [0.9, 0.1, 0.0], [0.3, 0.0, 0.1]]
    assert radiance == pytest.approx(np.float32(expected))
    assert taken == pytest.approx([0.0, 0.0, (3.5 + 1.2) / 3 - (1.75 + 0.4) / 3])


@pytest.mark.parametrize("count", [1, 100, SMALL_BAND + 1, BAND + 1, 640 * 360, 1_000_001])
@pytest.mark.parametrize("threads", [1, 2, 3])
def test_bands_are_of_one_size_and_as_many_for_each_thread(count, threads):
    bands = _bands(count, threads, BAND)
    sizes = [len(band) for band in bands]
    assert (np.concatenate(bands) == np.arange(count)).all()
    assert max(sizes) <= BAND and max(sizes) - min(sizes) <= 1
    assert len(bands) % threads == 0 or count <= threads * SMALL_BAND


def test_bands_of_many_samples_are_as_few_as_they_can_be():
    """Python's work for a band, one thread at a time, is that of as much light as possible."""
    assert len(_bands(8 * BAND, 16, BAND, samples=1)) == 16
    assert len(_bands(8 * BAND, 16, BAND, samples=64)) == 8


def test_directions_of_an_image_are_those_of_plain_sums():
    """Cells by their running sums, in blocks or not: any number of directions, in any order."""
    texels = RNG.random((12, 20, 3)).astype(np.float32) ** 4
    image = EquirectangularImage(texels)
    _, _, rows, columns = image.tables
    u = RNG.random((1000, 2))
    d, radiance, pdf = image.sample(u)
    row = np.searchsorted(rows, u[:, 1] * rows[-1], side="right") - 1
    value = u[:, 0] * columns[row, -1]
    places = zip(row, value, strict=True)
    column = np.array([np.searchsorted(columns[r], x, side="right") - 1 for r, x in places])
    s = (np.arctan2(d[:, 0], -d[:, 2]) / (2 * np.pi) + 0.5) * 20 - 0.5
    t = np.arccos(np.clip(d[:, 1], -1, 1)) / np.pi * 12 + 0.5
    away = np.abs(np.stack([s % 20 - column - 0.5, t - row - 0.5]))
    away[0] = np.minimum(away[0], 20 - away[0])
    assert (away <= 0.5 + 1e-3).all()
    looked_up, density = image.lookup(d)
    assert radiance == pytest.approx(looked_up, rel=1e-3, abs=1e-4)
    assert pdf == pytest.approx(density, rel=1e-2, abs=1e-4)
    for part in (slice(0, 1), slice(3, 66), slice(100, 400)):
        assert (image.sample(u[part])[0] == d[part]).all()

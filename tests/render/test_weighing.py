"""The integrator's compiled steps against plain numpy, and how an image is cut into bands."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from rna_render.bands import BAND, SMALL_BAND, _bands
from rna_render.light_sampling import LightChoice
from rna_render.lights import LightSamples
from rna_render.lights.equirectangular import EquirectangularImage
from rna_render.weighing import power_share, rows_with_light, weigh_samples, worth_tracing
from tests.render.assets import unit_vectors

RNG = np.random.default_rng(5)


def numbers(*shape: int) -> np.ndarray:
    """Some of them 0."""
    values = RNG.random(shape, np.float32)
    return np.where(RNG.random(shape) < 0.4, np.float32(0.0), values)


def test_samples_worth_tracing() -> None:
    n, m = 500, 50
    row, light = np.sort(RNG.integers(0, m, n)), RNG.integers(0, 3, n)
    instance, own_light = RNG.integers(0, 4, m).astype(np.int32), np.int32([-1, 0, 1, 2])
    one_sided = np.array([True, False, True, False])
    wi, wo, ng = unit_vectors(RNG, n), unit_vectors(RNG, m), unit_vectors(RNG, m)
    samples = LightSamples(wi, numbers(n), numbers(n, 3), numbers(n))
    vertices: Any = SimpleNamespace(instance=instance, wo_world=wo, ng_world=ng)
    world: Any = SimpleNamespace(own_light=own_light, one_sided=one_sided)
    expected = (samples.pdf > 0.0) & samples.radiance.any(axis=1)
    expected &= own_light[instance[row]] != light
    same_side = np.sum(ng[row] * wi, axis=1) * np.sum(ng * wo, axis=1)[row] > 0.0
    expected &= same_side | ~one_sided[instance[row]]
    found = worth_tracing(samples, LightChoice(row, light, numbers(n, 2)), vertices, world)
    assert 0 < len(found) < n
    assert (found == np.flatnonzero(expected)).all()


@pytest.mark.parametrize("channels", [1, 3])
def test_weights_of_samples(channels: int) -> None:
    n, k = 300, 100
    radiance, found = numbers(n, 3), np.sort(RNG.choice(n, k, replace=False))
    transport, kept = numbers(k, 3), numbers(k, channels)
    pdf, own_pdf = RNG.random(k) + 0.1, numbers(k)
    delta = RNG.random(k) < 0.3
    share = np.where(delta, np.float32(1.0), power_share(pdf, own_pdf)[:, 0])
    weight = (share / pdf)[:, None].astype(np.float32)
    expected = transport * (radiance[found] * weight * kept)
    weigh_samples(transport, radiance, found, kept, pdf, own_pdf, delta)
    assert transport == pytest.approx(expected, rel=1e-6)
    assert (rows_with_light(kept) == np.flatnonzero(kept.any(axis=1))).all()


@pytest.mark.parametrize("count", [1, 100, SMALL_BAND + 1, BAND + 1, 640 * 360, 1_000_001])
@pytest.mark.parametrize("threads", [1, 2, 3])
def test_bands_are_of_one_size_and_as_many_for_each_thread(count: int, threads: int) -> None:
    bands = _bands(count, threads)
    sizes = [len(band) for band in bands]
    assert (np.concatenate(bands) == np.arange(count)).all()
    assert max(sizes) <= BAND and max(sizes) - min(sizes) <= 1
    assert len(bands) % threads == 0 or count <= threads * SMALL_BAND


def test_directions_of_an_image_are_those_of_plain_sums() -> None:
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

"""Means of environments under von Mises-Fisher distributions, against sums over the sphere."""

from __future__ import annotations

import numpy as np
import pytest

from rna_render.lights.split.bright_directions import (
    COLUMNS,
    ROWS,
    cell_directions,
    split_environment,
)
from rna_render.lights.split.prefilter import PrefilteredEnvironment

ANGLE = 0.7


def texels() -> np.ndarray:
    """A sky with a bright horizon to one side and two lamps, one of them small."""
    theta = (np.arange(96) + 0.5) / 96 * np.pi
    turn = 2 * np.pi * ((np.arange(192) + 0.5) / 192 - 0.5)
    y = np.broadcast_to(np.cos(theta)[:, None], (96, 192))
    x, z = np.sin(theta)[:, None] * np.sin(turn), -np.sin(theta)[:, None] * np.cos(turn)
    d = np.stack([x, y, z], axis=-1)

    def lamp(towards, sharpness):
        axis = np.asarray(towards) / np.linalg.norm(towards)
        return np.exp(sharpness * (d @ axis - 1.0))[..., None]

    sky = 0.1 + np.clip(y, 0, 1)[..., None] * (0.4, 0.6, 1.0)
    lamps = 40.0 * lamp((1, 0.7, 0.2), 400.0) + 4.0 * lamp((-1, 0.1, -1), 20.0) * (1.0, 0.7, 0.4)
    return (sky + lamps).astype(np.float32)


@pytest.fixture(scope="module")
def rest() -> np.ndarray:
    return split_environment(texels()).rest


def direct(flux: np.ndarray, axes: np.ndarray) -> np.ndarray:
    """Mean of an environment at ANGLE under lobes (n, 3), by a sum over its cells."""
    c, s = np.cos(ANGLE), np.sin(ANGLE)
    d = cell_directions() @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T
    kappa = np.linalg.norm(axes, axis=1, keepdims=True)
    weights = np.exp(axes @ d.T - kappa)
    radiance = flux.reshape(-1, 3) / (4 * np.pi / len(d))
    return weights @ radiance / weights.sum(axis=1, keepdims=True)


def lobes(count: int) -> np.ndarray:
    rng = np.random.default_rng(3)
    d = rng.normal(size=(count, 3))
    kappa = 2.0 ** rng.uniform(-2, 7, (count, 1))
    return d / np.linalg.norm(d, axis=1, keepdims=True) * kappa


def test_means_are_those_of_the_whole_sphere(rest):
    axes = lobes(3000)
    actual = PrefilteredEnvironment(rest).light(
        np.ones((3000, 1, 3), np.float32), axes[:, None].astype(np.float32), ANGLE, np.ones(3)
    )
    expected = direct(rest, axes)
    error = np.abs(actual - expected)
    assert np.sqrt(np.square(error).sum() / np.square(expected).sum()) < 0.01
    assert np.median(error / expected) < 0.005


def test_lobes_add_up_in_their_colours(rest):
    sky, axes = PrefilteredEnvironment(rest), lobes(60).reshape(20, 3, 3).astype(np.float32)
    amplitudes = np.random.default_rng(0).random((20, 3, 3)).astype(np.float32)
    scale = np.array([1.0, 2.0, 0.5])
    one = np.ones((20, 1, 3), np.float32)
    means = np.stack([sky.light(one, axes[:, k : k + 1], ANGLE, scale) for k in range(3)], axis=1)
    actual = sky.light(amplitudes, axes, ANGLE, scale)
    assert actual == pytest.approx((amplitudes * means).sum(axis=1), rel=1e-5)


@pytest.mark.parametrize("kappa", [1e-6, 0.1, 3.0, 500.0])
def test_an_even_sky_stays_what_it_is(kappa):
    sky = PrefilteredEnvironment(np.full((ROWS, COLUMNS, 3), 4 * np.pi / (ROWS * COLUMNS)))
    axes = (lobes(50) / np.linalg.norm(lobes(50), axis=1, keepdims=True) * kappa)[:, None]
    actual = sky.light(np.ones((50, 1, 3), np.float32), axes.astype(np.float32), 0.0, np.ones(3))
    assert actual == pytest.approx(np.ones((50, 3)), rel=1e-5)

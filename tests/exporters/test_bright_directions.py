"""Bright regions of an environment as a few directions."""

import numpy as np
import pytest

from rna_export.lobes.bright_directions import MOST, cell_directions, split_environment


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

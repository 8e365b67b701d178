"""Random numbers: how they are spread, and what they depend on."""

import numpy as np
import pytest

from rna_render.paths.sampling import Sampler

PIXELS = np.arange(64, dtype=np.uint32)


def squares(count: int, seed: int = 0, dimension: int = 0) -> np.ndarray:
    """(samples, pixels, 2)."""
    return np.stack([Sampler(seed, k).square(PIXELS, dimension) for k in range(count)])


def test_numbers_depend_on_all_four_and_on_nothing_else():
    first = squares(2)
    np.testing.assert_array_equal(first, squares(2))
    np.testing.assert_array_equal(
        first[:, 5], np.stack([Sampler(0, k).square(PIXELS[5:6], 0)[0] for k in (0, 1)])
    )
    for other in (squares(2, seed=1), squares(2, dimension=1)):
        assert not np.isclose(first, other).any()
    assert len(np.unique(first)) == first.size


@pytest.mark.parametrize("log2", [1, 4, 6])
def test_every_power_of_two_of_samples_is_a_net(log2):
    """A (0, k, 2)-net: every elementary rectangle of area 2^-k holds exactly one of 2^k points."""
    count = 1 << log2
    points = squares(count)
    assert points.min() >= 0 and points.max() < 1
    for bits in range(log2 + 1):
        columns, rows = 1 << bits, 1 << (log2 - bits)
        cell = (points[..., 0] * columns).astype(int) * rows + (points[..., 1] * rows).astype(int)
        assert (np.sort(cell, axis=0) == np.arange(count)[:, None]).all()


def test_pixels_and_dimensions_are_uncorrelated():
    many = np.arange(20_000, dtype=np.uint32)
    u, v = Sampler(7, 0).square(many, 0), Sampler(7, 0).square(many, 1)
    columns = np.column_stack([u[:-1], u[1:], v[:-1]])
    correlation = np.corrcoef(columns, rowvar=False) - np.eye(6)
    assert np.abs(correlation).max() < 5 / np.sqrt(len(many))

"""The variance of an image, from the halves of its samples."""

import numpy as np
import pytest

from rna_render.image.film import Film
from rna_render.image.halves import _OF_HALVES, Halves

RNG = np.random.default_rng(0)
PIXELS = 20_000


@pytest.mark.parametrize("samples", [2, 3, 16, 24, 64])
def test_independent_samples_have_the_variance_of_their_mean(samples):
    values = RNG.standard_normal((samples, PIXELS, 3))
    halves, total = Halves.empty(PIXELS), np.zeros((PIXELS, 3))
    for count, value in enumerate(values, 1):
        total += value
        halves.follow(total, count)
    doubled = 2 ** int(np.log2(samples))
    assert halves.samples == doubled
    assert halves.variance.mean() == pytest.approx(_OF_HALVES / doubled, rel=0.03)


def test_samples_that_come_several_at_once():
    values = RNG.standard_normal((12, PIXELS, 3))
    halves, total, count = Halves.empty(PIXELS), 0.0, 0
    for group in np.split(values, [3, 8]):
        total, count = total + group.sum(axis=0), count + len(group)
        halves.follow(total, count)
    assert halves.samples == 8
    assert halves.variance.mean() == pytest.approx(_OF_HALVES / 8, rel=0.03)


def test_pieces_of_a_film_have_the_variance_of_the_whole():
    whole = Film((6, 1))
    whole._halves = Halves(RNG.random((6, 3)), RNG.random((6, 3)), 4)
    whole.samples = 6
    again = Film.of_arrays(whole.arrays(), ())
    joined = Film((6, 2))
    for row in range(2):
        joined.put(6 * row, again)
    expected = whole.variance()
    assert expected is not None and joined.variance() is not None
    np.testing.assert_array_equal(joined.variance(), np.concatenate([expected, expected]))
    assert Film((2, 2)).variance() is None

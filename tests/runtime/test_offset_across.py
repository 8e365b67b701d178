"""h from the geometry of a hit."""

import numpy as np
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.runtime import offset_across
from tests.runtime.points import random_points, unit_vectors


def test_it_counts_to_the_right_of_a_fiber_that_points_up():
    """+Y is up, the eye is at +Z and higher or lower: +X is to the right."""
    angle = np.linspace(-np.pi / 2, np.pi / 2, 101)
    normals = np.stack([np.sin(angle), 0 * angle, np.cos(angle)], axis=1).astype(np.float32)
    t = np.tile(np.float32([0, 1, 0]), (101, 1))
    for height in (0.0, 3.0, -0.5):
        wo = np.tile(np.float32([0, height, 1]), (101, 1))
        h = offset_across(normals, t, wo)
        assert h.dtype == np.float32
        np.testing.assert_allclose(h, np.sin(angle), atol=1e-7)
        np.testing.assert_allclose(offset_across(normals, -t, wo), -h, atol=1e-7)


def test_length_of_vectors_does_not_count():
    points = random_points(200)
    h = offset_across(points.normals, points.wo, points.wi)
    assert np.abs(h).max() > 0.9
    scaled = offset_across(points.normals * 2.0**40, points.wo * 2.0**-20, points.wi * 2.0**10)
    np.testing.assert_array_equal(scaled, h)


def test_it_stays_within_the_fiber():
    n, t, wo = (unit_vectors(np.random.default_rng(k), 5000) for k in range(3))
    edge = np.cross(t, wo).astype(np.float32)
    h = offset_across(edge, t, wo)
    assert (h <= 1).all() and (h > 1 - 1e-6).all()
    assert (np.abs(offset_across(n, t, wo)) <= 1).all()


def test_where_there_is_no_telling_it_is_zero():
    n, t, wo = (unit_vectors(np.random.default_rng(k), 6) for k in range(3))
    assert offset_across(n, t, wo).all()
    wo[0], wo[1] = t[0], -3 * t[1]
    n[2] = 0
    t[3, 1], n[4, 0], wo[5, 2] = np.nan, np.inf, -np.inf
    assert not offset_across(n, t, wo).any()


def test_arguments_are_checked():
    n, t, wo = (unit_vectors(np.random.default_rng(k), 6) for k in range(3))
    with pytest.raises(QueryError, match=r"^tangents: expected a \(6, 3\) .* found \(5, 3\)"):
        offset_across(n, t[:5], wo)
    with pytest.raises(QueryError, match=r"^wo: .*float64"):
        offset_across(n, t, wo.astype(np.float64))
    assert offset_across(n[:0], t[:0], wo[:0]).shape == (0,)

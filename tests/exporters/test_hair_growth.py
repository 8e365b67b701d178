"""Strands grown between guides, and changes of single strands."""

import numpy as np
import pytest

from rna_export.blender.rna_hair import Strands, fit, interpolate, join, resample, taper
from rna_export.blender.rna_hair.strands import of_equal_length


def lawn(n: int = 6) -> Strands:
    """n x n guides of 5 points, one unit apart, upright and bent a little."""
    x, z = np.meshgrid(np.arange(n), np.arange(n))
    t = np.linspace(0.0, 1.0, 5)
    roots = np.stack([x.ravel(), np.zeros(n * n), z.ravel()], axis=-1)
    shape = np.stack([0.3 * t**2, 3.0 * t, np.zeros(5)], axis=-1)
    return of_equal_length(roots[:, None] + shape, 0.1)


def parting() -> Strands:
    """Guides left of x = 0 run to the left, those right of it to the right."""
    x = np.array([-0.45, -0.35, -0.25, -0.15, -0.05, 0.05, 0.15, 0.25, 0.35, 0.45])
    roots = np.array([(a, 0.0, b) for a in x for b in np.arange(10) * 0.1])
    t = np.linspace(0.0, 1.0, 5)[:, None]
    side = np.sign(roots[:, None, :1]) * np.array([1.0, 0.0, 0.0])
    return of_equal_length(roots[:, None] + t * side + 0.3 * t * [0.0, 1.0, 0.0], 0.1)


def shaped(strands: Strands) -> np.ndarray:
    """(s, n, 3) of strands of equal length."""
    return strands.points.reshape(len(strands), -1, 3)


def test_a_seed_repeats():
    one, two, other = (
        interpolate(lawn(), 300, seed=seed, noise=0.02, shorten=0.1).points for seed in (4, 4, 5)
    )
    assert np.array_equal(one, two)
    assert not np.array_equal(one, other)


def test_strands_lie_among_their_guides():
    guides = lawn()
    grown = shaped(interpolate(guides, 2000, points=5))
    grid = shaped(resample(guides, 5))
    distance = np.linalg.norm(grown[:, None] - grid, axis=-1).max(axis=-1).min(axis=1)
    assert distance.max() < 1.0  # no farther than the next guide, all along
    assert distance.mean() > 0.2  # and not on top of one
    low, high = grown[:, 0].min(axis=0), grown[:, 0].max(axis=0)
    assert np.all(low >= -1e-5) and np.all(high <= 5.0 + 1e-5)


def test_every_guide_has_its_share():
    roots = shaped(interpolate(lawn(), 36 * 50, points=5))[:, 0, ::2]
    cells = np.histogram2d(*roots.T, bins=2, range=[[0, 5], [0, 5]])[0]
    assert np.all(np.abs(cells / 450.0 - 1.0) < 0.15)


def test_a_parting_stays_open():
    open_, bridged = (
        shaped(interpolate(parting(), 3000, points=5, alike=alike)) for alike in (0.85, -1.0)
    )
    aside = np.abs(open_[:, -1, 0] - open_[:, 0, 0])
    assert aside.min() > 0.98
    blended = np.abs(bridged[:, -1, 0] - bridged[:, 0, 0])
    assert blended.min() < 0.3  # what would come of guides that do not run alike


def test_roots_do_not_float_between_far_patches():
    left, right = lawn(3), lawn(3)
    guides = join([left, right.moved(1.0, np.array([100.0, 0.0, 0.0]))])
    x = shaped(interpolate(guides, 500, points=5, neighbours=17))[:, 0, 0]
    assert np.all((x < 2.01) | (x > 99.99))


def test_clumps_end_at_their_guide():
    guides = lawn()
    tips = shaped(interpolate(guides, 400, points=5, clump=1.0))[:, -1]
    nearest = np.linalg.norm(tips[:, None] - shaped(guides)[:, -1], axis=-1).min(axis=1)
    assert nearest.max() < 1e-4


def test_shortened_strands_keep_their_roots():
    whole, cut = (shaped(interpolate(lawn(), 300, points=9, shorten=s)) for s in (0.0, 0.5))
    assert np.allclose(whole[:, 0], cut[:, 0], atol=1e-5)
    ratio = np.diff(cut[:, [0, -1], 1]) / np.diff(whole[:, [0, -1], 1])
    assert 0.49 < ratio.min() < 0.6 and 0.9 < ratio.max() <= 1.0


def test_resampling_follows_the_spline():
    angle = np.linspace(0.0, np.pi, 9)
    arc = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=-1)
    fine = shaped(resample(of_equal_length(arc[None], 0.1), 65))[0]
    error = np.abs(np.linalg.norm(fine, axis=1) - 1.0)
    sagitta = 1.0 - np.cos(np.pi / 16)  # of straight lines
    assert error.max() < 0.5 * sagitta and error[16:-16].max() < 0.1 * sagitta
    assert np.allclose(fine[[0, -1]], arc[[0, -1]], atol=1e-6)


def test_resampling_takes_strands_of_any_length_and_keeps_radii():
    points = np.float32([[0, 0, 0], [1, 0, 0], [0, 0, 0], [0, 1, 0], [0, 2, 0], [0, 3, 0]])
    radii = np.float32([2, 1, 4, 3, 2, 1])
    even = resample(Strands(points, radii, np.array([0, 2, 6])), 3)
    assert np.allclose(shaped(even)[0], [[0, 0, 0], [0.5, 0, 0], [1, 0, 0]])
    assert np.allclose(shaped(even)[1], [[0, 0, 0], [0, 1.5, 0], [0, 3, 0]], atol=1e-6)
    assert np.allclose(even.radii, [2, 1.5, 1, 4, 2.5, 1])


def test_points_that_coincide_stay_finite():
    same = of_equal_length(np.zeros((2, 4, 3)), 0.1)
    assert np.isfinite(interpolate(same, 5, points=6, noise=0.1).points).all()


def test_taper():
    radii = taper(lawn(2), 0.2, tip=0.25, start=0.5).radii.reshape(4, 5)
    assert np.allclose(radii, [0.2, 0.2, 0.2, 0.125, 0.05])


def test_fit():
    fitted = fit(lawn())
    assert np.isclose((np.linalg.norm(fitted.points, axis=1) + fitted.radii).max(), 1.0, atol=1e-5)


@pytest.mark.parametrize("grow", [lambda: interpolate(lawn(), 0), lambda: resample(lawn(), 1)])
def test_nothing_is_refused(grow):
    with pytest.raises(ValueError, match=r"found [01]"):
        grow()

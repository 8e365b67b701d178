"""Directions that rays leave assets in, against their densities."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from rna_render.paths.sampling import Sampler
from rna_render.world.bodies import FIBER_LOBES, SURFACE_LOBES
from rna_render.world.neural_sampling import LobeMixture
from tests.render.chi_squared import assert_directions_follow
from tests.runtime.points import unit_vectors

WIDE = 20.0, 40.0, 80.0  # that cells of the whole sphere resolve
MIXTURES = {
    "uniform": LobeMixture(uniform=1.0),
    "cosine": LobeMixture(cosine=1.0),
    "mirror": LobeMixture(mirror=1.0, mirror_kappas=WIDE),
    "cone": LobeMixture(cone=1.0),
    "forward": LobeMixture(forward=1.0),
    "surfaces": replace(SURFACE_LOBES, mirror_kappas=WIDE),
    "fibers": FIBER_LOBES,
}


N = 200_000


def frame(seed: int) -> list[np.ndarray]:
    """Normal, tangent and viewer; the viewer may be on the back."""
    return list(unit_vectors(np.random.default_rng(seed), 3))


def tiled(vectors: list[np.ndarray], count: int) -> list[np.ndarray]:
    return [np.tile(vector, (count, 1)) for vector in vectors]


@pytest.mark.parametrize("name", MIXTURES)
@pytest.mark.parametrize("seed", [0, 1])
def test_directions_follow_their_density(name, seed):
    mixture, at = MIXTURES[name], frame(seed)
    u = np.random.default_rng(seed + 10).random((N, 3))
    wi = mixture.sample(*tiled(at, N), u)
    assert_directions_follow(wi, lambda w: mixture.pdf(*tiled(at, len(w)), w))


@pytest.mark.parametrize("kappa", [400.0, 8000.0])
def test_narrow_highlights_follow_their_density(kappa):
    n, t, wo = (tiled([v], N)[0] for v in frame(2))
    mixture = LobeMixture(mirror=1.0, mirror_kappas=(kappa, 1.5 * kappa, 2.0 * kappa))
    wi = mixture.sample(n, t, wo, np.random.default_rng(4).random((N, 3)))
    mirror = 2.0 * (n[0] @ wo[0]) * n[0] - wo[0]

    def density(w):
        return mixture.pdf(*(rows[: len(w)] for rows in (n, t, wo)), w)

    assert_directions_follow(wi, density, mirror, np.sqrt(60.0 / kappa))


def test_a_fiber_seen_along_its_tangent_is_sampled_too():
    """The cone of specular reflection is one direction there."""
    n, t = np.float32([1, 0, 0]), np.float32([0, 0, 1])
    wi = FIBER_LOBES.sample(*tiled([n, t, t], N), np.random.default_rng(3).random((N, 3)))
    density = FIBER_LOBES.pdf(*tiled([n, t, t], N), wi)
    assert np.isfinite(wi).all() and (density > 0).all()
    assert_directions_follow(wi, lambda w: FIBER_LOBES.pdf(*tiled([n, t, t], len(w)), w))


def test_a_normal_and_a_tangent_of_no_length_are_no_trouble():
    none = np.zeros((2, 3), np.float32)
    wo = np.float32([[0, 0, 1], [0, 1, 0]])
    for mixture in MIXTURES.values():
        wi = mixture.sample(none, none, wo, np.float64([[0, 0, 0], [1 - 1e-16, 0.5, 1 - 1e-16]]))
        np.testing.assert_allclose(np.linalg.norm(wi, axis=1), 1, atol=1e-6)
        assert (mixture.pdf(none, none, wo, wi) > 0).all()


def test_points_spread_evenly_are_so_among_lobes():
    """The first number chooses the lobe and is used again there: 64 points of a net, one lobe's
    share of 0.25, and 16 of them there, whatever the seed."""
    mixture = LobeMixture(uniform=0.25, mirror=0.75, mirror_kappas=(1e6,) * 3)
    mirror = np.float32([[0, 0, 1]])
    for seed in range(8):
        points = Sampler(seed, 0).square(np.zeros(1, np.uint32), 1, 64)
        wi = mixture.sample(*(np.tile(mirror, (64, 1)) for _ in range(3)), points)
        assert np.count_nonzero(wi @ mirror[0] < 0.999) in (15, 16)


def test_an_empty_batch_is_legal():
    none = np.zeros((0, 3), np.float32)
    assert SURFACE_LOBES.sample(none, none, none, np.zeros((0, 3))).shape == (0, 3)


def test_rows_of_points_are_taken_as_they_come():
    rng = np.random.default_rng(4)
    at, row = [unit_vectors(rng, 40) for _ in range(3)], rng.integers(0, 40, 100)
    u, taken = rng.random((100, 3)), [values[row] for values in at]
    wi = FIBER_LOBES.sample(*at, u, row)
    np.testing.assert_array_equal(wi, FIBER_LOBES.sample(*taken, u))
    np.testing.assert_array_equal(FIBER_LOBES.pdf(*at, wi, row), FIBER_LOBES.pdf(*taken, wi))

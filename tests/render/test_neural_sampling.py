"""Directions that rays leave assets in, against their densities."""

import numpy as np
import pytest

from rna_render.paths.sampling import Sampler
from rna_render.world.neural_sampling import Lobe, LobeMixture
from rna_sdk.package.manifest.extensions import USUAL_SAMPLING
from tests.render.chi_squared import assert_directions_follow
from tests.runtime.points import unit_vectors

SURFACE_LOBES, FIBER_LOBES = (LobeMixture.of(one) for one in USUAL_SAMPLING.values())
MIXTURES = {
    "uniform": LobeMixture(),
    "cosine": LobeMixture(cosine=1.0),
    "mirror": LobeMixture(mirror=(Lobe(1.0, 0.3),)),
    "cone": LobeMixture(cone=(Lobe(1.0, 0.1),)),
    "forward": LobeMixture(forward=Lobe(1.0, 0.25)),
    "surfaces": LobeMixture(cosine=0.3, mirror=(Lobe(0.2, 0.2), Lobe(0.1, 0.35), Lobe(0.1, 0.5))),
    "fibers": FIBER_LOBES,
    "fibers of three cones": LobeMixture(
        forward=Lobe(0.2, 0.3), cone=(Lobe(0.3, 0.1), Lobe(0.1, 0.2), Lobe(0.1, 0.4))
    ),
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
    wi = mixture.everywhere.sample(*tiled(at, N), u)
    assert_directions_follow(wi, lambda w: mixture.everywhere.pdf(*tiled(at, len(w)), w))


@pytest.mark.parametrize("alpha", [1e-4, 1e-3, 0.03])
@pytest.mark.parametrize("elevation", [0.15, 0.7, 1.5])
def test_narrow_highlights_follow_their_density(alpha, elevation):
    """Near the mirror direction, since cells of the whole sphere do not resolve them: as many
    directions are there as the density has there, and as it spreads them."""
    wo = np.float32([np.cos(elevation), 0.0, np.sin(elevation)])
    at = [np.float32([0, 0, 1]), np.zeros(3, np.float32), wo]
    mixture = LobeMixture(mirror=(Lobe(1.0, alpha),))
    wi = mixture.everywhere.sample(*tiled(at, N), np.random.default_rng(4).random((N, 2)))
    mirror = np.float64([-wo[0], 0.0, wo[2]])
    near = np.linalg.norm(wi - mirror, axis=1) < 2.0 * np.sin(3.0 * alpha)

    def density(w):
        return mixture.everywhere.pdf(*tiled(at, len(w)), w) / np.float32(near.mean())

    assert near.mean() > 0.5
    assert_directions_follow(wi[near], density, mirror, 6.0 * alpha)


@pytest.mark.parametrize("elevation", [0.05, 0.4, 1.5])
def test_the_density_about_the_mirror_direction_is_that_of_visible_normals(elevation):
    """The density is that of visible half vectors, written the other way: D G1 / (4 n.o)."""
    n, wo = np.float32([[0, 0, 1]]), np.float32([[np.cos(elevation), 0.0, np.sin(elevation)]])
    alpha, k = 0.2, 5000
    mixture = LobeMixture(mirror=(Lobe(1.0, alpha),))
    wi = mixture.everywhere.sample(
        *tiled([n[0], n[0], wo[0]], k), np.random.default_rng(5).random((k, 2))
    )
    pdf = mixture.everywhere.pdf(*tiled([n[0], n[0], wo[0]], k), wi)
    h = np.float64(wi) + wo
    h /= np.linalg.norm(h, axis=1, keepdims=True)
    d = alpha**2 / (np.pi * (h[:, 2] ** 2 * (alpha**2 - 1.0) + 1.0) ** 2)
    up = float(wo[0, 2])
    g1 = 2.0 * up / (up + np.sqrt(alpha**2 + (1.0 - alpha**2) * up**2))
    np.testing.assert_allclose(pdf, d * g1 / (4.0 * up), rtol=1e-3)


def test_a_fiber_seen_along_its_tangent_is_sampled_too():
    """The cone of specular reflection is one direction there."""
    n, t = np.float32([1, 0, 0]), np.float32([0, 0, 1])
    wi = FIBER_LOBES.everywhere.sample(
        *tiled([n, t, t], N), np.random.default_rng(3).random((N, 3))
    )
    density = FIBER_LOBES.everywhere.pdf(*tiled([n, t, t], N), wi)
    assert np.isfinite(wi).all() and (density > 0).all()
    assert_directions_follow(wi, lambda w: FIBER_LOBES.everywhere.pdf(*tiled([n, t, t], len(w)), w))


def test_a_normal_and_a_tangent_of_no_length_are_no_trouble():
    none = np.zeros((2, 3), np.float32)
    wo = np.float32([[0, 0, 1], [0, 1, 0]])
    for mixture in MIXTURES.values():
        wi = mixture.everywhere.sample(
            none, none, wo, np.float64([[0, 0, 0], [1 - 1e-16, 0.5, 1 - 1e-16]])
        )
        np.testing.assert_allclose(np.linalg.norm(wi, axis=1), 1, atol=1e-6)
        pdf = mixture.everywhere.pdf(none, none, wo, wi)
        assert (pdf > 0).all() or mixture is MIXTURES["mirror"]  # whose rim has none


def test_points_spread_evenly_are_so_among_lobes():
    """The first number chooses the lobe and is used again there: 64 points of a net, one lobe's
    share of 0.25, and 16 of them there, whatever the seed."""
    mixture = LobeMixture(mirror=(Lobe(0.75, 0.002),))
    mirror = np.float32([[0, 0, 1]])
    for seed in range(8):
        points = Sampler(seed, 0).square(np.zeros(1, np.uint32), 1, 64)
        wi = mixture.everywhere.sample(*(np.tile(mirror, (64, 1)) for _ in range(3)), points)
        assert np.count_nonzero(wi @ mirror[0] < 0.99) in (15, 16)


def test_an_empty_batch_is_legal():
    none = np.zeros((0, 3), np.float32)
    assert SURFACE_LOBES.everywhere.sample(none, none, none, np.zeros((0, 3))).shape == (0, 3)


def test_rows_of_points_are_taken_as_they_come():
    rng = np.random.default_rng(4)
    at, row = [unit_vectors(rng, 40) for _ in range(3)], rng.integers(0, 40, 100)
    u, taken = rng.random((100, 3)), [values[row] for values in at]
    wi = FIBER_LOBES.everywhere.sample(*at, u, row)
    np.testing.assert_array_equal(wi, FIBER_LOBES.everywhere.sample(*taken, u))
    np.testing.assert_array_equal(
        FIBER_LOBES.everywhere.pdf(*at, wi, row), FIBER_LOBES.everywhere.pdf(*taken, wi)
    )

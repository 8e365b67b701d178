"""Directions for rays that leave assets: the plugin's samples follow its densities, which are
those of rna-run."""

import numpy as np
import pytest

from rna_render.world.neural_sampling import LobeMixture
from rna_sdk.package.manifest.extensions import (
    USUAL_SAMPLING,
    FiberLobe,
    MirrorLobe,
    Mixture,
)
from tests.render.chi_squared import assert_directions_follow
from tests.runtime.points import unit_vectors

N = 100_000
MIXTURES = {
    "cosine": Mixture(cosine=0.99),
    "mirror": Mixture(mirror=(MirrorLobe(share=0.99, width=0.3),)),
    "forward": Mixture(forward=FiberLobe(share=0.99, width=0.3)),
    "cone": Mixture(cone=(FiberLobe(share=0.99, width=0.1),)),
    "surfaces": Mixture(
        cosine=0.3,
        mirror=tuple(MirrorLobe(share=0.2, width=width) for width in (0.2, 0.3, 0.4)),
    ),
    "fibers": USUAL_SAMPLING["fiber"],
}


def vectors(values: np.ndarray):
    import mitsuba as mi

    return mi.Vector3f(*np.ascontiguousarray(values.T, np.float32))


def lobes(sampling: Mixture, axis: np.ndarray, wo: np.ndarray):
    from rna_mitsuba.lobes import Lobes, PointMixture

    kind = "fiber" if sampling.cone or sampling.forward else "surface"
    return Lobes(PointMixture.of(sampling, kind), vectors(axis), vectors(wo))


@pytest.mark.parametrize("name", MIXTURES)
def test_directions_follow_their_density(name):
    import mitsuba as mi

    axis, wo = unit_vectors(np.random.default_rng(1), 2)[:, None]
    at, rng = lobes(MIXTURES[name], axis, wo), np.random.default_rng(2)
    choice, u1, u2 = np.float32(rng.random((3, N)))
    wi = at.sample(mi.Float(choice), mi.Point2f(u1, u2))
    directions = np.array(wi).T

    def density(w: np.ndarray) -> np.ndarray:
        return np.array(at.pdf(vectors(w)))

    assert_directions_follow(directions, density)


@pytest.mark.parametrize("name", [*MIXTURES, "narrow"])
def test_densities_are_those_of_the_renderer(name):
    narrow = Mixture(mirror=(MirrorLobe(share=0.9, width=1e-3),))
    sampling, rng = MIXTURES.get(name, narrow), np.random.default_rng(3)
    axis, wo = unit_vectors(rng, 1000), unit_vectors(rng, 1000)
    mixture = LobeMixture.of(sampling).everywhere
    wi = mixture.sample(axis, axis, wo, rng.random((1000, 2)))
    expected = mixture.pdf(axis, axis, wo, wi)
    found = np.array(lobes(sampling, axis, wo).pdf(vectors(wi)))
    np.testing.assert_allclose(found, expected, rtol=2e-2 if name == "narrow" else 1e-3, atol=1e-6)

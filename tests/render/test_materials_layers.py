"""The clear coat and the weights of layers: energy, and reciprocity."""

import numpy as np
import pytest

from tests.render.test_materials_bsdf import (
    COATED,
    MATT,
    METAL,
    WEAK,
    WHITE_COATED,
    Z,
    at_angle,
    made_of,
    rows,
)
from tests.runtime.points import unit_vectors


def albedo(material, cosine, count=400_000) -> tuple[np.ndarray, np.ndarray]:
    """Albedo from samples, and its error."""
    points, n, wo = made_of(count, **material), rows(Z, count), at_angle(cosine, count)
    wi, pdf = points.sample_and_pdf(n, n, wo, np.random.default_rng(2).random((count, 3)))
    assert (pdf > 0).all()
    beta = points.evaluate(n, n, wo, wi).astype(np.float64) / pdf[:, None]
    assert beta.max() < 8  # the samples go where the light is
    return beta.mean(axis=0), beta.std(axis=0) / np.sqrt(count)


@pytest.mark.parametrize("cosine", [1.0, 0.6, 0.2, 0.05])
def test_white_furnace(cosine):
    """A white base below a clear coat returns all light except a part of the mirrors'."""
    for material, least in (
        (MATT, 0.995),
        (WHITE_COATED, 0.97),
        (METAL | {"base": (1, 1, 1)}, 0.7),
    ):
        actual, error = albedo(material, cosine)
        assert (actual < 1 + 4 * error + 2e-3).all()
        assert (actual > least - 4 * error).all()


def test_a_clear_coat_alone_is_a_dielectric_of_index_1_5():
    """On black, the clear coat is the coat of appendix B with F0 = 0.04."""
    rng = np.random.default_rng(3)
    wo, wi = abs(unit_vectors(rng, 500)), abs(unit_vectors(rng, 500))
    n = rows(Z, 500)
    black = {"base": (0, 0, 0)}
    coat = made_of(500, **black, alpha=0.2, coat_f0=0.04).evaluate(n, n, wo, wi)
    clear = made_of(500, **black, clear=1.0, clear_alpha=0.2).evaluate(n, n, wo, wi)
    half = made_of(500, **black, clear=0.5, clear_alpha=0.2).evaluate(n, n, wo, wi)
    np.testing.assert_allclose(clear, coat, rtol=1e-5)
    np.testing.assert_allclose(2 * half, coat, rtol=1e-5)


def test_weights_are_of_coat_and_diffuse_part():
    rng = np.random.default_rng(4)
    wo, wi = abs(unit_vectors(rng, 500)), abs(unit_vectors(rng, 500))
    n = rows(Z, 500)

    def evaluate(**material):
        return made_of(500, **material).evaluate(n, n, wo, wi).astype(np.float64)

    white, black = {"base": (1, 1, 1), "coat_f0": 0.04}, {"base": (0, 0, 0), "coat_f0": 0.04}
    np.testing.assert_allclose(evaluate(**black, coat_weight=0.3), 0.3 * evaluate(**black), 1e-5)
    diffuse = evaluate(**white) - evaluate(**black)
    actual = evaluate(**white, diffuse=0.4) - evaluate(**black)
    np.testing.assert_allclose(actual, 0.4 * diffuse, atol=2e-6)
    lambert = evaluate(**white, coat_weight=0.0)
    np.testing.assert_allclose(lambert, wi[:, 2:] / np.pi * np.ones(3), rtol=1e-5)


@pytest.mark.parametrize("material", [COATED, MATT, METAL, WEAK])
def test_reciprocity(material):
    rng = np.random.default_rng(1)
    wo, wi = unit_vectors(rng, 2000), unit_vectors(rng, 2000)
    wo[:, 2], wi[:, 2] = np.maximum(abs(wo[:, 2]), 0.05), np.maximum(abs(wi[:, 2]), 0.05)
    wo, wi = (w / np.linalg.norm(w, axis=1, keepdims=True) for w in (wo, wi))
    points, n = made_of(2000, **material), rows(Z, 2000)
    forward = points.evaluate(n, n, wo, wi) / wi[:, 2:]
    backward = points.evaluate(n, n, wi, wo) / wo[:, 2:]
    np.testing.assert_allclose(backward, forward, rtol=1e-4)

"""The clear coat and the weights of layers: energy, reciprocity, and samples of them."""

from __future__ import annotations

import numpy as np
import pytest

from rna_render.materials import Scattering
from rna_render.materials.scattering import ClearCoat
from tests.render.assets import unit_vectors
from tests.render.chi_squared import assert_directions_follow

Z = (0.0, 0.0, 1.0)
PAINT = {"base": (0.6, 0.1, 0.1), "coat_f0": 0.04, "clear": 1.0, "clear_alpha": 0.1}
WHITE = PAINT | {"base": (1.0, 1.0, 1.0)}
MATT = WHITE | {"coat_f0": 0.0, "clear_alpha": 0.4}
METAL = {"base": (1.0, 0.8, 0.3), "metallic": 1.0, "clear": 0.7, "clear_alpha": 0.05}
TILTED = PAINT | {"clear_n": (0.3, 0.0, 0.954)}
WEAK = {"base": (0.5, 0.5, 0.5), "coat_f0": 0.04, "coat_weight": 0.3, "diffuse": 0.4}
MATERIALS = [PAINT, MATT, METAL, TILTED, WEAK]


def made_of(n, base, alpha=0.3, metallic=0.0, coat_f0=0.0, **layers) -> Scattering:
    """n points of one material."""

    def full(value):
        return np.tile(np.float32(value), (n, 1)) if np.ndim(value) else np.full(n, value, "f4")

    weights = layers.get("coat_weight", 1.0), layers.get("diffuse", 1.0)
    coat = full(layers.get("clear", 0.0)), full(layers.get("clear_alpha", 0.1))
    clear = ClearCoat(*coat, full(layers.get("clear_n", Z)))
    factors = full(base), full(alpha), full(metallic), full(coat_f0), full((0, 0, 0))
    return Scattering(*factors, full(weights), clear)


def rows(vector, n) -> np.ndarray:
    return np.tile(np.float32(vector), (n, 1))


def at_angle(cosine, n) -> np.ndarray:
    return rows((np.sqrt(1 - cosine * cosine), 0, cosine), n)


def albedo(material, cosine, count=400_000) -> tuple[np.ndarray, np.ndarray]:
    """Of samples, and its error."""
    points, n, wo = made_of(count, **material), rows(Z, count), at_angle(cosine, count)
    wi = points.sample(n, n, wo, np.random.default_rng(2).random((count, 3)))
    pdf = points.pdf(n, n, wo, wi)
    assert (pdf > 0).all()
    beta = points.evaluate(n, n, wo, wi).astype(np.float64) / pdf[:, None]
    assert beta.max() < 8  # the samples go where the light is
    return beta.mean(axis=0), beta.std(axis=0) / np.sqrt(count)


@pytest.mark.parametrize("cosine", [1.0, 0.6, 0.2, 0.05])
def test_white_furnace(cosine):
    """What is white below a clear coat gives back all light but some of the mirrors'."""
    for material, least in ((MATT, 0.995), (WHITE, 0.97), (METAL | {"base": (1, 1, 1)}, 0.7)):
        found, error = albedo(material, cosine)
        assert (found < 1 + 4 * error + 2e-3).all()
        assert (found > least - 4 * error).all()


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
    found = evaluate(**white, diffuse=0.4) - evaluate(**black)
    np.testing.assert_allclose(found, 0.4 * diffuse, atol=2e-6)
    lambert = evaluate(**white, coat_weight=0.0)
    np.testing.assert_allclose(lambert, wi[:, 2:] / np.pi * np.ones(3), rtol=1e-5)


@pytest.mark.parametrize("material", [PAINT, MATT, METAL, WEAK])
def test_reciprocity(material):
    rng = np.random.default_rng(1)
    wo, wi = unit_vectors(rng, 2000), unit_vectors(rng, 2000)
    wo[:, 2], wi[:, 2] = np.maximum(abs(wo[:, 2]), 0.05), np.maximum(abs(wi[:, 2]), 0.05)
    wo, wi = (w / np.linalg.norm(w, axis=1, keepdims=True) for w in (wo, wi))
    points, n = made_of(2000, **material), rows(Z, 2000)
    forward = points.evaluate(n, n, wo, wi) / wi[:, 2:]
    backward = points.evaluate(n, n, wi, wo) / wo[:, 2:]
    np.testing.assert_allclose(backward, forward, rtol=1e-4)


@pytest.mark.parametrize("cosine", [1.0, 0.5, 0.1])
@pytest.mark.parametrize("material", MATERIALS)
def test_samples_follow_their_density(material, cosine):
    count = 100_000
    wo, n = at_angle(cosine, count), rows(Z, count)
    u = np.random.default_rng(4).random((count, 3))
    rough = material | {"clear_alpha": 0.3}
    wi = made_of(count, **rough).sample(n, n, wo, u)

    def density(d):
        n = rows(Z, len(d))
        return made_of(len(d), **rough).pdf(n, n, wo[: len(d)], d)

    assert_directions_follow(wi, density, axis=(0.0, 1.0, 0.0), integral_tolerance=1e-2)


@pytest.mark.parametrize("material", MATERIALS)
def test_odd_input_gives_finite_numbers(material):
    zero, x, z = (0, 0, 0), (1, 0, 0), Z
    cases = [(zero, z, x), (zero, zero, x), (x, z, z), (z, z, x), (z, z, (0, 0, -1)), (z, x, z)]
    n, ng, wo = (np.float32([case[k] for case in cases]) for k in range(3))
    points = made_of(len(n), **(material | {"clear_alpha": 0.0}))
    for value in (0.0, 0.5, 1 - 2.0**-53):
        wi = points.sample(n, ng, wo, np.full((len(n), 3), value))
        for direction in (wi, -wo, wo, n):
            assert np.isfinite(points.pdf(n, ng, wo, direction)).all()
            assert np.isfinite(points.evaluate(n, ng, wo, direction)).all()

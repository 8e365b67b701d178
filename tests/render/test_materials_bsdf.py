"""Reflection at meshes: the formulas, their energy, and samples of them."""

from itertools import product

import numpy as np
import pytest

from rna_render.materials import Scattering
from rna_render.materials.ggx import MIN_ALPHA, TABLE_SIZE
from rna_render.materials.ggx_albedo import ALBEDO_TABLE, albedo_terms
from rna_render.materials.ggx_quadrature import fill_albedo
from rna_render.materials.scattering import ClearCoat
from tests.render.chi_squared import assert_directions_follow
from tests.runtime.points import unit_vectors

LAMBERT = {"base": (0.8, 0.5, 0.2)}
GOLD = {"base": (1.0, 0.78, 0.34), "metallic": 1.0}
WHITE_METAL = {"base": (1.0, 1.0, 1.0), "metallic": 1.0}
PAINT = {"base": (0.6, 0.1, 0.1), "coat_f0": 0.04}
WHITE_PAINT = {"base": (1.0, 1.0, 1.0), "coat_f0": 0.04}
DIAMOND = {"base": (1.0, 1.0, 1.0), "coat_f0": 0.36}
HALF_METAL = {"base": (0.9, 0.5, 0.1), "metallic": 0.5, "coat_f0": 0.04}
MATERIALS = [LAMBERT, GOLD, PAINT, HALF_METAL]
COATED = PAINT | {"clear": 1.0, "clear_alpha": 0.1}
WHITE_COATED = COATED | {"base": (1.0, 1.0, 1.0)}
MATT = WHITE_COATED | {"coat_f0": 0.0, "clear_alpha": 0.4}
METAL = {"base": (1.0, 0.8, 0.3), "metallic": 1.0, "clear": 0.7, "clear_alpha": 0.05}
TILTED = COATED | {"clear_n": (0.3, 0.0, 0.954)}
WEAK = {"base": (0.5, 0.5, 0.5), "coat_f0": 0.04, "coat_weight": 0.3, "diffuse": 0.4}
LAYERED = [COATED, MATT, METAL, TILTED, WEAK]
ALPHAS = [MIN_ALPHA, 0.01, 0.1, 0.5, 1.0]
COSINES = [1.0, 0.7, 0.2, 0.03]
Z = (0.0, 0.0, 1.0)


def made_of(n, base, alpha=0.3, metallic=0.0, coat_f0=0.0, **layers) -> Scattering:
    """n points of one material."""

    def full(value):
        return np.tile(np.float32(value), (n, 1)) if np.ndim(value) else np.full(n, value, "f4")

    factors = full(base), full(alpha), full(metallic), full(coat_f0), full((0, 0, 0))
    if not layers:
        return Scattering(*factors)
    weights = layers.get("coat_weight", 1.0), layers.get("diffuse", 1.0)
    coat = full(layers.get("clear", 0.0)), full(layers.get("clear_alpha", 0.1))
    clear = ClearCoat(*coat, full(layers.get("clear_n", Z)))
    return Scattering(*factors, full(weights), clear)


def rows(vector, n) -> np.ndarray:
    return np.tile(np.float32(vector), (n, 1))


def at_angle(cosine, n) -> np.ndarray:
    return rows((np.sqrt(1 - cosine * cosine), 0, cosine), n)


def evaluate(material, wo, wi, alpha=0.3, n=Z) -> np.ndarray:
    normal = rows(n, len(wi))
    return made_of(len(wi), alpha=alpha, **material).evaluate(normal, normal, wo, wi)


def specular_lobe(wo, wi, alpha) -> tuple[np.ndarray, np.ndarray]:
    """V D and (1 - wo.h)^5 in the words of glTF 2.0, appendix B, with its h about n = z."""
    h = wo.astype(np.float64) + wi
    h /= np.linalg.norm(h, axis=1, keepdims=True)
    nh, hv = h[:, 2], np.sum(h * wo, axis=1)
    nl, nv = wi[:, 2].astype(np.float64), wo[:, 2].astype(np.float64)
    a2 = np.float64(alpha) ** 2
    d = a2 / (np.pi * (nh**2 * (a2 - 1) + 1) ** 2)
    v = 0.5 / (nl * np.sqrt(nv**2 * (1 - a2) + a2) + nv * np.sqrt(nl**2 * (1 - a2) + a2))
    return v * d, (1 - hv) ** 5


def by_half_vectors(alpha, cosine, size=400):
    """Directions that resolve the lobe, and their solid angles; wo in the x-z plane."""
    t = np.pi / 2 * (np.arange(size) + 0.5) / size
    phi = 2 * np.pi * (np.arange(size) + 0.5) / size
    t, phi = (a.ravel() for a in np.meshgrid(t, phi, indexing="ij"))
    theta = np.arctan(alpha * np.tan(t))
    per_t = alpha / np.cos(t) ** 2 / (1 + (alpha * np.tan(t)) ** 2)
    h = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], 1)
    wo = at_angle(cosine, 1)[0].astype(np.float64)
    oh = h @ wo
    wi = 2 * oh[:, None] * h - wo
    weight = np.sin(theta) * per_t * (np.pi / 2 / size) * (2 * np.pi / size) * 4 * oh
    good = (oh > 0) & (wi[:, 2] > 0)
    return wi[good].astype(np.float32), weight[good]


def by_cosine(size=256):
    """Directions of equal projected solid angle, and their solid angles."""
    g = (np.arange(size) + 0.5) / size
    u, phi = (a.ravel() for a in np.meshgrid(g, 2 * np.pi * g, indexing="ij"))
    wi = np.stack([np.sqrt(u) * np.cos(phi), np.sqrt(u) * np.sin(phi), np.sqrt(1 - u)], axis=1)
    return wi.astype(np.float32), np.pi / len(wi) / wi[:, 2]


def albedo(material, alpha, cosine) -> np.ndarray:
    """By quadrature: the lobe of a black material, and the rest, each where it is smooth."""
    black, metallic = material | {"base": (0, 0, 0)}, material.get("metallic", 0)
    if metallic == 1:
        wi, weight = by_half_vectors(alpha, cosine)
        return weight @ evaluate(material, at_angle(cosine, len(wi)), wi, alpha)
    if metallic > 0:
        parts = (albedo(material | {"metallic": m}, alpha, cosine) for m in (0.0, 1.0))
        return np.array([1 - metallic, metallic]) @ np.array(list(parts))
    total = np.zeros(3)
    if material.get("coat_f0", 0) > 0:
        wi, weight = by_half_vectors(alpha, cosine)
        total += weight @ evaluate(black, at_angle(cosine, len(wi)), wi, alpha)
    wi, weight = by_cosine()
    wo = at_angle(cosine, len(wi))
    rest = evaluate(material, wo, wi, alpha).astype(np.float64) - evaluate(black, wo, wi, alpha)
    return total + weight @ rest


@pytest.mark.parametrize("alpha", [1e-3, 0.05, 0.4, 1.0])
@pytest.mark.parametrize("metallic", [0.0, 0.3, 1.0])
def test_metal_and_black_coat_are_those_of_gltf(alpha, metallic):
    rng = np.random.default_rng(3)
    wo, wi = unit_vectors(rng, 5000), unit_vectors(rng, 5000)
    mirror = rng.random(5000) < 0.5  # half of them in the lobe
    wi[mirror] = wo[mirror] * (-1, -1, 1) + alpha * rng.normal(size=(mirror.sum(), 3))
    wi /= np.linalg.norm(wi, axis=1, keepdims=True)
    wo[:, 2], wi[:, 2] = np.maximum(abs(wo[:, 2]), 1e-3), abs(wi[:, 2])
    wo /= np.linalg.norm(wo, axis=1, keepdims=True)
    base, f0 = np.array([0.9, 0.6, 0.0]), 0.04
    surface, s = (a[:, None] for a in specular_lobe(wo, wi, alpha))
    metal = surface * (base + (1 - base) * s)
    coat = surface * (f0 + (1 - f0) * s)
    expected = metallic * metal + (1 - metallic) * coat
    material = {"base": base, "metallic": metallic, "coat_f0": f0}
    actual = evaluate(material, wo, wi, alpha).astype(np.float64) / wi[:, 2:]
    # Blue is black, so its dielectric is the coat alone; red and green have the diffuse part too.
    # What float32 directions make of so narrow a lobe.
    rtol = 2e-3 if alpha < 0.01 else 1e-4
    np.testing.assert_allclose(actual[:, 2], expected[:, 2], rtol=rtol, atol=1e-9)
    diffuse = actual - expected
    limit = rtol * expected[:, :2] + 1e-4
    assert (diffuse[:, :2] >= -limit).all()
    if metallic == 1:
        assert (np.abs(diffuse[:, :2]) <= limit).all()


def test_one_value_by_hand():
    """wo = n, wi at 60 degrees, alpha 0.5: h at 30 degrees, and every term on paper."""
    a2, nl, nh, f = 0.25, 0.5, np.sqrt(3) / 2, 0.04
    d = a2 / (np.pi * (0.75 * (a2 - 1) + 1) ** 2)
    v = 0.5 / (nl * 1.0 + 1.0 * np.sqrt(nl**2 * 0.75 + a2))
    expected = v * d * (f + (1 - f) * (1 - nh) ** 5) * nl
    wi = rows((np.sqrt(3) / 2, 0, 0.5), 1)
    black = {"base": (0, 0, 0), "coat_f0": f}
    assert evaluate(black, rows(Z, 1), wi, 0.5)[0] == pytest.approx([expected] * 3, rel=1e-5)


def test_below_the_coat_is_what_it_lets_through():
    """The diffuse part against albedos of the coat by quadrature, instead of the table."""
    alpha, cos_o, cos_i = 0.3, 0.4, 0.8
    coat = {"base": (0, 0, 0), "coat_f0": 0.1}

    def reflected(cosine):
        return albedo(coat, alpha, cosine)[0]

    nodes, weights = np.polynomial.legendre.leggauss(12)
    mu = (nodes + 1) / 2
    mean = sum(w * m * reflected(m) for m, w in zip(mu, weights, strict=True))
    expected = (1 - reflected(cos_o)) * (1 - reflected(cos_i)) / (1 - mean) / np.pi
    wo, wi = at_angle(cos_o, 1), at_angle(cos_i, 1) * np.float32([-1, 1, 1])
    lit = evaluate(coat | {"base": (1, 1, 1)}, wo, wi, alpha) - evaluate(coat, wo, wi, alpha)
    assert lit[0, 0] / cos_i == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("cosine", [1.0, 0.6, 0.2, 0.05, 0.01])
@pytest.mark.parametrize("alpha", ALPHAS)
def test_table_of_albedos_is_the_integral(alpha, cosine):
    expected = albedo({"base": (0, 0.5, 1), "metallic": 1.0}, alpha, cosine)
    a, b = albedo_terms(ALBEDO_TABLE, alpha, cosine)
    np.testing.assert_allclose([b, 0.5 * a + b, a + b], expected, atol=1.5e-3)


def test_table_of_albedos_is_that_of_its_quadrature():
    actual = np.empty((TABLE_SIZE, TABLE_SIZE, 2))
    fill_albedo(actual)
    np.testing.assert_allclose(ALBEDO_TABLE, actual, atol=1e-6)


@pytest.mark.parametrize("material", [*MATERIALS, DIAMOND])
@pytest.mark.parametrize("alpha", ALPHAS)
def test_reciprocity(material, alpha):
    rng = np.random.default_rng(1)
    wo, wi = unit_vectors(rng, 2000), unit_vectors(rng, 2000)
    wo[:, 2], wi[:, 2] = np.maximum(abs(wo[:, 2]), 0.01), np.maximum(abs(wi[:, 2]), 0.01)
    wo, wi = (w / np.linalg.norm(w, axis=1, keepdims=True) for w in (wo, wi))
    forward = evaluate(material, wo, wi, alpha) / wi[:, 2:]
    np.testing.assert_allclose(evaluate(material, wi, wo, alpha) / wo[:, 2:], forward, rtol=1e-4)


@pytest.mark.parametrize("cosine", COSINES)
@pytest.mark.parametrize("alpha", ALPHAS)
def test_white_furnace(alpha, cosine):
    """White paint gives back all light; metal loses some between its facets; Lambert is exact."""
    for paint in (WHITE_PAINT, DIAMOND):
        assert albedo(paint, alpha, cosine) == pytest.approx(1.0, abs=1e-3)
    assert albedo(WHITE_METAL, alpha, cosine).max() <= 1 + 1e-3
    # The roughest surface loses 69 % of the light along its normal: one bounce is all there is.
    assert albedo(WHITE_METAL, alpha, cosine).min() > (0.94 if alpha <= 0.01 else 0.3)
    for material in (GOLD, PAINT, HALF_METAL):
        actual = albedo(material, alpha, cosine)
        assert (actual > 0).all() and actual.max() <= 1 + 1e-3


def test_lambert_is_its_color():
    actual = albedo(LAMBERT, 0.3, 0.5)
    np.testing.assert_allclose(actual, LAMBERT["base"], rtol=1e-5)
    wo, wi = at_angle(0.2, 1), at_angle(0.9, 1)
    expected = np.array(LAMBERT["base"]) / np.pi * 0.9
    np.testing.assert_allclose(evaluate(LAMBERT, wo, wi)[0], expected, rtol=1e-5)


@pytest.mark.parametrize("cosine", COSINES)
@pytest.mark.parametrize("alpha", ALPHAS)
@pytest.mark.parametrize("material", MATERIALS)
def test_energy_of_samples_is_the_integral(material, alpha, cosine):
    count = 40_000
    points, n, wo = made_of(count, alpha=alpha, **material), rows(Z, count), at_angle(cosine, count)
    wi, pdf = points.sample_and_pdf(n, n, wo, np.random.default_rng(2).random((count, 3)))
    assert (pdf > 0).all()
    beta = points.evaluate(n, n, wo, wi).astype(np.float64) / pdf[:, None]
    error = 5 * beta.std(axis=0) / np.sqrt(count) + 1e-3
    assert (np.abs(beta.mean(axis=0) - albedo(material, alpha, cosine)) < error).all()
    assert beta.max() < 4  # the samples go where the light is


@pytest.mark.parametrize("cosine", [1.0, 0.5, 0.1])
@pytest.mark.parametrize(
    ("material", "alpha"),
    [*product(MATERIALS, (0.15, 0.4, 1.0)), *((m | {"clear_alpha": 0.3}, 0.3) for m in LAYERED)],
)
def test_samples_follow_their_density(material, alpha, cosine):
    count = 100_000
    wo = at_angle(cosine, count)
    n = rows(Z, count)
    u = np.random.default_rng(4).random((count, 3))
    wi, _ = made_of(count, alpha=alpha, **material).sample_and_pdf(n, n, wo, u)

    def density(d):
        n = rows(Z, len(d))
        return made_of(len(d), alpha=alpha, **material).evaluate_and_pdf(n, n, wo[: len(d)], d)[1]

    # Seen from the side, no lobe is at the pole of the cells.
    assert_directions_follow(wi, density, axis=(0.0, 1.0, 0.0), integral_tolerance=1e-2)


@pytest.mark.parametrize("alpha", [MIN_ALPHA, 0.01])
def test_narrow_lobes_follow_ggx(alpha):
    """Half vectors seen from above: tan^2 = alpha^2 u / (1 - u), Walter et al., equation 35."""
    count = 50_000
    n = rows(Z, count)
    u = np.random.default_rng(6).random((count, 3))
    points = made_of(count, alpha=alpha, **WHITE_METAL)
    wi, density = points.sample_and_pdf(n, n, n, u)
    h = wi.astype(np.float64) + Z
    tan2 = (h[:, 0] ** 2 + h[:, 1] ** 2) / h[:, 2] ** 2
    uniform = np.sort(tan2 / (tan2 + alpha**2))
    steps = (np.arange(count) + 0.5) / count
    assert np.abs(uniform - steps).max() < 1.95 / np.sqrt(count)  # Kolmogorov-Smirnov, 0.1 %
    # The density of directions is D n.h / (4 wo.h), and here n.h = wo.h.
    lobe = alpha**2 / (np.pi * (1 / (1 + tan2) * (alpha**2 - 1) + 1) ** 2) / 4
    np.testing.assert_allclose(density, lobe, rtol=2e-3)


@pytest.mark.parametrize("material", MATERIALS)
def test_nothing_passes_through(material):
    wo, below = at_angle(0.5, 1), rows((0.6, 0, -0.8), 1)
    assert not evaluate(material, wo, below).any()
    # In front of the shading normal, but behind the surface; and the other way round.
    n, ng = rows((0.8, 0, 0.6), 1), rows(Z, 1)
    wi = rows((0.96, 0, -0.28), 1)
    assert not made_of(1, **material).evaluate(n, ng, wo, wi).any()
    wi = rows((-0.96, 0, 0.28), 1)
    assert not made_of(1, **material).evaluate(n, ng, wo, wi).any()
    wi = rows(Z, 1)
    assert made_of(1, **material).evaluate(n, ng, wo, wi).all()


@pytest.mark.parametrize("material", MATERIALS)
def test_both_sides_are_alike(material):
    rng = np.random.default_rng(7)
    n, ng, wo, wi = (unit_vectors(rng, 500) for _ in range(4))
    u, points = rng.random((500, 3)), made_of(500, **material)
    for turned in ((-n, -ng), (n, -ng), (-n, ng)):
        for method, last in ((points.evaluate_and_pdf, wi), (points.sample_and_pdf, u)):
            for one, other in zip(method(*turned, wo, last), method(n, ng, wo, last), strict=True):
                np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("material", MATERIALS)
def test_shading_normals_that_face_away_still_see_light(material):
    """At a silhouette: the surface faces the viewer, its interpolated normal just does not."""
    n, ng, wo = rows((0.0, 0, 1.0), 100), rows((0.3, 0, 0.954), 100), at_angle(0.0, 100)
    wo[:, 2] = -0.1
    wo /= np.linalg.norm(wo, axis=1, keepdims=True)
    points = made_of(100, **material)
    wi, pdf = points.sample_and_pdf(n, ng, wo, np.random.default_rng(0).random((100, 3)))
    beta = points.evaluate(n, ng, wo, wi) / pdf[:, None]
    assert np.isfinite(beta).all() and beta.max() < 4
    assert (beta.max(axis=1) > 0).mean() > 0.4


def test_odd_input_gives_finite_numbers():
    """No normals, normals along the surface, wi against wo, wo in the surface, black, alpha 0."""
    zero, x, z = (0, 0, 0), (1, 0, 0), Z
    cases = [(zero, z, x), (zero, zero, x), (x, z, z), (z, z, x), (z, z, (0, 0, -1)), (z, x, z)]
    n, ng, wo = (np.float32([case[k] for case in cases]) for k in range(3))
    factors = (0, 0, 0), (1, 0, 0), (0, 0.04, 0), (0.5, 0.36, 1)
    plain = [
        {"base": base, "metallic": metallic, "coat_f0": coat_f0, "alpha": alpha}
        for base in ((0, 0, 0), (1, 1, 1))
        for metallic, coat_f0, alpha in factors
    ]
    for material in (*plain, *(layered | {"clear_alpha": 0.0} for layered in LAYERED)):
        points = made_of(len(n), **material)
        for value in (0.0, 0.5, 1 - 2.0**-53):
            wi, _ = points.sample_and_pdf(n, ng, wo, np.full((len(n), 3), value))
            np.testing.assert_allclose(np.linalg.norm(wi, axis=1), 1, atol=1e-6)
            for direction in (wi, -wo, wo, n):
                for actual in points.evaluate_and_pdf(n, ng, wo, direction):
                    assert np.isfinite(actual).all()


def test_points_are_on_their_own():
    """Results do not depend on the other points of a batch; no points are legal."""
    rng = np.random.default_rng(8)
    n, wo, u = unit_vectors(rng, 300), unit_vectors(rng, 300), rng.random((300, 3))
    points = Scattering(
        base_color=rng.random((300, 3)).astype(np.float32),
        alpha=rng.random(300).astype(np.float32),
        metallic=rng.random(300).astype(np.float32),
        coat_f0=rng.random(300).astype(np.float32) * np.float32(0.3),
        emission=np.zeros((300, 3), np.float32),
    )
    wi, pdf = points.sample_and_pdf(n, n, wo, u)
    full = points.evaluate(n, n, wo, wi)
    for row in (np.array([5, 299, 5]), np.arange(0, 300, 3), np.array([], np.int64)):
        sampled, density = points.sample_and_pdf(n, n, wo, u[row], row)
        np.testing.assert_array_equal(sampled, wi[row])
        np.testing.assert_array_equal(density, pdf[row])
        np.testing.assert_array_equal(points.evaluate(n, n, wo, wi[row], row), full[row])


@pytest.mark.parametrize("material", [*MATERIALS, *LAYERED])
def test_values_and_densities_are_those_of_each_alone(material):
    rng = np.random.default_rng(8)
    n, ng, wo, wi = (unit_vectors(rng, 500) for _ in range(4))
    u, points, row = rng.random((500, 3)), made_of(500, **material), rng.permutation(500)
    value, _ = points.evaluate_and_pdf(n, ng, wo, wi, row)
    np.testing.assert_array_equal(value, points.evaluate(n, ng, wo, wi, row))
    sampled, density = points.sample_and_pdf(n, ng, wo, u, row)
    np.testing.assert_array_equal(density, points.evaluate_and_pdf(n, ng, wo, sampled, row)[1])

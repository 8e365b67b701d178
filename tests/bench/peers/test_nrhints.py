"""Facts of NRHints: sizes, initialisation, weights of its volume rendering, hints, losses."""

import math

import numpy as np
import pytest
import torch
from torch import Tensor
from torch.nn.functional import normalize

from rna_bench.peers.learned_method import Targets
from rna_bench.peers.methods import METHODS, Setting
from rna_bench.peers.neus import importance_samples, inverse_cdf, opacities, transmittances
from rna_bench.peers.nrhints.hints import ROUGHNESSES, highlights, visibilities
from rna_bench.peers.nrhints.networks import COLOUR_INPUTS
from rna_bench.peers.nrhints.nrhints import (
    ANNEALED,
    FULL,
    REDUCED,
    WARM_UP,
    GeometryLosses,
    NRHints,
)
from rna_bench.peers.sphere.lambert_sphere import sphere_views

RADIUS = 0.6


@pytest.fixture(scope="module")
def method():
    return NRHints(Setting())


def count(module: torch.nn.Module) -> int:
    return sum(p.numel() for p in module.parameters())


def ball(points: Tensor) -> Tensor:
    return points.norm(dim=1) - RADIUS


def ball_field(points: Tensor) -> tuple[Tensor, Tensor]:
    return ball(points), normalize(points, dim=1)


def directions(n: int) -> Tensor:
    return normalize(torch.randn(n, 3, generator=torch.Generator().manual_seed(0)), dim=1)


def test_networks_have_the_published_sizes(method):
    assert count(method.model.distance) / 1e6 == pytest.approx(0.53, abs=0.005)
    assert count(method.model.colour) / 1e6 == pytest.approx(0.29, abs=0.005)
    first = method.model.colour.layers[0]
    assert first.weight.shape == (256, COLOUR_INPUTS) and COLOUR_INPUTS == 361
    encoded, *_, last = method.model.distance.layers
    assert encoded.weight.shape == (256, 39) and last.weight.shape == (257, 256)
    assert method.parameter_count == count(method.model.distance) + count(method.model.colour) + 1


def test_the_distance_starts_as_that_of_a_sphere(method):
    towards = directions(400)
    actual = {r: method.model.distance.distance(r * towards).detach() for r in (0.0, 0.3, 0.5, 0.9)}
    assert actual[0.5].mean() == pytest.approx(0.0, abs=0.05)
    assert (actual[0.0] < 0).all() and (actual[0.3] < 0).all() and (actual[0.9] > 0).all()
    _, gradient, _ = method.model.distance.with_gradient(0.5 * towards, create_graph=False)
    assert (normalize(gradient, dim=1) * towards).sum(dim=1).mean() > 0.95
    assert gradient.norm(dim=1).mean() == pytest.approx(1.0, abs=0.1)
    assert float(method.model.sharpness.detach()) == pytest.approx(math.exp(3.0))


def test_weights_of_a_plane_are_in_closed_form():
    """Transmittance is sigmoid(s f(t)) over that at the first place, of the distance f."""
    edges = torch.linspace(0.0, 2.0, 33)[None]
    cosine, sharpness = -0.6, torch.tensor(40.0)
    lengths = edges.diff(dim=1)
    middle = edges[:, :-1] + 0.5 * lengths
    distance = -cosine * (1.1 - middle)
    opacity = opacities(distance, torch.full_like(middle, cosine), lengths, sharpness, 1.0)
    through = torch.sigmoid(-cosine * (1.1 - edges) * sharpness)[0]
    expected = (through[:-1] - through[1:]) / through[0]
    weights = (opacity * transmittances(opacity))[0]
    np.testing.assert_allclose(weights, expected, atol=2e-4)
    assert weights.sum() == pytest.approx(1.0, abs=1e-3)
    away = opacities(-distance, torch.full_like(middle, 0.6), lengths, sharpness, 1.0)
    outside = -distance > 0.0
    assert away[outside].max() < 1e-4  # a back face has no weight ...
    half = opacities(-distance, torch.full_like(middle, 0.6), lengths, sharpness, 0.0)
    assert half[outside].max() > 0.05  # ... but before annealing


def test_importance_samples_gather_at_the_surface():
    origins, forward = torch.tensor([[0.0, 0.0, 4.0]]), torch.tensor([[0.0, 0.0, -1.0]])
    even = torch.linspace(3.0, 5.0, 64)[None]
    places = importance_samples(origins, forward, even, 64, ball)
    assert places.shape == (1, 128) and (places.diff(dim=1) >= 0).all()
    near = (places - (4.0 - RADIUS)).abs() < 0.05
    assert near.sum() > 64 / 2 > (even - 3.4).abs().lt(0.05).sum() * 8
    edges, weights = torch.tensor([[0.0, 1.0, 2.0]]), torch.tensor([[1.0, 3.0]])
    expected = [0.0, 1.0, 4 / 3, 5 / 3, 2.0]
    np.testing.assert_allclose(inverse_cdf(edges, weights, 5)[0], expected, atol=1e-4)


def test_visibility_is_the_transmittance_from_the_light():
    towards = torch.tensor([[0.0, 0.0, 1.0]])
    light, sharpness = 4.0 * towards, torch.tensor(30.0)
    ends = RADIUS * torch.cat([towards, -towards, -0.5 * towards])
    actual = visibilities(light.expand(3, 3), ends, ball, ball_field, sharpness, 1.0, (64, 64))[
        :, 0
    ]
    left = 0.01 * (4.0 - RADIUS)  # of the way, before the point
    expected = torch.sigmoid(sharpness * left) / torch.sigmoid(sharpness * (4.0 - RADIUS))
    assert actual[0] == pytest.approx(float(expected), abs=0.02)
    assert actual[1] < 1e-3 and actual[2] < 1e-3  # behind the ball, and inside it
    beside = visibilities(
        light, torch.tensor([[1.0, 0.0, 0.0]]), ball, ball_field, sharpness, 1.0, (64, 64)
    )
    assert beside[0, 0] > 0.98
    few = REDUCED.light
    near = visibilities(
        light.expand(3, 3),
        ends,
        ball,
        ball_field,
        10 * sharpness,
        1.0,
        few,
        None,
        REDUCED.light_near,
    )
    assert near[0, 0] > 0.98 and near[1:].max() < 1e-3


def test_highlights_are_the_ggx_term():
    n = torch.tensor([[0.0, 0.0, 1.0]])
    along = highlights(n, n, n)[0]
    expected = [0.04 / (math.pi * r**2 * 4.001) for r in ROUGHNESSES]
    np.testing.assert_allclose(along, expected, rtol=1e-4)
    assert ROUGHNESSES == (0.02, 0.05, 0.13, 0.34)
    v, ll = (np.array([math.sin(a), 0.0, math.cos(a)]) for a in (0.5, -0.3))
    h = (v + ll) / np.linalg.norm(v + ll)
    k = 1.34**2 / 8
    shade = math.prod(c / (c * (1 - k) + k) for c in (v[2], ll[2]))
    density = 0.34**2 / (math.pi * (h[2] ** 2 * (0.34**2 - 1) + 1) ** 2)
    fresnel = 0.04 + 0.96 * (1 - h @ v) ** 5
    term = density * shade * fresnel / (4 * v[2] + 1e-3)
    rows = [torch.tensor(w[None], dtype=torch.float32) for w in (v, ll)]
    assert highlights(n, *rows)[0, 3] == pytest.approx(term, rel=1e-4)
    assert (highlights(n, n, -n) == 0).all()


def test_the_schedule_is_the_published_one(method):
    row = METHODS["nrhints"]
    assert (row.published_steps, row.published_batch) == (1_000_000, 512)
    assert FULL.ray == FULL.light == (64, 64) and FULL.batch == 512
    assert (WARM_UP, ANNEALED * row.published_steps) == (5_000, 50_000)
    at = [(0.0, 0), (0.0025, 2_500), (0.005, 5_000), (1.0, 1_000_000)]
    factors = [method.rate * method.rate_factor(*place) for place in at]
    assert factors == pytest.approx([0.0, 2.5e-4, 5e-4, 2.5e-5], rel=1e-3)


def test_losses_of_geometry_are_added_with_their_weights(method):
    views = sphere_views(2, 16)
    targets = Targets.of(views.batch(np.arange(100, 160, 7)), method.device)
    assert targets.depth is not None

    def loss(geometry: GeometryLosses | None) -> float:
        method.geometry = geometry
        method.generator.manual_seed(3)
        return float(method.loss(targets, 1.0).detach())

    try:
        bare, both, low = (loss(g) for g in (None, GeometryLosses(1, 1), GeometryLosses(0.1, 0.1)))
        assert both - bare == pytest.approx(10 * (low - bare), rel=1e-3) and both > bare + 0.05
    finally:
        method.geometry = None


def test_a_black_ray_past_everything_costs_nothing(method):
    views = sphere_views(1, 6)
    image = method.render(views.camera(0), views.lights[0])
    assert image.shape == (6, 6, 3) and image[0, 0].max() < 0.05 < image[3, 3].max()

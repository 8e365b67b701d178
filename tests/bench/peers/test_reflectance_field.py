"""Neural Reflectance Fields: its network, transmittance, relighting and single bounce."""

import math

import numpy as np
import pytest
import torch

from rna_bench.peers.fields.field_network import FieldNetwork
from rna_bench.peers.fields.light_volume import LightVolume, transmittances
from rna_bench.peers.fields.reflectance_field import (
    Sampling,
    make,
    make_of_fur,
    sections,
    single_bounce,
)
from rna_bench.peers.kajiya_kay import HairMaterial, hair_radiance
from rna_bench.peers.learned_method import Rays
from rna_bench.peers.method import Budget
from rna_bench.peers.methods import Setting
from rna_bench.peers.views import PeerCamera, Views
from rna_sdk.errors import TrainingError

PEAK, SPREAD = 4.0, 0.25
"""Peak and spread of a Gaussian density about the centre."""
LIGHT = torch.tensor([3.0, 2.0, -2.0])


def gaussian(points: torch.Tensor) -> torch.Tensor:
    return PEAK * torch.exp(-points.square().sum(dim=1) / (2.0 * SPREAD**2))


def transmittance_through_gaussian(start: torch.Tensor, end: torch.Tensor) -> torch.Tensor:
    """Closed form between points (k, 3)."""
    way = end - start
    length = way.norm(dim=1)
    along = -(start * way).sum(dim=1) / length
    offset = (start + along[:, None] * way / length[:, None]).square().sum(dim=1)
    ends = (torch.erf((x - along) / (SPREAD * math.sqrt(2.0))) for x in (length, 0.0 * length))
    width = SPREAD * math.sqrt(math.pi / 2.0)
    depth = PEAK * torch.exp(-offset / (2.0 * SPREAD**2)) * width * (next(ends) - next(ends))
    return torch.exp(-depth)


def test_network_has_its_published_size():
    encoded, hidden = 63 * 256 + 256, 256 * 256 + 256
    base = encoded + 13 * hidden + 2 * 63 * 256
    for made, outputs in ((make, 8), (make_of_fur, 11)):
        assert made(Setting()).parameter_count == base + 256 * outputs + outputs


def test_transmittance_of_the_field_is_its_quadrature():
    torch.manual_seed(0)
    field = FieldNetwork()
    with torch.no_grad():
        for layer in field.layers:
            layer.weight *= 1.6  # an untrained network is next to constant
        rays = Rays(torch.tensor([[0.0, 0.1, 4.0]]), torch.tensor([[0.0, 0.0, -1.0]]), LIGHT[None])
        coarse, fine = (torch.linspace(3.0, 5.0, n + 1)[None] for n in (300, 3000))
        actual = []
        for edges in (coarse, fine):
            points, lengths = sections(rays, edges)
            density = field(points.reshape(-1, 3)).density.reshape(lengths.shape)
            actual.append(transmittances(density, lengths)[0])
        depth = np.trapezoid(density[0], 0.5 * (edges[0, 1:] + edges[0, :-1]))
    assert density.std() > 0.02 * density.mean()
    assert float(actual[1][-1]) == pytest.approx(math.exp(-depth), rel=2e-3)
    assert torch.allclose(actual[0], actual[1][::10], rtol=5e-3)


def test_relighting_interpolates_the_transmittance_from_the_light():
    volume = LightVolume(gaussian, LIGHT, side=128, sections=128)
    points = torch.randn(2000, 3, generator=torch.Generator().manual_seed(1)) * 0.4
    points = points[points.norm(dim=1) < 0.99]
    exact = transmittance_through_gaussian(LIGHT.expand_as(points), points)
    assert exact.min() < 0.2 and exact.max() > 0.95
    assert float((volume.at(points) - exact).abs().max()) < 2e-3
    with pytest.raises(TrainingError, match=r"light at \(0.5, 0, 0\): found 0.5"):
        LightVolume(gaussian, torch.tensor([0.5, 0.0, 0.0]), 8, 8)


def test_collocated_light_is_weakened_twice():
    rays = Rays(4.0 * torch.eye(3)[:1], -torch.eye(3)[:1], 4.0 * torch.eye(3)[:1])
    points, lengths = sections(rays, torch.linspace(3.0, 5.0, 401)[None])
    density, white = gaussian(points[0])[None], torch.ones(1, 400, 3)
    tau = transmittance_through_gaussian(rays.origins.expand(401, 3), points_of_edges(rays))
    actual = single_bounce(white, density, lengths, None)
    weights = tau[:-1] ** 2 * (1.0 - tau[1:] / tau[:-1])
    assert torch.allclose(actual, weights.sum().expand(1, 3), rtol=2e-3)
    total = float(tau[-1])
    assert float(actual[0, 0]) == pytest.approx((1.0 - total**2) / 2.0, rel=2e-2)
    lit_as_seen = single_bounce(white, density, lengths, transmittances(density, lengths)[:, :-1])
    assert torch.equal(lit_as_seen, actual)
    unweakened = single_bounce(white, density, lengths, torch.ones_like(lengths))
    assert float(unweakened[0, 0]) == pytest.approx(1.0 - total, rel=1e-3)


def points_of_edges(rays: Rays) -> torch.Tensor:
    return rays.origins + rays.directions * torch.linspace(3.0, 5.0, 401)[:, None]


def views_of(light_aside: float) -> Views:
    to_world = np.tile(np.eye(4), (2, 1, 1))
    to_world[:, 2, 3] = 4.0
    lights = to_world[:, :3, 3] + [light_aside, 0.0, 0.0]
    rgba = np.random.default_rng(0).random((2, 6, 6, 4)).astype(np.float32)
    return Views(rgba, None, to_world, lights, fov_x=0.4)


def test_trains_on_collocated_views_alone_and_renders_both_lights(tmp_path, monkeypatch):
    small = Sampling((4, 4), 8, (8, 8))
    monkeypatch.setattr("rna_bench.peers.fields.reflectance_field.REDUCED", small)
    method, budget = make_of_fur(Setting()), Budget(60.0, 60.0, steps=2)
    with pytest.raises(TrainingError, match=r"view 0: found the light 0.5 from the camera"):
        method.train(views_of(0.5), budget, tmp_path)
    done = method.train(views_of(0.0), budget, tmp_path)
    assert done.samples == 16 and method.model.intensity == pytest.approx(math.pi * 16.0)
    camera = PeerCamera(views_of(0.0).to_world[0], 0.4, (5, 5))
    pictures = [method.render(camera, np.array(light)) for light in ([0, 0, 4], [3, 0, 3])]
    assert all(np.isfinite(p).all() and p.max() > 0 for p in pictures)
    assert not np.allclose(*pictures)


def test_a_diffuse_strand_sends_out_its_share():
    """Over a cylinder: power out = pi^2 diffuse of what arrives, for light from any inclination."""
    count = 500
    s = (torch.arange(count) + 0.5) / count * 2.0 - 1.0  # sine of wo to the tangent
    wo = torch.stack([torch.sqrt(1 - s**2), torch.zeros(count), s], dim=1)
    wi = torch.tensor([[0.8, 0.0, 0.6]]).expand_as(wo)
    one, none = torch.ones(1, 1), torch.zeros(1, 3)
    material = HairMaterial(torch.full((1, 3), 0.05), none, one)
    radiance = hair_radiance(material, torch.tensor([[0.0, 0.0, 1.0]]).expand_as(wo), wo, wi)
    out = 2.0 * 2.0 * math.pi * (radiance[:, 0] * torch.sqrt(1 - s**2)).mean()
    assert float(out) == pytest.approx(math.pi**2 * 0.05 * 0.8, rel=1e-3)
    mirror = HairMaterial(none, torch.full((1, 3), 0.7), 50.0 * one)
    shine = hair_radiance(mirror, torch.tensor([[0.0, 0.0, 1.0]]).expand_as(wo), wo, wi)[:, 0]
    assert float(shine.max()) == pytest.approx(0.7, rel=1e-2)
    assert float(s[shine.argmax()]) == pytest.approx(-0.6, abs=0.01)

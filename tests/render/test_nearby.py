"""Nearby light: closed forms, and the twin in numpy."""

import numpy as np
import pytest

from rna_render.world.bodies import make_body
from rna_sdk.package import Mesh
from rna_sdk.package import Transmittance as Record
from rna_sdk.runtime import load
from rna_trace import PartsScene, mesh_transmittance, nearby_light
from rna_trace.hit_points import Frames, Lines
from rna_trace.nearby import nearby_estimate
from rna_trace.points import Arrived
from tests.conftest import REPOSITORY
from tests.reference.nearby import across, nearby_offsets, nearby_shares

LENGTHS = (0.005, 0.015, 0.045)
DOWN = np.float32([[0, 1, 0]])  # light from above


def ground(height: float = 0.0, low: float = -10.0, texture: bool = False) -> Mesh:
    """A square from x = low to x = 10, with texture coordinates."""
    corners = np.float32(
        [[low, height, -10], [10, height, -10], [10, height, 10], [low, height, 10]]
    )
    up, uvs = np.tile(np.float32([0, 1, 0]), (4, 1)), np.float32([[0, 0], [1, 0], [1, 1], [0, 1]])
    triangles = np.uint32([[0, 2, 1], [0, 3, 2]])
    return Mesh(corners, up, uvs if texture else None, triangles)


def of_many_rays(scene: PartsScene, at: tuple[float, float, float], wi=DOWN) -> np.ndarray:
    x, to_light = (np.repeat(np.float32(v), 5000, axis=0) for v in ([at], wi))
    return nearby_light(scene, LENGTHS, x, to_light, rays=4).mean(axis=0)


def test_a_lit_plane_has_all_of_it():
    oblique = np.float32([[0.6, 0.8, 0.0]])
    assert of_many_rays(PartsScene([ground()]), (0, 0, 0)) == pytest.approx([1.0] * 3, rel=0.01)
    # The light of a plane that it grazes enters farther away: columns meet it at |y| > |d|.
    assert (of_many_rays(PartsScene([ground()]), (0, 0, 0), oblique) < 0.9).all()


@pytest.mark.parametrize("height", [0.02, -0.02])
def test_light_that_enters_farther_away_counts_by_distance(height):
    """The integral of exp(-r / l) / (2 pi l^2) over a plane h away is (1 + h / l) exp(-h / l)."""
    ratio = 0.02 / np.array(LENGTHS)
    expected = (1.0 + ratio) * np.exp(-ratio)
    assert of_many_rays(PartsScene([ground(height)]), (0, 0, 0)) == pytest.approx(
        expected, rel=0.02
    )


def test_half_a_plane_has_half_and_nothing_none():
    half = PartsScene([ground(low=0.0)])
    assert of_many_rays(half, (0, 0, 0)) == pytest.approx([0.5] * 3, rel=0.02)
    assert (of_many_rays(half, (-5, 0, 0)) == 0.0).all()


def test_columns_pass_what_lets_most_light_through():
    whole, expected = PartsScene([ground()]), of_many_rays(PartsScene([ground()]), (0, 0, 0))
    meshes = [ground(), ground(0.02, texture=True)]
    for level, passes in ((130, True), (120, False)):
        record = Record(0, 2, np.full((1, 1, 1), level, np.uint8), None, None)
        tables = [None, mesh_transmittance(meshes[1], [record])]
        found = of_many_rays(PartsScene(meshes, tables), (0, 0, 0))
        assert (found == pytest.approx(expected)) == passes
    assert not whole.transmits


def test_a_light_nearer_than_the_asset_begins_columns_there():
    scene = PartsScene([ground(), ground(1.0)])  # a lamp between floor and ceiling
    x, u = np.zeros((4000, 3), np.float32), np.random.default_rng(0).random((4000, 2))
    wi = np.repeat(DOWN, 4000, axis=0)
    near = nearby_estimate(scene, LENGTHS, x, wi, u, np.full(4000, 0.5, np.float32))
    assert near.mean(axis=0) == pytest.approx([1.0] * 3, rel=0.1)
    assert nearby_estimate(scene, LENGTHS, x, wi, u).max() < 1e-4


def test_an_estimate_is_that_of_the_reference():
    rng, scene, n = np.random.default_rng(1), PartsScene([ground(0.01)]), 500
    wi = rng.normal(size=(n, 3))
    wi[:, 1] = np.abs(wi[:, 1]) + 0.5
    wi = (wi / np.linalg.norm(wi, axis=1, keepdims=True)).astype(np.float32)
    x, u = (
        rng.uniform(-1, 1, (n, 3)).astype(np.float32) * np.float32([1, 0.02, 1]),
        rng.random((n, 2)),
    )
    u[:4, 0] = 0.0, 1e-8, 1.0 - 2.0**-24, 1.0
    rho, angle = nearby_offsets(LENGTHS, u)
    s, t = across(wi)
    aside = rho[:, None] * (np.cos(angle)[:, None] * s + np.sin(angle)[:, None] * t)
    column = x + aside
    y = column + wi * ((0.01 - column[:, 1]) / wi[:, 1])[:, None]
    expected = nearby_shares(LENGTHS, u, rho, np.linalg.norm(y - x, axis=1))
    found = nearby_estimate(scene, LENGTHS, x, wi, u)
    assert found == pytest.approx(expected, rel=2e-3, abs=1e-4)


@pytest.mark.parametrize(("name", "tier"), [("surface", "print"), ("fiber", "small")])
def test_one_ray_a_sample_gives_the_right_light_in_the_mean(name, tier):
    asset = load(REPOSITORY / f"spec/conformance/packages/{name}-nearby.rna", tier)
    body, n, rays = make_body(asset), 30, 600
    rng = np.random.default_rng(0)
    d = rng.normal(size=(4000, 3)).astype(np.float32)
    d /= np.linalg.norm(d, axis=1, keepdims=True)
    aside = rng.uniform(-0.3, 0.3, d.shape).astype(np.float32)
    origin = aside - 4 * d
    hits = body.scene.intersect(origin, d)
    ray = np.flatnonzero(hits.geometry == 0)[:n]
    assert body.counts_nearby and len(ray) == n
    at_rest = Frames(np.eye(3)[None], np.ones(1), np.zeros((1, 3)))
    lines = Lines(origin[ray], d[ray], np.zeros(n, np.int32), at_rest)
    points = body.points(0, Arrived(hits, ray, -d[ray], True, np.zeros(n, np.float32), lines))

    wi, far = d[-n:], np.full(n, np.inf, np.float32)
    lengths = asset.nearby_lengths
    s = nearby_light(body.scene, lengths, points.x, wi, 4 * rays, seed=1)
    place = np.repeat(np.arange(n), rays)
    every = wi[place], far[place], rng.random((n * rays, 2))
    light, _ = points.transport(place, *every)
    v = body.scene.visible(0, points._at, wi)
    expected = points._sent(np.arange(n), wi, v, s)
    assert (s.std(axis=0) > 0.02).all()
    assert light.reshape(n, rays, 3).mean(axis=1) == pytest.approx(expected, rel=0.15)
    mean = points._sent(np.arange(n), wi, v, None)
    assert np.abs(mean - expected).max() > 0.1 * expected.max()

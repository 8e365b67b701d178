"""Holes and thin glass of assets: the view through them, their shadows, their own light."""

from dataclasses import replace

import numpy as np
import pytest

from rna_sdk.package import Mesh
from rna_trace.asset_parts import part_transmittance
from rna_trace.embree import TriangleScene
from rna_trace.parts_scene import PartsScene
from tests.render.assets import FiberProbe, LambertAsset, sphere, square
from tests.render.glowing import Composite, Record, pane
from tests.render.stage import SKY, rgb
from tests.render.strands import straight
from tests.render.studio import assert_is, at_point, flat, made_of, seen, shoot
from tests.render.test_transport_interreflection import WIDE

WHITE = (1.0, 1.0, 1.0)
ALBEDO = (0.8, 0.5, 0.2)
TAU = np.rint(255 * np.array([0.2, 0.5, 0.8])) / 255
SUN = {"type": "directional", "direction": (0, 1, 0), "irradiance": (np.pi,) * 3}
WAYS = ["both", "lights", "rays"]


def window(size: float, height: float, colour=TAU, **changes) -> LambertAsset:
    mesh = square(size, height=height)
    return LambertAsset(mesh, transmittance_records=(pane(colour, 2),), **changes)


def test_a_pane_is_seen_and_seen_through():
    """The sun passes the pane, is scattered by the ground, and passes it once more."""
    objects = [(made_of(square(5.0)), {}), (window(3.0, 1.0), {})]
    camera = at_point((0.1, 1, 0.1), (0.2, 3.0, 0.3))
    actual = seen(shoot(objects, [SUN], camera=camera, samples=1024, max_depth=1))
    assert_is(actual, (1 - TAU) * ALBEDO + TAU * TAU, relative=0.02)


@pytest.mark.parametrize("way", WAYS)
def test_light_of_a_lamp_is_weakened_by_each_pane(way):
    """Two panes, of two assets, between a ground and a lamp; the camera is below them."""
    lamp = {"type": "sphere", "position": (0, 4, 0), "radius": 1.5, "radiance": WHITE}
    black = {"albedo": (0.0, 0.0, 0.0)}
    camera = {"camera": at_point((0, 0, 0), (0.3, 0.2, 2.0)), "max_depth": 1}
    panes = [(window(20.0, 1.0, **black), {}), (window(20.0, 2.0, **black), {})]
    samples = 200 if way == "rays" else 48
    actual = seen(shoot([(made_of(square(30.0)), {}), *panes], [lamp], way, samples=samples,
                       **camera))  # fmt: skip
    assert_is(actual, TAU * TAU * 1.5**2 / 4**2, relative=0.02)


@pytest.mark.parametrize("kind", ["surface", "fiber"])
def test_its_own_light_is_mixed_of_both_colours(kind):
    """A part below a pane of the same asset: v visible + (1 - v) shadowed."""
    shadowed = (3.0, 2.0, 1.0)
    if kind == "surface":
        part, visible, x = (
            LambertAsset(square(1.0), ALBEDO, shadowed),
            np.array(ALBEDO),
            (0, 0, 0.3),
        )
        visible = visible / np.pi
    else:
        strand = straight(((0, 0, -1), (0, 0, 1)))
        part, x = FiberProbe(strand, shadowed), (0, 0.1, 0.3)
        visible = np.array([1.0, 0.5, 1 / (4 * np.pi)])
    camera = {"camera": at_point(x, (0.0, 0.4, 3.0)), "max_depth": 1, "samples": 1}
    asset = Composite((part, window(2.0, 0.6)))
    actual = seen(shoot([(asset, {})], [SUN], **camera))
    expected = np.pi * (TAU * visible + (1 - TAU) * np.float64(shadowed))
    np.testing.assert_allclose(actual.mean, expected, rtol=0.003)
    channels = shoot([(asset, {})], [SUN], **camera)
    np.testing.assert_allclose(channels["visibility"], TAU.mean(), rtol=1e-5)


def test_transmitting_bodies_vanish_in_a_white_furnace():
    """Whatever passes, of whatever colour: what stops and what goes on are 1 together."""
    records = (Record(0, 200, _texels((0.9, 0.5, 0.1))), Record(200, 100, _texels((0.5,))))
    body = flat(sphere(2))
    ball = LambertAsset(body, albedo=WHITE, transmittance_records=records)
    objects = [(ball, {"translation": (-0.5, 0, 0)}), (ball, {"translation": (1.6, 0.2, 0)})]
    camera = {**WIDE, "vertical_fov_deg": 20}
    for way in WAYS:
        channels = shoot(objects, [SKY], way, camera=camera, samples=48, max_depth=32)
        image = rgb(channels)[channels["assetId"] > 0]
        error = image.std(axis=0) / np.sqrt(len(image))
        assert (error < 0.01).all()
        assert (np.abs(image.mean(axis=0) - 1) < 3.5 * error).all(), (way, image.mean(axis=0))


def _texels(colour) -> np.ndarray:
    return np.rint(255 * np.float64(colour)).astype(np.uint8).reshape(1, 1, -1)


def card(texels: np.ndarray, cutoff: float = 0.5) -> LambertAsset:
    """A square of half-side 1 that faces +Y, its texture spread over it once."""
    mesh = square(1.0)
    uvs = ((mesh.positions[:, [0, 2]] + 1) / 2).astype(np.float32)
    mesh = Mesh(mesh.positions, mesh.normals, uvs, mesh.triangles)
    return LambertAsset(mesh, transmittance_records=(Record(0, 2, texels, cutoff),))


FROM_ABOVE = {"position": (0, 50, 0), "look_at": (0, 0, 0), "up": (0, 0, -1)}


def test_a_cut_out_covers_what_its_texture_says():
    """A disc of opaque texels of radius 0.3 in a card of side 1 covers pi 0.09 of it."""
    side = 128
    x = (np.arange(side) + 0.5) / side - 0.5
    disc = np.hypot(*np.meshgrid(x, x)) < 0.3
    asset = card(np.where(disc, 0, 255).astype(np.uint8)[:, :, None])
    camera = FROM_ABOVE | {"vertical_fov_deg": 2 * np.degrees(np.arctan(1 / 50))}
    settings = {"camera": camera, "samples": 64, "resolution": (64, 64), "max_depth": 2}
    alpha = shoot([(asset, {})], [SUN], **settings)["A"]
    assert alpha.mean() == pytest.approx(np.pi * 0.09, rel=0.005)
    # Its shadow on the ground is the same disc; beside it the sun arrives.
    floor = made_of(square(1.0))
    lying = {"translation": (0, -0.5, 0)}
    shown = rgb(shoot([(asset, {}), (floor, lying)], [SUN], **settings | {"max_depth": 1}))
    np.testing.assert_allclose(
        shown.mean(axis=(0, 1)), np.pi * 0.09 * np.array(ALBEDO) + 1 - np.pi * 0.09, rtol=0.03
    )


def test_halves_of_a_cut_out_are_where_its_texels_are():
    """Two texels: bilinear lookup cuts at u = 1/2, and repeating at u = 0 and 1."""
    asset = card(np.uint8([[[255], [0]]]))
    camera = FROM_ABOVE | {"vertical_fov_deg": 2 * np.degrees(np.arctan(1 / 50))}
    settings = {"camera": camera, "samples": 4, "resolution": (16, 16), "max_depth": 1}
    alpha = shoot([(asset, {})], [SUN], **settings)["A"]
    np.testing.assert_array_equal(alpha[1:-1, 1:7], 0)
    np.testing.assert_array_equal(alpha[1:-1, 9:15], 1)


def test_visibility_is_the_product_of_all_parts():
    """Points of three parts: opaque triangles and strands make it 0, directions below do not."""
    first, second = window(1.0, 1.0), window(1.0, 2.0, colour=(0.5,))
    strand = straight(((0.5, 1.5, -1), (0.5, 1.5, 1)))
    low = square(1.0)
    scene = PartsScene(
        [low, first.mesh, second.mesh, strand],
        [None, part_transmittance(first), part_transmittance(second), None],
    )
    assert scene.transmits and scene.coloured
    up, none = np.float32([[0, 1, 0.01]]), np.zeros(1, np.float32)
    half = np.rint(127.5) / 255
    triangle = np.int32([0])

    def v(part, u1, v1, wi, tfar=np.inf):
        at = scene.points(part, triangle, np.float32([u1]), np.float32([v1]), up)
        return scene.visible(part, at, np.float32(wi), tfar)[0]

    # Triangle 0 is (-1, 1), (1, 1), (1, -1) in x and z: u and v go right and back.
    np.testing.assert_allclose(v(0, 0.2, 0.2, up), TAU * half, rtol=1e-6)
    np.testing.assert_allclose(v(0, 0.2, 0.2, up, 1.5), TAU, rtol=1e-6)
    np.testing.assert_allclose(v(0, 0.2, 0.2, -up), 1)
    np.testing.assert_allclose(v(1, 0.2, 0.2, up), half, rtol=1e-6)  # not its own pane
    np.testing.assert_allclose(v(1, 0.2, 0.2, -up), 0)
    np.testing.assert_allclose(v(0, 0.55, 0.2, up), 0)  # the strand
    at = scene.points(3, triangle, none + 0.5, none, np.float32([[0, 1, 0]]))
    np.testing.assert_allclose(scene.visible(3, at, up)[0], half, rtol=1e-6)
    hits = scene.intersect(np.float32([[0.1, 9, 0.1], [9, 9, 9]]), np.float32([[0, -1, 0]] * 2))
    tau = scene.hit_transmittance(hits, np.float32([[0, -1, 0]] * 2))
    np.testing.assert_allclose(tau, [[half] * 3, [1, 1, 1]], rtol=1e-6)


def bulged(mesh: Mesh) -> Mesh:
    """A square that faces +Y, shaded as a dome."""
    normals = mesh.normals + np.float32(0.3) * mesh.positions
    return replace(mesh, normals=normals / np.linalg.norm(normals, axis=1, keepdims=True))


def test_a_pane_weakens_light_behind_its_smooth_surface():
    """That light meets the pane that the point is on, if its triangle alone faces the light."""
    glass = window(1.0, 0.0)
    directions = {
        (-1, 0.1, 0): TAU,  # n.wi < 0 < n_g.wi
        (-0.1, 1, 0): 1.0,  # before the pane
        (-1, -0.1, 0): 1.0,  # behind it
        (1, -0.1, 0): 1.0,  # before the smooth surface, behind the triangle
    }
    wi = np.float32(list(directions))
    count = np.zeros(len(wi), np.float32)
    for table, blocks in ((part_transmittance(glass), TAU), (None, 0.0)):
        scene = PartsScene([bulged(glass.mesh)], [table])
        at = scene.points(0, count.astype(np.int32), count + 0.6, count + 0.3, wi)
        assert at.n[0] @ wi[0] < 0 < at.ng[0] @ wi[0] and at.n[3] @ wi[3] > 0 > at.ng[3] @ wi[3]
        actual = scene.visible(0, at, wi)
        expected = [blocks if v is TAU else v for v in directions.values()]
        for ours, v in zip(actual, expected, strict=True):
            np.testing.assert_allclose(ours, v, rtol=1e-6)


def test_opaque_assets_ask_no_filter():
    scene = PartsScene([square(), straight(((0, 0, 0), (0, 1, 0)))])
    assert not scene.transmits and part_transmittance(LambertAsset(square())) is None
    mesh = square()
    assert not TriangleScene([(mesh.positions, mesh.triangles)]).transmits
    at = scene.points(0, np.int32([0]), *np.float32([[0.1], [0.1]]), np.float32([[0, 1, 0]]))
    assert scene.visible(0, at, np.float32([[0, 1, 0]])).dtype == bool

"""Light through things that are there in part: coverage, cut-outs and thin glass."""

from dataclasses import replace

import numpy as np
import pytest

from rna_render.materials.material import Material
from rna_render.materials.textures import LINEAR, Texture
from rna_trace.bilinear import CLAMP
from tests.render.assets import sphere, square
from tests.render.stage import SKY, rgb
from tests.render.studio import assert_is, at_point, flat, made_of, seen, shoot

WAYS = ["both", "lights", "rays"]
WIDE = {"position": (0, 0, 4), "look_at": (0, 0, 0), "vertical_fov_deg": 40}
GLASS = {"coat_f0": 0.04, "roughness": 0.03, "transmission": 1.0}
TINT = np.array([0.8, 0.6, 0.2])
SUN = {"type": "directional", "direction": (0, 1, 0), "irradiance": (np.pi, np.pi, np.pi)}
LAMP = {
    "type": "rectangle",
    "position": (0, 3, 0),
    "look_at": (0, 0, 0),
    "up": (0, 0, 1),
    "size": (4, 4),
    "radiance": (3, 2, 1),
}
# From the side, below a pane at y = 1.
AT_FLOOR = at_point((0, 0, 0), (0.5, 0.4, 2.0))


@pytest.mark.parametrize(
    "material", [{"opacity": 0.4}, GLASS, GLASS | {"transmission": 0.5}], ids=str
)
@pytest.mark.parametrize("smooth", [False, True])
def test_white_things_vanish_in_a_white_furnace(material, smooth):
    ball = sphere(4) if smooth else flat(sphere(3))
    channels = shoot([(made_of(ball, **material), {})], [SKY], camera=WIDE, max_depth=64)
    assert rgb(channels).mean() == pytest.approx(1, abs=0.005)
    assert 0.05 < np.mean(channels["assetId"] > 0) < 0.9


@pytest.mark.parametrize("tint", [np.ones(3), TINT])
def test_a_pane_of_glass_before_the_sky(tint):
    """Transmitted and mirrored light at an angle: Schlick's share of a white sky."""
    pane = made_of(square(2.0), base_color=tuple(tint), **GLASS)
    camera = at_point((0, 0, 0), (0, 1.0, 1.0))
    actual = seen(shoot([(pane, {})], [SKY], camera=camera, max_depth=8, samples=64))
    reflected = 0.04 + 0.96 * (1 - np.sqrt(0.5)) ** 5
    assert_is(actual, reflected + (1 - reflected) * tint, relative=0.012)


def test_the_sun_through_coloured_glass():
    floor, pane = made_of(square(), base_color=(0.5, 0.5, 0.5)), square(1.0, height=1.0)
    glass = made_of(pane, base_color=tuple(TINT), **GLASS)
    actual = seen(shoot([(floor, {}), (glass, {})], [SUN], camera=AT_FLOOR, max_depth=1))
    assert_is(actual, 0.5 * 0.96 * np.rint(255 * TINT) / 255, relative=2e-3)


@pytest.mark.parametrize("way", WAYS)
def test_a_lamp_through_a_half_open_pane(way):
    """Found by samples of the lamp or by rays into it, it is weakened alike."""
    floor, pane = made_of(square(), base_color=(0.5, 0.5, 0.5)), square(9.0, height=1.0)
    scene = [(floor, {})]
    how = {"camera": AT_FLOOR, "max_depth": 1, "samples": 64}
    expected = seen(shoot(scene, [LAMP], "lights", **how)).mean
    scene.append((made_of(pane, opacity=0.6, base_color=(0, 0, 0)), {}))
    actual = seen(shoot(scene, [LAMP], way, **how | {"samples": 128}))
    assert_is(actual, 0.4 * expected, relative=0.012)


@pytest.mark.parametrize("way", WAYS)
def test_what_shines_in_part_lights_in_part(way):
    floor = made_of(square(), base_color=(0.5, 0.5, 0.5))
    shining, how = {"emission": (3, 2, 1), "base_color": (0, 0, 0)}, {"samples": 64}
    how |= {"camera": AT_FLOOR, "max_depth": 1}
    whole, part = (
        seen(
            shoot(
                [(floor, {}), (made_of(square(0.5, 1.0), opacity=share, **shining), {})],
                (),
                of,
                **how,
            )
        )
        for share, of in ((1.0, "lights"), (0.6, way))
    )
    assert_is(part, 0.6 * whole.mean, relative=0.01)


def test_a_cut_out_is_a_hole_for_every_ray():
    """Left half gone: the camera, the sun and the sky see through it, and alpha says so."""
    texels = np.repeat(np.uint8([[0, 0, 255, 255]])[..., None], 3, axis=2)
    mesh = square(1.0, height=1.0)
    mesh = replace(mesh, uvs=((mesh.positions[:, [0, 2]] + 1) / 2).astype(np.float32))
    image = Texture(texels, LINEAR, (CLAMP, CLAMP))
    cut = made_of(mesh, base_color=(0, 0, 0), opacity_texture=image, cutoff=0.5)
    floor = made_of(square(), base_color=(0.5, 0.5, 0.5))
    for x, expected in ((-0.4, 0.5), (0.4, 0.0)):
        how = {"max_depth": 1, "samples": 2}
        side = at_point((x, 0, 0), (x, 0.4, 2.0))
        lit = shoot([(floor, {}), (cut, {})], [SUN], camera=side, **how)
        assert rgb(lit).mean() == pytest.approx(expected, abs=1e-5)
        above = shoot([(cut, {})], (), camera=at_point((x, 1, 0), (x, 3, 0.1)), **how)
        assert above["A"].mean() == (0.0 if x < 0 else 1.0)


def test_shadows_of_what_is_there_in_part():
    catcher = made_of(square(), catches_shadows=True)
    leaf = made_of(square(1.0, height=1.0), opacity=0.6)
    actual = shoot([(catcher, {}), (leaf, {})], [SUN], camera=AT_FLOOR, samples=2)
    assert actual["A"].mean() == pytest.approx(0.6, abs=2e-3)


def test_opaque_materials_have_no_table():
    full = Texture(np.full((2, 2, 3), 255, np.uint8), LINEAR)
    mesh = replace(square(), uvs=np.zeros((4, 2), np.float32))
    for material in ({}, {"opacity_texture": full}, {"cutoff": 0.5, "opacity": 0.7}):
        assert made_of(mesh, **material).transmittance is None
    assert made_of(mesh, cutoff=0.8, opacity=0.7).transmittance is not None
    assert Material().textures == []

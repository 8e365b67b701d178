"""Light through solid glass: reflected, refracted and absorbed as closed forms say."""

import json

import numpy as np
import pytest

from rna_render.materials import read_mesh_object
from rna_render.materials.material import Inside
from rna_render.materials.refraction import fresnel, reflected, refracted
from tests.render.assets import sphere, square
from tests.render.gltf_text import box_glb
from tests.render.stage import SKY, rgb
from tests.render.studio import assert_is, at_point, made_of, seen, shoot

WIDE = {"position": (0, 0, 4), "look_at": (0, 0, 0), "vertical_fov_deg": 40}
CLEAR = Inside(1.5, (0.0, 0.0, 0.0))
GLASS = {"coat_f0": 0.04, "roughness": 0.0, "transmission": 1.0}
LAMP = {
    "type": "rectangle",
    "position": (0, 3, 0),
    "look_at": (0, 0, 0),
    "up": (0, 0, 1),
    "size": (4, 4),
    "radiance": (3, 2, 1),
}


def test_fresnel_at_right_angles_at_brewster_s_and_beyond_the_critical_one():
    eta = np.array([1.5, 1 / 1.5])
    assert fresnel(np.ones(2), eta) == pytest.approx(0.04)
    brewster = np.cos(np.arctan(1.5))
    # Of light across the plane alone: sin^2(i - t) / 2, where i + t is a right angle.
    expected = 0.5 * np.sin(2 * np.arctan(1.5) - np.pi / 2) ** 2
    assert fresnel(np.array([brewster]), eta[:1]) == pytest.approx(expected)
    critical = np.cos(np.arcsin(1 / 1.5))
    assert fresnel(np.array([critical - 1e-3]), eta[1:]) == 1.0
    assert fresnel(np.array([critical + 1e-3]), eta[1:]) < 0.9


def test_directions_follow_snell_s_law():
    angle = np.radians([20.0, 60.0])
    d = np.stack([np.sin(angle), -np.cos(angle), np.zeros(2)], axis=1)
    n = np.tile([0.0, 1.0, 0.0], (2, 1))
    behind = refracted(d, n, np.full(2, 1.5))
    assert behind[:, 0] == pytest.approx(np.sin(angle) / 1.5)
    assert (behind[:, 1] < 0).all() and np.linalg.norm(behind, axis=1) == pytest.approx(1.0)
    assert refracted(behind, n, np.full(2, 1 / 1.5)) == pytest.approx(d)
    assert reflected(d, n) == pytest.approx(d * [1, -1, 1])


def test_a_clear_ball_vanishes_in_a_white_furnace():
    ball = made_of(sphere(4), **GLASS, inside=CLEAR)
    channels = shoot([(ball, {})], [SKY], camera=WIDE, samples=16)
    assert rgb(channels).mean() == pytest.approx(1.0, abs=2e-3)
    hidden = SKY | {"visible_to_camera": False}
    channels = shoot([(ball, {})], [hidden], camera=WIDE, samples=16)
    assert np.mean(channels["A"] > 0) == pytest.approx(0.45, abs=0.15)
    assert rgb(channels)[channels["A"] == 1].mean() == pytest.approx(1.0, abs=2e-3)


def test_a_slab_absorbs_along_its_thickness(tmp_path):
    """Straight on: 1 and 2 of a white sky's faces, with all reflections between them."""
    left = np.array([0.5, 0.25, 0.8])
    path = tmp_path / "slab.glb"
    path.write_bytes(box_glb((4.0, 4.0, 0.5), colour=left, distance=0.5))
    slab = read_mesh_object(path)
    assert slab.has_solid_glass and slab.transmittance is None
    camera = at_point((0, 0, 0), (0, 0, 4.0))
    actual = seen(shoot([(slab, {})], [SKY], camera=camera, samples=512))
    f = 0.04
    through = (1 - f) ** 2 * left / (1 - (f * left) ** 2)
    back = f + (1 - f) ** 2 * f * left**2 / (1 - (f * left) ** 2)
    assert_is(actual, through + back, relative=0.02)


def test_a_floor_is_lit_through_glass():
    """By rays that find the lamp behind a ball that bends and mirrors next to nothing."""
    floor = made_of(square(), base_color=(0.5, 0.5, 0.5))
    how = {"camera": at_point((0, 0, 0), (0.5, 0.4, 2.0)), "max_depth": 1}
    bare = seen(shoot([(floor, {})], [LAMP], "rays", **how | {"samples": 256})).mean
    ball = made_of(sphere(4), **GLASS, inside=Inside(1.0001, (0.0, 0.0, 0.0)))
    over = {"translation": (0, 1.5, 0)}
    actual = seen(shoot([(floor, {}), (ball, over)], [LAMP], "both", **how | {"samples": 512}))
    assert actual.mean == pytest.approx(bare, rel=5e-3)


def test_what_is_not_solid_glass_is_said(tmp_path):
    path = tmp_path / "half.glb"
    path.write_bytes(box_glb((1.0, 1.0, 1.0), share=0.5))
    with pytest.warns(UserWarning, match="refraction of partly transmissive materials"):
        half = read_mesh_object(path)
    assert not half.has_solid_glass and half.transmittance is not None
    assert json.dumps(half.materials[0].transmission) == "0.5"

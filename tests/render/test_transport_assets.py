"""Light between neural assets: what rays pass through, and what the transport holds already."""

import numpy as np
import pytest

from tests.render.assets import LambertAsset, merged, sphere, square
from tests.render.stage import SKY, rgb
from tests.render.studio import assert_is, at_point, flat, seen, shoot
from tests.render.test_transport_interreflection import WIDE, inside
from tests.render.test_transport_lights import parallel_rectangle

ALBEDO = np.array([0.8, 0.5, 0.2])
WHITE = (1.0, 1.0, 1.0)
BELOW = {"type": "directional", "direction": (0, -1, 0), "irradiance": WHITE}
WAYS = ["both", "lights", "rays"]


def upside_down(height: float) -> dict:
    return {"translation": (0, height, 0), "rotation_deg": (180, 0, 0)}


def roofed() -> LambertAsset:
    """A small floor, and a wide roof above it that faces down: one asset."""
    roof = inside(square(1.0, height=1.0))
    return LambertAsset(merged(square(0.002), roof))


def shown_by_the_lower_plate(h):
    """L = albedo / pi * (exitance of the upper plate) * configuration factor."""
    return ALBEDO / np.pi * ALBEDO * parallel_rectangle(1, 1, h)


@pytest.mark.parametrize("h", [0.5, 1.0])
def test_two_instances_of_one_asset_throw_light_on_one_another(h):
    """The sun shines up to the lower side of a plate, which lights a tiny one of its kind."""
    plate = LambertAsset(square(1.0))
    objects = [(plate, {"scale": 0.002}), (plate, upside_down(h))]
    camera = at_point((0, 0, 0), (0.3, 0.2, 2.0))
    settings = {"camera": camera, "samples": 48}
    actual = seen(shoot(objects, [BELOW], max_depth=2, **settings))
    assert_is(actual, shown_by_the_lower_plate(h), relative=0.01)
    direct = seen(shoot(objects, [BELOW], max_depth=1, **settings))
    assert (direct.mean == 0).all()


def test_indirect_rays_pass_through_their_own_instance():
    """What a roof of its own sends down is in the transport; as an asset apart it arrives."""
    camera = at_point((0, 0, 0), (0.3, 0.2, 2.0))
    elsewhere = (LambertAsset(sphere(1)), {"translation": (50, 0, 0)})
    settings = {"camera": camera, "samples": 48, "max_depth": 8}
    together = seen(shoot([(roofed(), {}), elsewhere], [BELOW], **settings))
    assert (together.mean == 0).all()
    roof, floor = LambertAsset(square(1.0)), LambertAsset(square(0.002))
    apart = seen(shoot([(floor, {}), (roof, upside_down(1.0))], [BELOW], **settings))
    assert_is(apart, shown_by_the_lower_plate(1.0), relative=0.01)


def test_rays_are_stopped_by_other_instances_of_the_same_package():
    """Two roofed floors, side by side and turned: the first is lit by the second one's roof."""
    asset = roofed()
    objects = [(asset, {}), (asset, {"translation": (0, 0.5, 0)})]
    camera = at_point((0, 0, 0), (0.3, 0.2, 2.0))
    actual = seen(shoot(objects, [BELOW], camera=camera, samples=48, max_depth=2))
    # The lower asset's own roof is at 1, and stops no rays from its floor; that of the other one,
    # at 1.5, gets no sun, for the lower roof is in its way. So there is no light at all.
    assert (actual.mean == 0).all()
    lifted = [(asset, {}), (asset, {"translation": (0, -0.5, 0)})]
    actual = seen(shoot(lifted, [BELOW], camera=camera, samples=48, max_depth=2))
    # Now the other roof is below the own one, at 0.5, and sunlit.
    assert_is(actual, shown_by_the_lower_plate(0.5), relative=0.01)


def test_light_through_an_opening_of_its_own_asset_counts_as_shadowed():
    """The sky above a roof of its own reaches a floor by the `shadowed` output alone."""
    open_floor = LambertAsset(square(1.0), albedo=WHITE)
    mesh = merged(square(1.0), square(500.0, height=0.05))
    covered = LambertAsset(mesh, albedo=WHITE, shadowed=(0.1, 0.2, 0.3))
    camera = at_point((0, 0, 0), (0.3, 0.02, 1.0))
    for way in WAYS:
        settings = {"camera": camera, "samples": 32, "seed": 3}
        actual = seen(shoot([(covered, {})], [SKY], way, **settings))
        # All of the upper half but the few directions that pass between the two.
        assert_is(actual, 2 * np.pi * np.array([0.1, 0.2, 0.3]), relative=0.02)
        assert_is(seen(shoot([(open_floor, {})], [SKY], way, **settings)), 1.0, relative=0.01)


@pytest.mark.parametrize("way", WAYS)
def test_two_interpenetrating_assets_vanish_in_a_white_furnace(way):
    """Convex bodies of albedo one, half inside one another: no light is lost, or found twice.

    Rays that start on one pass through it, and meet the other from outside: what is inside
    the other is reached by no path.
    """
    ball = LambertAsset(flat(sphere(2)), albedo=WHITE)
    objects = [(ball, {"translation": (-0.5, 0, 0)}), (ball, {"translation": (0.5, 0.2, 0)})]
    camera = {**WIDE, "vertical_fov_deg": 20}
    samples = 96 if way == "rays" else 24
    channels = shoot(objects, [SKY], way, camera=camera, samples=samples, max_depth=64, seed=1)
    ids = channels["assetId"]
    assert {1, 2} <= set(np.unique(ids))
    assert np.isfinite(rgb(channels)).all()
    hit = rgb(channels)[ids > 0]
    error = hit[:, 0].std() / np.sqrt(len(hit))
    assert error < 0.003
    assert abs(hit.mean() - 1) < 3 * error
    for asset in (1, 2):
        assert rgb(channels)[ids == asset].mean() == pytest.approx(1, abs=0.01)


def test_interpenetrating_assets_cast_shadows_on_what_is_inside_the_other():
    """A lid half way through a ball: the part of the lid inside gets no sun, for it is covered."""
    ball = LambertAsset(sphere(3))
    lid = LambertAsset(square(2.0))
    sun = {"type": "directional", "direction": (0, 1, 0), "irradiance": WHITE}
    objects = [(ball, {}), (lid, {})]
    inside = {"camera": at_point((0.2, 0, 0.1), (0.3, 0.4, 0.1)), "max_depth": 1, "samples": 1}
    assert (seen(shoot(objects, [sun], **inside)).mean == 0).all()
    outside = {"camera": at_point((1.5, 0, 0), (1.6, 2.0, 0)), "max_depth": 1, "samples": 1}
    assert_is(seen(shoot(objects, [sun], **outside)), ALBEDO / np.pi)


def test_the_inside_of_a_solid_is_black_to_scattered_rays():
    """On the floor inside a ball the sun does not shine, nor does the ball's inside."""
    ball = LambertAsset(sphere(4, radius=0.5), shadowed=(0.3, 0.3, 0.3))
    floor = LambertAsset(square(2.0), albedo=WHITE)
    sun = {"type": "directional", "direction": (0, 1, 0), "irradiance": WHITE}
    camera = at_point((0.2, 0, 0.1), (0.1, 0.3, 0.1))
    assert (seen(shoot([(ball, {}), (floor, {})], [sun], camera=camera)).mean == 0).all()

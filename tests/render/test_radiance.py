"""Radiance of whole images against integrals with a known value."""

import numpy as np
import pytest

from tests.render.assets import LambertAsset, merged, sphere, square
from tests.render.stage import ABOVE, LOW, SKY, SUN, WHITE, image, rgb

ALBEDO = np.array([0.8, 0.5, 0.2])
SHADOW_COLOUR = (0.0, 0.0, 7.0)


@pytest.fixture(scope="module")
def floor():
    return LambertAsset(square(size=5.0), shadowed=SHADOW_COLOUR)


@pytest.fixture(scope="module")
def ball():
    return LambertAsset(sphere(4), shadowed=SHADOW_COLOUR)


def test_a_convex_body_in_a_white_furnace_shows_its_albedo():
    ball = LambertAsset(sphere(4))
    middle = {**ABOVE, "vertical_fov_deg": 5}
    channels = image([(ball, {})], [SKY], samples=256, camera=middle)
    np.testing.assert_allclose(rgb(channels), np.broadcast_to(ALBEDO, (12, 16, 3)), rtol=0.12)
    np.testing.assert_allclose(rgb(channels).mean(axis=(0, 1)), ALBEDO, rtol=0.006)


def test_an_asset_with_albedo_one_vanishes_in_a_white_furnace():
    ball = LambertAsset(sphere(4), albedo=WHITE)
    wide = {**ABOVE, "vertical_fov_deg": 60}
    channels = image([(ball, {})], [SKY], samples=256, camera=wide)
    assert 0 < np.mean(channels["assetId"] == 0) < 1
    assert abs(rgb(channels).mean() - 1) < 2e-3
    # At the silhouette shading and geometric normals differ most, and so samples vary most.
    np.testing.assert_allclose(rgb(channels), np.ones((12, 16, 3)), rtol=0.1)


def test_the_environment_is_unbiased_however_the_surface_faces():
    """A sheet lit from below only: the mixture's uniform part has to carry all of it."""

    class Backlit(LambertAsset):
        def evaluate(self, positions, normals, wo, wi):
            return super().evaluate(positions, -normals, wo, wi)

    channels = image([(Backlit(square(size=5.0)), {})], [SKY], samples=1024, resolution=(4, 4))
    np.testing.assert_allclose(rgb(channels).mean(axis=(0, 1)), ALBEDO, rtol=0.01)


def test_light_adds_up(floor):
    point = {"type": "point", "position": (0, 3, 0), "intensity": WHITE}
    both = rgb(image([(floor, {})], [SUN, point]))
    apart = [rgb(image([(floor, {})], [light])) for light in (SUN, point)]
    np.testing.assert_allclose(both, apart[0] + apart[1], rtol=1e-6)


def test_another_instance_casts_a_shadow(floor):
    """A lid between light and floor, seen from the side under it."""
    lid = LambertAsset(square(size=2.0), albedo=WHITE)
    for height, blocked in ((1.0, True), (-1.0, False)):
        placed = [(floor, {}), (lid, {"translation": (0, height, 0)})]
        channels = image(placed, [SUN], camera=LOW, max_depth=1)
        assert (channels["assetId"] == 1).all()
        assert (channels["visibility"] == (0 if blocked else 1)).all()
        expected = np.zeros(3) if blocked else ALBEDO / np.pi
        np.testing.assert_allclose(rgb(channels), np.broadcast_to(expected, (12, 16, 3)), rtol=1e-5)


def test_an_instance_passes_its_own_shadow_rays_and_shows_the_shadowed_output():
    asset = LambertAsset(merged(square(size=5.0), square(size=2.0, height=1.0)))
    asset = LambertAsset(asset.mesh, shadowed=SHADOW_COLOUR)
    alone = image([(asset, {})], [SUN], camera=LOW)
    elsewhere = (LambertAsset(square()), {"translation": (50, 0, 0)})
    in_company = image([(asset, {}), elsewhere], [SUN], camera=LOW)
    for channels in (alone, in_company):
        np.testing.assert_allclose(
            rgb(channels), np.broadcast_to(SHADOW_COLOUR, (12, 16, 3)), rtol=1e-6
        )
        assert (channels["visibility"] == 0).all()


def test_two_instances_of_one_asset_shadow_one_another():
    lid = LambertAsset(square(size=2.0), shadowed=SHADOW_COLOUR)
    placed = [(lid, {}), (lid, {"translation": (0, 1, 0)})]
    channels = image(placed, [SUN], camera=LOW, max_depth=1)
    assert (rgb(channels) == 0).all() and (channels["assetId"] == 1).all()


def test_a_body_far_behind_a_point_light_casts_no_shadow(floor):
    lid = LambertAsset(square(size=2.0))
    placed = [(floor, {}), (lid, {"translation": (0, 1, 0)})]
    light = {"type": "point", "position": (0, 0.9, 0), "intensity": WHITE}
    assert (image(placed, [light], camera=LOW)["visibility"] == 1).all()
    light = {"type": "point", "position": (0, 1.1, 0), "intensity": WHITE}
    assert (image(placed, [light], camera=LOW)["visibility"] == 0).all()


@pytest.mark.parametrize("scale", [0.5, 2.0])
def test_a_roof_of_the_asset_itself_blocks_only_lights_above_it(scale):
    asset = LambertAsset(merged(square(size=5.0), square(size=2.0, height=1.0)))
    for height, seen in ((0.8, 1), (1.2, 0)):
        light = {"type": "point", "position": (0, height * scale, 0), "intensity": WHITE}
        channels = image([(asset, {"scale": scale})], [light], camera=LOW)
        assert (channels["visibility"] == seen).all()


TURN = {"rotation_deg": (20, 30, 40)}


@pytest.mark.parametrize("scale", [0.01, 1.0, 30.0])
def test_scale_changes_no_radiance(ball, scale):
    """Asset, camera and light all grow together; the point light's intensity with the area."""
    lights = [
        SUN | {"direction": (1, 2, 3)},
        {
            "type": "point",
            "position": np.multiply((2, 3, 1), scale),
            "intensity": np.multiply(WHITE, scale**2),
        },
    ]
    camera = {**ABOVE, "position": (0, 4 * scale, 0)}
    here = image([(ball, {"scale": scale} | TURN)], lights, camera=camera)
    lights[1] |= {"position": (2, 3, 1), "intensity": WHITE}
    there = image([(ball, TURN)], lights)
    # Pixels on the silhouette and the terminator may fall to either side by rounding.
    close = np.isclose(rgb(here), rgb(there), rtol=1e-3, atol=1e-4).all(axis=-1)
    assert close.mean() > 0.97


def test_turning_everything_changes_no_radiance(floor):
    """The scene of a sunlit floor, turned by a quarter about z: y to -x."""
    light = SUN | {"direction": (1, 2, 0.5)}
    camera = {"position": (1, 4, 2), "look_at": (0, 0, 0), "vertical_fov_deg": 20}
    straight = image([(floor, {})], [light], camera=camera)
    turned_light = SUN | {"direction": (-2, 1, 0.5)}
    turned_camera = camera | {"position": (-4, 1, 2), "up": (-1, 0, 0)}
    turned = image([(floor, {"rotation_deg": (0, 0, 90)})], [turned_light], camera=turned_camera)
    np.testing.assert_allclose(rgb(turned), rgb(straight), rtol=1e-4)
    np.testing.assert_allclose(turned["normal.X"], -straight["normal.Y"], atol=1e-6)
    np.testing.assert_allclose(turned["position.Y"], straight["position.X"], atol=1e-4)


def test_aovs_name_what_is_there(floor, ball):
    """A ball on the left half of the image, over a floor; instances numbered as in the file."""
    small = {"translation": (-1, 0.5, 0), "scale": 0.5}
    placed = [(ball, small), (floor, {}), (ball, {"translation": (0, -9, 0)})]
    high = {**ABOVE, "position": (0, 9, 0)}
    channels = image(placed, [SUN], camera=high)
    on_floor = channels["assetId"] == 2
    assert set(np.unique(channels["assetId"])) == {1, 2}
    assert on_floor[:, 8:].all() and not on_floor[:, :8].all()
    np.testing.assert_array_equal(channels["normal.Y"][:, 8:], 1)
    np.testing.assert_array_equal(channels["position.Y"][:, 8:], 0)
    assert channels["position.Y"].max() == pytest.approx(1.0, abs=0.05)
    length = sum(channels[f"normal.{c}"] ** 2 for c in "XYZ")
    np.testing.assert_allclose(length, 1, rtol=1e-5)


def test_the_background_is_transparent_unless_the_environment_shows(ball):
    away = {**ABOVE, "look_at": (0, 9, 0)}
    for lights, alpha in (([], 0), ([SKY | {"visible_to_camera": False}], 0), ([SKY], 1)):
        channels = image([(ball, {})], lights, camera=away)
        assert (channels["A"] == alpha).all() and (rgb(channels) == alpha).all()
        assert (channels["assetId"] == 0).all() and (channels["normal.Y"] == 0).all()

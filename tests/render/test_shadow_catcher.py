"""What a shadow catcher shows: alpha where light is blocked, against cases with a known part."""

import numpy as np
import pytest

from tests.render.assets import LambertAsset, sphere, square
from tests.render.stage import SKY, SUN, WHITE, rgb
from tests.render.studio import Channels, at_point, made_of, shoot

BLACK = (0.0, 0.0, 0.0)
DISK = {
    "type": "disk",
    "position": (0, 3, 0),
    "look_at": (0, 0, 0),
    "radius": 0.5,
    "radiance": (5, 4, 3),
    "visible_to_camera": False,
}
BALL_LAMP = {"type": "sphere", "position": (0, 3, 0), "radius": 0.5, "radiance": (5, 4, 3)}


def catcher():
    return made_of(square(20.0), catches_shadows=True)


def shade(offset: float = 0.0, height: float = 1.0):
    """A black square of half-side 2 over the catcher, whose left edge is at x = `offset`."""
    return made_of(square(2.0), base_color=BLACK), {"translation": (2 + offset, height, 0)}


def shown(objects, lights, **changes) -> Channels:
    camera = at_point((0, 0, 0), (0.3, 0.5, 2.0))
    settings = {"camera": camera, "resolution": (32, 32), "samples": 32}
    return shoot([(catcher(), {}), *objects], lights, **(settings | changes))


def alpha(objects, lights, **changes) -> float:
    channels = shown(objects, lights, **changes)
    assert (rgb(channels) == 0).all()
    return float(channels["A"].mean())


ASLANT = SUN | {"direction": (1, 1, 1)}
HIDDEN_SKY = SKY | {"visible_to_camera": False}


@pytest.mark.parametrize("lights", [[], [SUN], [DISK], [BALL_LAMP], [HIDDEN_SKY], [ASLANT, DISK]])
def test_nothing_in_the_way_leaves_it_invisible(lights):
    assert alpha([], lights) == 0


@pytest.mark.parametrize("lights", [[SUN], [DISK], [BALL_LAMP], [SUN, DISK]])
def test_a_light_that_is_hidden_wholly_makes_it_black(lights):
    assert alpha([shade(offset=-1.0)], lights) == 1


def test_no_light_makes_no_shadow():
    assert alpha([shade(offset=-1.0)], []) == 0


@pytest.mark.parametrize("light", [DISK, BALL_LAMP])
def test_half_a_lamp_hidden_is_half_a_shadow(light):
    """An edge right across the middle of the lamp."""
    assert alpha([shade()], [light]) == pytest.approx(0.5, abs=0.005)


def test_shadows_of_several_lights_add_up_by_irradiance():
    """The sun hidden, and beside it a lamp that shines past the edge."""
    lamp = {"type": "point", "position": (-3, 4, 0), "intensity": WHITE}
    arrives = 4 / 125
    sun = SUN | {"irradiance": (0.1, 0.1, 0.1)}
    expected = 0.1 / (0.1 + arrives)
    assert alpha([shade(offset=-0.5)], [sun, lamp]) == pytest.approx(expected, rel=1e-3)


def test_more_lights_than_a_point_samples():
    suns = [SUN | {"irradiance": (k, k, k)} for k in (1, 2, 3)]
    lamps = [
        {"type": "point", "position": (-3, 4, 0), "intensity": (k, k, k)} for k in (50, 60, 70)
    ]
    expected = 6 / (6 + 180 * 4 / 125)
    actual = alpha([shade(offset=-0.5)], [*suns, *lamps], samples=128)
    assert actual == pytest.approx(expected, abs=0.01)


def test_a_lid_over_all_of_it_keeps_out_the_sky():
    """Light from below the catcher's plane reaches no ground that is seen from above."""
    lid = made_of(square(500.0), base_color=BLACK), {"translation": (0, 1, 0)}
    assert alpha([lid], [HIDDEN_SKY]) == pytest.approx(1, abs=0.005)


def test_seen_from_below_it_catches_what_comes_from_below():
    lid = made_of(square(500.0), base_color=BLACK), {"translation": (0, 1, 0)}
    camera = at_point((0, 0, 0), (0.3, -0.5, 2.0))
    assert alpha([lid], [HIDDEN_SKY], camera=camera) == 0


def test_the_sky_behind_it_is_darkened():
    sky = SKY | {"radiance": (1, 2, 4)}
    clear = shown([], [sky])
    np.testing.assert_allclose(rgb(clear), np.broadcast_to((1, 2, 4), (32, 32, 3)), rtol=1e-5)
    lid = made_of(square(500.0), base_color=BLACK), {"translation": (0, 1, 0)}
    covered = shown([lid], [sky])
    assert rgb(covered).max() < 0.05
    assert (clear["A"] == 1).all() and covered["A"] == pytest.approx(1)


def test_half_of_the_sky_darkened():
    sky = SKY | {"radiance": (1e-5, 2e-5, 4e-5)}
    channels = shown([shade()], [sky, DISK], samples=64)
    actual = rgb(channels).mean(axis=(0, 1))
    np.testing.assert_allclose(actual, np.array((1e-5, 2e-5, 4e-5)) / 2, rtol=0.01)
    np.testing.assert_allclose(channels["A"], 1, rtol=1e-5)


def test_groups_of_lights_add_up_on_it():
    sky, disk = SKY | {"radiance": (1, 2, 4), "group": "sky"}, DISK | {"group": "lamp"}
    channels = shown([shade()], [sky, disk])
    parts = sum(np.stack([channels[f"light.{g}.{c}"] for c in "RGB"], -1) for g in ("sky", "lamp"))
    assert rgb(channels).min() > 0
    np.testing.assert_allclose(parts, rgb(channels), rtol=1e-4)


def test_an_asset_above_it_is_as_it_would_be_without():
    """It takes no light from the asset, and gives none: only the camera sees it."""
    ball = LambertAsset(sphere(3)), {"translation": (0, 1.2, 0)}
    camera = {"position": (0, 3, 6), "look_at": (0, 0.8, 0), "vertical_fov_deg": 30}
    settings = {"camera": camera, "resolution": (24, 16), "samples": 16}
    lights = [SUN | {"direction": (1, 3, 1)}, DISK | {"position": (0, 4, 0)}]
    alone = shoot([ball], lights, **settings)
    above = shoot([(catcher(), {}), ball], lights, **settings)
    whole = alone["A"] == 1
    assert whole.any()
    np.testing.assert_array_equal(rgb(above)[whole], rgb(alone)[whole])
    assert (above["A"][whole] == 1).all()
    np.testing.assert_allclose(rgb(above), rgb(alone), atol=1e-6)  # the catcher adds alpha alone
    shadow = above["A"][alone["A"] == 0]
    assert shadow.max() > 0.5 and shadow.min() == 0


@pytest.mark.parametrize("strategy", ["both", "lights"])
def test_it_is_no_thing_to_other_rays(strategy):
    """A floor under it gets all light, though the camera sees none of that floor."""
    floor = LambertAsset(square(5.0)), {"translation": (0, -0.5, 0)}
    lamp = LambertAsset(square(5.0)), {"translation": (0, 2, 0), "rotation_deg": (180, 0, 0)}
    above = {"camera": at_point((0, -0.5, 0), (0.1, -0.3, 0.4)), "samples": 8}
    below = {"type": "directional", "direction": (0.6, 0.8, 0), "irradiance": WHITE}
    free = rgb(shoot([floor, lamp], [below], strategy, **above))
    caught = rgb(shoot([floor, lamp, (catcher(), {})], [below], strategy, **above))
    np.testing.assert_allclose(caught, free, rtol=1e-3)

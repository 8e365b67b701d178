"""Groups of lights, lights that the camera does not see, and lights that stand in the way."""

import numpy as np
import pytest

from tests.render.assets import LambertAsset, sphere, square
from tests.render.stage import SKY, SUN, WHITE, rgb
from tests.render.studio import at_point, flat, made_of, seen, shoot

VIEW = {"position": (0, 2, 6), "look_at": (0, 0.5, 0), "vertical_fov_deg": 40}
DISK = {
    "type": "disk",
    "position": (0, 3, 0),
    "look_at": (0, 0, 0),
    "radius": 0.5,
    "radiance": (5, 4, 3),
}
POINT = {"type": "point", "position": (2, 2, 2), "intensity": (3, 2, 1)}
LAMP = {"type": "sphere", "position": (-2, 1, 0), "radius": 0.3, "radiance": (4, 6, 8)}
SETTINGS = {"camera": VIEW, "resolution": (24, 16), "samples": 8}


def objects():
    return [
        (made_of(square(4.0), base_color=(0.6, 0.7, 0.8)), {}),
        (LambertAsset(sphere(3)), {"translation": (0, 1, 0)}),
    ]


def group(channels, name):
    return np.stack([channels[f"light.{name}.{c}"] for c in "RGB"], axis=-1)


def in_groups(*names):
    return [
        light | ({"group": name} if name else {})
        for light, name in zip((SUN, DISK, POINT, LAMP, SKY), names, strict=True)
    ]


def test_groups_add_up_to_the_image():
    """Five lights: one of them is chosen for each point, and rays meet three of them."""
    channels = shoot(objects(), in_groups("a", "b", "a", "c", "b"), **SETTINGS)
    total = sum(group(channels, name) for name in "abc")
    np.testing.assert_allclose(total, rgb(channels), rtol=1e-4, atol=1e-6)
    assert all(group(channels, name).max() > 0 for name in "abc")


def test_groups_change_no_image():
    plain = shoot(objects(), in_groups("", "", "", "", ""), **SETTINGS)
    grouped = shoot(objects(), in_groups("x", "", "y", "x", ""), **SETTINGS)
    np.testing.assert_array_equal(rgb(grouped), rgb(plain))
    assert not any(name.startswith("light.") for name in plain)


def test_a_group_is_what_its_lights_alone_bring():
    """Each group, in some seeds, against images of its lights alone."""
    alone = {"s": [DISK], "t": [POINT, LAMP]}
    lights = [DISK | {"group": "s"}, POINT | {"group": "t"}, LAMP | {"group": "t"}, SUN, SKY]
    seeds, finer = range(8), SETTINGS | {"max_depth": 2}
    images = [shoot(objects(), lights, seed=k, **finer) for k in seeds]
    for name, its_lights in alone.items():
        apart = [rgb(shoot(objects(), its_lights, seed=100 + k, **finer)) for k in seeds]
        means = [np.mean(x, axis=(1, 2)) for x in ([group(i, name) for i in images], apart)]
        error = np.hypot(*(x.std(axis=0, ddof=1) / len(seeds) ** 0.5 for x in means))
        off = np.abs(means[0].mean(axis=0) - means[1].mean(axis=0))
        assert (off < 3 * error).all()
        assert (error < 0.08 * means[1].mean(axis=0)).all()


@pytest.mark.parametrize("lamp", [DISK | {"look_at": (0, 3, 9)}, LAMP])
def test_a_lamp_is_seen_unless_it_says_no(lamp):
    camera = {"position": (0, 3, 6), "look_at": lamp["position"], "vertical_fov_deg": 1}
    away = [(LambertAsset(square(1.0)), {"translation": (0, -50, 0)})]
    settings = {"camera": camera, "samples": 1}
    shows = shoot(away, [lamp], **settings)
    np.testing.assert_allclose(rgb(shows), np.broadcast_to(lamp["radiance"], (48, 48, 3)))
    assert (shows["A"] == 1).all() and (shows["assetId"] == 0).all()
    hidden = shoot(away, [lamp | {"visible_to_camera": False}], **settings)
    assert (rgb(hidden) == 0).all() and (hidden["A"] == 0).all()
    before_sky = shoot(away, [lamp | {"visible_to_camera": False}, SKY], **settings)
    assert (rgb(before_sky) == 1).all() and (before_sky["A"] == 1).all()


@pytest.mark.parametrize("strategy", ["both", "lights", "rays"])
def test_a_lamp_that_is_not_seen_shines_as_well(strategy):
    """On a floor, and in a mirror."""
    hidden = LAMP | {"visible_to_camera": False}
    floor = made_of(square(4.0), base_color=(0.6, 0.7, 0.8), metallic=0.5, roughness=0.4)
    settings = {"camera": at_point((-1.5, 0, 0)), "max_depth": 2, "samples": 16}
    images = [rgb(shoot([(floor, {})], [lamp], strategy, **settings)) for lamp in (LAMP, hidden)]
    np.testing.assert_array_equal(*images)
    assert images[0].mean() > 0.1


@pytest.mark.parametrize("visible", [True, False])
def test_a_lamp_stands_in_the_way_of_other_light(visible):
    floor = made_of(square(50.0))
    lamp = DISK | {"radius": 1.0, "radiance": (0, 0, 0), "visible_to_camera": visible}
    settings = {"camera": at_point((0, 0, 0)), "max_depth": 1, "samples": 2}
    assert (seen(shoot([(floor, {})], [SUN, lamp], **settings)).mean == 0).all()
    beside = {**settings, "camera": at_point((1.5, 0, 0))}
    actual = seen(shoot([(floor, {})], [SUN, lamp], **beside))
    np.testing.assert_allclose(actual.mean, np.array(WHITE) / np.pi, rtol=1e-5)


def test_an_object_that_shines_is_in_no_group_but_in_the_image():
    lamp = made_of(flat(square(0.5)), base_color=(0.2, 0.2, 0.2), emission=(1, 2, 3))
    placed = [*objects(), (lamp, {"translation": (0, 2.5, 0)})]
    channels = shoot(placed, [SUN | {"group": "sun"}], **SETTINGS)
    rest = rgb(channels) - group(channels, "sun")
    assert rest.min() > -1e-5 and rest.max() > 0.5

"""Every kind of light on a white plane, by every way of finding it, against closed forms."""

from pathlib import Path

import numpy as np
import pytest

from rna_render.image.images import write_exr
from tests.render.assets import LambertAsset, square
from tests.render.studio import assert_is, at_point, flat, made_of, seen, shoot

RGB = np.array([1.0, 2.0, 3.0])
WAYS = ["both", "lights", "rays"]


def floor():
    """Radiance of a white plane is its irradiance over pi."""
    return made_of(square(50.0))


def plane_shows(light, ways=WAYS, x=(0.0, 0.0, 0.0), objects=(), **changes):
    """The radiance of the floor at x, by each way."""
    scene = [(floor(), {}), *objects]
    lights = [] if light is None else [light]
    settings = {"camera": at_point(x), "max_depth": 1, "samples": 16} | changes
    for way in ways:
        # Rays alone meet lights now and then only.
        samples = settings["samples"] * (3 if way == "rays" else 1)
        yield seen(shoot(scene, lights, way, **(settings | {"samples": samples})))


def assert_brings(light, irradiance, **where):
    for estimate in plane_shows(light, **where):
        assert_is(estimate, RGB * irradiance / np.pi)


def parallel_rectangle(half_width, half_height, h):
    """Configuration factor of a rectangle above its middle: Howell, B-3, four times."""
    a, b = half_width / h, half_height / h
    p, q = np.hypot(1, a), np.hypot(1, b)
    return 2 / np.pi * (a / p * np.arctan(b / p) + b / q * np.arctan(a / q))


@pytest.mark.parametrize("diameter", [10, 60])
def test_a_directional_light_with_an_angular_diameter(diameter):
    sun = {
        "type": "directional",
        "direction": (3, 4, 0),
        "irradiance": RGB,
        "angular_diameter_deg": diameter,
    }
    ways = ["both", "lights"] if diameter < 30 else WAYS
    assert_brings(sun, 0.8, ways=ways, samples=32)


@pytest.mark.parametrize("x", [(0, 0, 0), (1.5, 0, 0.7)])
def test_a_point_light(x):
    light = {"type": "point", "position": (0, 2, 0), "intensity": RGB}
    r2 = 4 + x[0] ** 2 + x[2] ** 2
    assert_brings(light, 2 / r2**1.5, x=x, ways=["both", "lights"])


@pytest.mark.parametrize(("degrees", "inside"), [(0, 1.0), (19, 1.0), (30, None), (41, 0.0)])
def test_a_spot_light(degrees, inside):
    light = {
        "type": "spot",
        "position": (0, 2, 0),
        "look_at": (0, 0, 0),
        "intensity": RGB,
        "inner_angle_deg": 20,
        "outer_angle_deg": 40,
    }
    cosine = np.cos(np.radians(degrees))
    if inside is None:
        inner, outer = np.cos(np.radians([20, 40]))
        t = (cosine - outer) / (inner - outer)
        inside = t * t * (3 - 2 * t)
    expected = inside * cosine / (2 / cosine) ** 2
    x = (2 * np.tan(np.radians(degrees)), 0, 0)
    assert_brings(light, expected, x=x, ways=["both", "lights"])


@pytest.mark.parametrize("h", [0.5, 1.0])
def test_a_rectangle(h):
    """The floor is so wide that rays step 0.3 mm off it: more than they stop short of the lamp."""
    light = {
        "type": "rectangle",
        "position": (0, h, 0),
        "look_at": (0, 0, 0),
        "up": (0, 0, 1),
        "size": (2, 1),
        "radiance": RGB,
        "visible_to_camera": False,
    }
    assert_brings(light, np.pi * parallel_rectangle(1, 0.5, h), samples=32)


@pytest.mark.parametrize("h", [0.5, 1.0])
def test_a_disk(h):
    light = {
        "type": "disk",
        "position": (0, h, 0),
        "look_at": (0, 0, 0),
        "radius": 1.2,
        "radiance": RGB,
        "visible_to_camera": False,
    }
    assert_brings(light, np.pi * 1.44 / (1.44 + h * h), samples=48)


def test_a_sphere():
    light = {"type": "sphere", "position": (-1.5, 2, 0), "radius": 1.2, "radiance": RGB}
    assert_brings(light, np.pi * 1.44 / 6.25 * 0.8, samples=32)


@pytest.mark.parametrize("upside", [0, 180])
def test_an_emissive_mesh_shines_to_both_sides(upside):
    lamp = made_of(flat(square(1.0)), base_color=(0, 0, 0), emission=tuple(RGB))
    placed = (lamp, {"translation": (0, 1, 0), "rotation_deg": (upside, 0, 0)})
    camera = at_point((0, 0, 0), (0.3, 0.5, 2.0))
    expected = np.pi * parallel_rectangle(1, 1, 1)
    assert_brings(None, expected, objects=[placed], camera=camera, samples=32)


def test_an_environment_of_one_colour():
    assert_brings({"type": "environment", "radiance": RGB}, np.pi, samples=32)


def linear_sky(path: Path, towards: np.ndarray) -> Path:
    """An image of radiance 1 + d.towards, laid out as docs/scene.md says."""
    h, w = 64, 128
    theta, phi = np.meshgrid(
        np.pi * (np.arange(h) + 0.5) / h,
        2 * np.pi * ((np.arange(w) + 0.5) / w - 0.5),
        indexing="ij",
    )
    d = np.stack(
        [np.sin(theta) * np.sin(phi), np.cos(theta), -np.sin(theta) * np.cos(phi)], axis=-1
    )
    grey = (1 + d @ towards).astype(np.float32)
    write_exr(path, {channel: grey for channel in "RGB"}, {})
    return path


@pytest.mark.parametrize("turn", [0, 90])
def test_the_image_of_an_environment(tmp_path, turn):
    """A sky of radiance 1 + d.a brings pi + 2 pi / 3 n.a to a plane of normal n."""
    a = np.array([0.5, 0.3, -0.6])
    path = linear_sky(tmp_path / "sky.exr", a)
    light = {"type": "environment", "path": path, "radiance": RGB, "rotation_deg": turn}
    # Counter-clockwise seen from above takes +x to -z, and +z to +x.
    turned = a if turn == 0 else np.array([a[2], a[1], -a[0]])
    assert_brings(light, np.pi + 2 * np.pi / 3 * turned[1], samples=32)
    wall = made_of(square(50.0))
    stands = [(wall, {"rotation_deg": (0, 0, -90)})]  # its normal is +x
    for way in WAYS:
        camera = at_point((0, 0, 0), (2, 0.3, 0.4))
        actual = seen(shoot(stands, [light], way, camera=camera, samples=32, max_depth=1))
        assert_is(actual, RGB * (np.pi + 2 * np.pi / 3 * turned[0]) / np.pi)


@pytest.mark.parametrize("way", WAYS)
def test_a_neural_asset_finds_the_same_light(way):
    """The lobes that rays leave assets in, on a Lambert asset under a disk."""
    asset = LambertAsset(square(5.0), albedo=(1, 1, 1))
    light = {
        "type": "disk",
        "position": (0, 0.5, 0),
        "look_at": (0, 0, 0),
        "radius": 1.2,
        "radiance": RGB,
        "visible_to_camera": False,
    }
    actual = seen(shoot([(asset, {})], [light], way, camera=at_point((0, 0, 0)), samples=48))
    assert_is(actual, RGB * 1.44 / (1.44 + 0.25))


@pytest.mark.parametrize("way", ["both", "lights"])
def test_more_lights_than_a_point_samples(way):
    """One of them is chosen for each, by power: six points, each of which brings the same."""
    points = [
        {"type": "point", "position": (0, 1 + k, 0), "intensity": RGB * (1 + k) ** 2}
        for k in range(6)
    ]
    settings = {"camera": at_point((0, 0, 0)), "max_depth": 1, "samples": 32}
    actual = seen(shoot([(floor(), {})], points, way, **settings))
    assert_is(actual, RGB * 6 / np.pi)

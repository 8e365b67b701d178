"""Light between surfaces: furnaces, cavities, bleeding colours, and how paths end."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh

from rna_sdk.package import Mesh
from tests.render.assets import LambertAsset, sphere, square
from tests.render.stage import SKY, rgb
from tests.render.studio import assert_is, at_point, flat, made_of, seen, shoot

ALBEDO = np.array([0.7, 0.5, 0.2])
EMISSION = np.array([1.0, 2.0, 3.0])
WIDE = {"position": (0, 0, 4), "look_at": (0, 0, 0), "vertical_fov_deg": 40}
WAYS = ["both", "lights", "rays"]


def inside(mesh: Mesh) -> Mesh:
    """The mesh with its faces turned over."""
    return Mesh(mesh.positions, -mesh.normals, None, mesh.triangles[:, ::-1].copy())


def box(size: float = 2.0) -> Mesh:
    cube = trimesh.creation.box((size, size, size))
    corners = np.asarray(cube.vertices, np.float32)
    return flat(Mesh(corners, corners, None, np.asarray(cube.faces, np.uint32)))


@pytest.mark.parametrize("smooth", [False, True])
def test_a_white_sphere_vanishes_in_a_white_furnace(smooth):
    ball = sphere(4) if smooth else flat(sphere(3))
    channels = shoot([(made_of(ball), {})], [SKY], camera=WIDE, max_depth=64)
    assert 0.3 < np.mean(channels["assetId"] > 0) < 0.9
    assert rgb(channels).mean() == pytest.approx(1, abs=0.005)
    assert channels["R"].min() > 0.8 and channels["R"].max() < 1.2


def test_a_white_bowl_vanishes_in_a_white_furnace():
    """Light leaves a half open box after many reflections only."""
    walls = made_of(flat(replace(box(), triangles=box().triangles[:10])))
    turned = {"rotation_deg": (20, 30, 0)}
    channels = shoot([(walls, turned)], [SKY], camera=WIDE, max_depth=256)
    assert rgb(channels).mean() == pytest.approx(1, abs=0.005)


def cavity(mesh: Mesh, way="both", **changes):
    walls = made_of(mesh, base_color=tuple(ALBEDO), emission=tuple(EMISSION))
    camera = {"position": (0.1, 0.2, 0.3), "look_at": (1, 0.4, 0.1), "vertical_fov_deg": 90}
    defaults = {
        "camera": camera,
        "max_depth": 24,
        "resolution": (32, 32),
        "samples": 40 if way == "lights" else 8,
    }
    return seen(shoot([(walls, {})], (), way, **(defaults | changes)))


@pytest.mark.parametrize("way", ["both", "rays"])
def test_a_glowing_hollow_sphere(way):
    """L = Le + albedo L."""
    actual = cavity(inside(flat(sphere(2))), way)
    assert_is(actual, EMISSION / (1 - ALBEDO), relative=0.01)


def test_a_glowing_box():
    assert_is(cavity(inside(box())), EMISSION / (1 - ALBEDO), relative=0.01)


@pytest.mark.parametrize(
    ("depth", "way"),
    [(depth, way) for depth in (1, 2, 3, 5) for way in ("both", "rays")] + [(2, "lights")],
)
def test_max_depth_counts_the_points_that_scatter(depth, way):
    expected = EMISSION * sum(ALBEDO**k for k in range(depth + 1))
    assert_is(cavity(inside(flat(sphere(2))), way, max_depth=depth), expected, relative=0.01)


def test_ending_paths_at_random_changes_no_mean(monkeypatch):
    actual = {}
    for first in (1, 3, 1000):
        monkeypatch.setattr("rna_render.paths.integrator.FIRST_ROULETTE", first)
        actual[first] = cavity(inside(flat(sphere(2))), max_depth=8, seed=first)
        expected = EMISSION * sum(ALBEDO**k for k in range(9))
        assert_is(actual[first], expected, relative=0.01)
    assert actual[1].error[0] > actual[1000].error[0]  # it does end paths


def radiosity(*scene):
    """What ever more patches converge to, by Aitken's delta-squared process."""
    a, b, c = (radiosity_of_patches(*scene, n) for n in (8, 16, 32))
    return c - (c - b) ** 2 / ((c - b) - (b - a))


def radiosity_of_patches(floor, wall, floor_e, floor_albedo, wall_albedo, n):
    """Exitances of a floor, y = 0, and a wall, x = 0, both of unit size, lit directly.

    By solving for n x n patches each. floor_e: irradiance that the sun brings to the floor; the
    wall gets none. Returns the indirect irradiance at a point of either.
    """
    middle = (np.arange(n) + 0.5) / n
    a, b = (part.ravel() for part in np.meshgrid(middle, middle - 0.5, indexing="ij"))
    zero = np.zeros_like(a)
    patches = {"floor": np.stack([a, zero, b], 1), "wall": np.stack([zero, a, b], 1)}

    def kernel(x, nx, y, ny):
        d = y[None] - x[:, None]
        r2 = np.sum(d * d, axis=2)
        return np.maximum(d @ nx, 0) * np.maximum(-(d @ ny), 0) / (np.pi * r2 * r2) / n**2

    up, right = np.array([0, 1.0, 0]), np.array([1.0, 0, 0])
    to_floor = kernel(patches["floor"], up, patches["wall"], right)
    to_wall = kernel(patches["wall"], right, patches["floor"], up)
    result = []
    for channel in range(3):
        on_floor, on_wall = np.full(n * n, floor_e), np.zeros(n * n)
        for _ in range(40):
            on_floor = floor_e + to_floor @ (wall_albedo[channel] * on_wall)
            on_wall = to_wall @ (floor_albedo[channel] * on_floor)
        at_floor = kernel(np.float64([floor]), up, patches["wall"], right)
        at_wall = kernel(np.float64([wall]), right, patches["floor"], up)
        result.append(
            [
                (at_floor @ (wall_albedo[channel] * on_wall))[0],
                (at_wall @ (floor_albedo[channel] * on_floor))[0],
            ]
        )
    return np.array(result).T


@pytest.mark.parametrize("floor_is_neural", [True, False])
def test_colour_bleeds_from_a_red_wall_to_a_white_asset_and_back(floor_is_neural):
    """Against the radiosity of many patches. The sun shines past the wall, along it."""
    half = square(0.5)
    red, white = (0.8, 0.05, 0.05), (0.9, 0.9, 0.9)
    neural, plain = LambertAsset(half, albedo=white), made_of(half, base_color=white)
    floor = neural if floor_is_neural else plain
    wall = made_of(half, base_color=red)
    objects = [
        (floor, {"translation": (0.5, 0, 0)}),
        (wall, {"translation": (0, 0.5, 0), "rotation_deg": (0, 0, -90)}),
    ]
    # Straight down: along the wall, which it lights nowhere.
    sun = {"type": "directional", "direction": (0, 1, 0), "irradiance": (1, 1, 1)}
    on_floor, on_wall = (0.4, 0, 0.1), (0, 0.4, 0.1)
    floor_e, wall_e = radiosity(on_floor, on_wall, 1.0, white, red)
    for point, expected in (
        (on_floor, np.array(white) / np.pi * (1 + floor_e)),
        (on_wall, np.array(red) / np.pi * wall_e),
    ):
        camera = at_point(point, (2, 2, 1))
        actual = seen(shoot(objects, [sun], camera=camera, max_depth=16, samples=24))
        assert_is(actual, expected, relative=0.01)
    # On the floor red is more than blue, by light that came from the wall.
    assert floor_e[0] > 10 * floor_e[2] > 0


def test_ways_of_finding_light_agree_in_a_furnished_room():
    """A ball, a floor and an asset under a disk, a sky and a lamp that is a mesh."""
    lamp = made_of(flat(square(0.4)), base_color=(0.1, 0.1, 0.1), emission=(3, 2, 1))
    objects = [
        (made_of(square(3.0), base_color=(0.6, 0.7, 0.8)), {"translation": (0, -1, 0)}),
        (made_of(sphere(3), base_color=(0.9, 0.8, 0.5), metallic=1.0, roughness=0.5), {}),
        (LambertAsset(sphere(3), albedo=(0.8, 0.5, 0.2)), {"translation": (1.6, 0, 0)}),
        (lamp, {"translation": (-1.5, 0.5, 0), "rotation_deg": (0, 0, -90)}),
    ]
    disk = {
        "type": "disk",
        "position": (0, 2.5, 1),
        "look_at": (0, 0, 0),
        "radius": 1,
        "radiance": (2, 2, 2),
    }
    lights = [disk, SKY | {"radiance": (0.3, 0.4, 0.5)}]
    camera = {**WIDE, "position": (0, 1, 6)}
    settings = {"camera": camera, "max_depth": 5, "resolution": (36, 24), "samples": 32}
    images = {way: shoot(objects, lights, way, seed=len(way), **settings) for way in WAYS}
    mean = {way: rgb(channels).astype(np.float64) for way, channels in images.items()}
    variance = {
        way: np.stack([channels[f"variance.{c}"] for c in "RGB"], axis=-1)
        for way, channels in images.items()
    }
    for way in ("lights", "rays"):
        off = mean[way] - mean["both"]
        # The means of 32 samples are not quite normal where light is rare.
        assert np.mean(off**2 > 9 * (variance[way] + variance["both"]) + 1e-9) < 0.02
        error = np.sqrt(np.sum(variance[way] + variance["both"], axis=(0, 1))) / off[..., 0].size
        assert (np.abs(off.mean(axis=(0, 1))) < 3 * error).all()
        assert (error < 0.02 * mean["both"].mean(axis=(0, 1))).all()
    # Shared by both ways, light is found with less noise.
    noise = {way: np.sqrt(values).mean() for way, values in variance.items()}
    assert noise["both"] < min(noise["lights"], noise["rays"])

"""Radiance of images of fibers, alone and among surfaces."""

import numpy as np
import pytest

from rna_render.paths.bands import render
from rna_render.paths.integrator_factory import make_integrator
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import read_scene
from rna_render.scene.scene_model import TransformModel
from rna_render.scene.transforms import world_from_object
from tests.render.assets import FiberProbe, LambertAsset, sphere, square
from tests.render.packages import SHADOWED, write_offset_package
from tests.render.stage import SKY, SUN, WHITE, image, rgb
from tests.render.strands import curls, straight

SHADOW_COLOUR = (0.0, 0.0, 7.0)
FACING = {"position": (0, 0, 20), "look_at": (0, 0, 0), "vertical_fov_deg": 2}
LEGS = ((-1, 0, 0), (0, 0, 0), (1, 0, 0)), ((1, 1, 0), (0, 1, 0), (-1, 1, 0))


def pole(radius: float = 0.5) -> FiberProbe:
    """One thick strand up the y axis."""
    return FiberProbe(straight(((0, -3, 0), (0, 0, 0), (0, 3, 0)), radius=radius), SHADOW_COLOUR)


def vectors(channels, name: str) -> np.ndarray:
    return np.stack([channels[f"{name}.{axis}"] for axis in "XYZ"], axis=-1).astype(np.float64)


def test_the_asset_is_asked_with_tangent_and_offset():
    """Seen from +z with the tangent up, t x wo is +x: h is the place across, in radii."""
    light = SUN | {"direction": (3, 4, 0)}
    channels = image([(pole(), {})], [light], camera=FACING, samples=1)
    assert (channels["A"] == 1).all()
    np.testing.assert_allclose(channels["R"], 0.6, rtol=1e-5)
    x = vectors(channels, "position")
    wo = np.array([0, 0, 20]) - x
    wo /= np.linalg.norm(wo[..., [0, 2]], axis=-1, keepdims=True)
    h = (x[..., 0] * wo[..., 2] - x[..., 2] * wo[..., 0]) / 0.5
    assert h.min() < -0.8 and h.max() > 0.8
    np.testing.assert_allclose(2 * channels["G"] - 1, h, atol=1e-5)


def test_light_from_behind_its_own_strand_is_seen():
    light = SUN | {"direction": (0.3, 0.2, -1)}
    channels = image([(pole(), {})], [light], camera=FACING)
    assert (channels["visibility"] == 1).all() and (channels["B"] < 1).all()


TURN = {"rotation_deg": (20, 30, 40)}


@pytest.mark.parametrize("scale", [0.05, 1.0, 30.0])
def test_scale_and_turn_change_no_radiance(scale):
    """Camera and light are turned and moved with the curls."""
    asset = FiberProbe(curls(30, radius=0.05), SHADOW_COLOUR)
    light, camera = np.array([1, 2, 3]), np.array([0.0, 0, 4])
    there = image([(asset, {})], [SUN | {"direction": light}], camera=FACING | {"position": camera})
    transform = {**TURN, "scale": scale, "translation": (0.1, 0.2, 0.3)}
    matrix = world_from_object(TransformModel.model_validate(transform))
    moved = {
        "position": matrix[:3, :3] @ camera + matrix[:3, 3],
        "look_at": matrix[:3, 3],
        "up": matrix[:3, 1] / scale,
        "vertical_fov_deg": 2,
    }
    here = image([(asset, transform)], [SUN | {"direction": matrix[:3, :3] @ light}], camera=moved)
    same = np.isclose(rgb(here), rgb(there), rtol=1e-2, atol=1e-3).all(axis=-1)
    assert same.mean() > 0.95 and np.unique(rgb(there)).size > 100
    turned = vectors(there, "normal") @ (matrix[:3, :3] / scale).T
    assert np.median(np.abs(vectors(here, "normal") - turned)) < 1e-3


def test_normals_and_positions_are_those_of_the_placed_strand():
    """A strand along z of radius 0.5, scaled to 1 and moved: its axis is x = 0.3, y = 0.2."""
    placed = {"rotation_deg": (90, 0, 0), "scale": 2.0, "translation": (0.3, 0.2, 0)}
    camera = {"position": (0.3, 20, 0), "look_at": (0.3, 0, 0), "up": (0, 0, 1)}
    camera["vertical_fov_deg"] = 4
    channels = image([(pole(), placed)], [SUN], camera=camera, samples=1)
    off_axis = vectors(channels, "position") - [0.3, 0.2, 0]
    off_axis[..., 2] = 0
    np.testing.assert_allclose(np.linalg.norm(off_axis, axis=-1), 1, rtol=1e-5)
    np.testing.assert_allclose(vectors(channels, "normal"), off_axis, atol=1e-4)
    assert (off_axis[..., 1] > 0).all() and np.ptp(off_axis[..., 0]) > 1


@pytest.mark.parametrize("floors", [0, 1])
def test_a_white_furnace_is_white(floors):
    """A transport of 1 / 4 pi in all directions sends back all that comes in, as a floor does."""
    asset = FiberProbe(curls(40, radius=0.05), (0, 0, 1 / (4 * np.pi)))
    floor = LambertAsset(square(size=0.3), albedo=WHITE), {"translation": (0, -1, 0)}
    sky = SKY | {"visible_to_camera": False}
    channels = image([(asset, {}), *[floor] * floors], [sky], samples=256, max_depth=32)
    assert 0.3 < channels["A"].mean() < 1
    hit = channels["A"] > 0.2
    assert abs((channels["B"][hit] / channels["A"][hit]).mean() - 1) < 5e-3


def test_another_strand_shadows_but_its_own_does_not():
    """Two legs, one over the other: as strands of their own, and as one hairpin."""
    camera = FACING | {"position": (-0.5, 0, 20), "look_at": (-0.5, 0, 0), "vertical_fov_deg": 0.3}
    for curves, seen in ((straight(*LEGS), 0), (straight(LEGS[0] + LEGS[1]), 1)):
        channels = image([(FiberProbe(curves, SHADOW_COLOUR), {})], [SUN], camera=camera)
        assert (channels["A"] == 1).all() and (channels["visibility"] == seen).all()
        blue = 1 / (4 * np.pi) if seen else 7.0
        np.testing.assert_allclose(channels["B"], blue, rtol=1e-6)


def test_fibers_and_surfaces_shadow_one_another():
    """What lies at y = 0, under something at y = 1 or over it, seen from the side between."""
    log = FiberProbe(straight(((-9, 0, 0), (9, 0, 0)), radius=0.2))
    floor = LambertAsset(square(size=5.0), albedo=WHITE)
    lid = LambertAsset(square(size=5.0))
    camera = {"position": (0, 0.5, 8), "look_at": (0, 0, 0), "vertical_fov_deg": 0.1}
    for below, above in ((log, lid), (floor, log), (log, log)):
        for height, blocked in ((1.0, True), (-1.0, False)):
            placed = [(below, {}), (above, {"translation": (0, height, 0)})]
            channels = image(placed, [SUN], camera=camera, max_depth=1)
            assert (channels["assetId"] == 1).all()
            assert (channels["visibility"] == (not blocked)).all()
            assert ((channels["R"] == 0) == blocked).all()


def test_kinds_may_be_mixed_in_any_order():
    """Balls and poles side by side; the picture names each as the file does."""
    ball = LambertAsset(sphere(3, radius=0.4))
    assets = [pole(0.2), ball, pole(0.2), ball]
    assets[2] = assets[0]
    placed = [(a, {"translation": (x, 0, 0)}) for a, x in zip(assets, (3, 1, -1, -3), strict=True)]
    camera = FACING | {"vertical_fov_deg": 20}
    light = SUN | {"direction": (0.1, 0, 1)}
    channels = image(placed, [light], camera=camera, resolution=(64, 48), max_depth=1)
    middle = channels["assetId"][24]
    order = [number for number, before in zip(middle[1:], middle, strict=False) if number != before]
    assert [number for number in order if number] == [4, 3, 2, 1]
    for number in (1, 3):
        strand = channels["assetId"] == number
        np.testing.assert_allclose(channels["R"][strand] / channels["A"][strand], 1, atol=1e-5)


def test_a_fiber_package_is_rendered_as_its_asset(tmp_path):
    """Equal curls, from a file through the runtime and as a probe: once blue for shadowed."""
    curves = curls(40, radius=0.05)
    write_offset_package(tmp_path / "curls.rna", curves)
    (tmp_path / "scene.yaml").write_text(
        "assets: [{path: curls.rna, transform: {rotation_deg: [20, 30, 40]}}]\n"
        "camera: {position: [0, 4, 0], look_at: [0, 0, 0], up: [0, 0, -1], vertical_fov_deg: 20}\n"
        "lights: [{type: directional, direction: [0, 1, 0], irradiance: [1, 1, 1]}]\n"
        "resolution: [16, 12]\n"
        "samples: 4\n"
    )
    scene_file = read_scene(tmp_path / "scene.yaml")
    film = render(scene_file.scene, make_integrator(scene_file.scene, load_world(scene_file)))
    expected = image([(FiberProbe(curves, SHADOWED), TURN)], [SUN])
    assert 0.2 < expected["A"].mean() < 1 and np.ptp(expected["visibility"]) == 1
    np.testing.assert_allclose(film.channels()["G"], expected["G"], atol=1e-4)
    for name in ("A", "visibility", "assetId", "normal.X", "position.Z"):
        np.testing.assert_array_equal(film.channels()[name], expected[name], err_msg=name)

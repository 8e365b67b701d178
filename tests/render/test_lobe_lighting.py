"""Environments by lobes: where the lobes are exact, the light is that of rays alone."""

from __future__ import annotations

import numpy as np
import pytest

from rna_render.command.devices import check_device
from rna_render.image.images import write_exr
from rna_render.scene.scene_file import read_scene
from rna_sdk.errors import SceneError
from tests.render.assets import LobedAsset, sphere, square
from tests.render.studio import at_point, made_of, seen, shoot
from tests.render.test_prefilter import texels

GREY = {"base_color": (0.4, 0.3, 0.2)}
# Of the side of the ball that faces the other objects.
CAMERA = at_point((0.6, 0.1, 0.75), (2.0, 1.2, 3.0))
EVEN = {"type": "environment", "radiance": (1.0, 2.0, 0.5)}
SUN = {"type": "directional", "direction": (1, 1, 1), "irradiance": (1.0, 1.0, 1.0)}


@pytest.fixture(scope="module")
def sky(tmp_path_factory):
    path = tmp_path_factory.mktemp("sky") / "sky.exr"
    write_exr(path, dict(zip("RGB", np.moveaxis(texels(), -1, 0), strict=True)), {})
    return {"type": "environment", "path": path, "rotation_deg": 40.0, "radiance": (1, 0.9, 0.8)}


def ball():
    return LobedAsset(sphere(3)), {"rotation_deg": (10, 20, 30)}


SURROUNDINGS = {
    "nothing": [],
    "a ground": [(made_of(square(20.0, height=-1.0), **GREY), {})],
    "a pane that is there in part": [
        (made_of(square(20.0, height=-1.0), **GREY), {}),
        (
            made_of(square(3.0), base_color=(0.9, 0.5, 0.3), opacity=0.5),
            {"translation": (2.0, 0.0, 1.0), "rotation_deg": (0, 0, 80)},
        ),
    ],
    "coloured glass": [
        (
            made_of(
                square(3.0),
                base_color=(0.9, 0.5, 0.3),
                roughness=0.03,
                transmission=1.0,
                coat_f0=0.04,
            ),
            {"translation": (2.0, 0.0, 1.0), "rotation_deg": (0, 0, 80)},
        )
    ],
    "another asset": [(LobedAsset(sphere(2)), {"translation": (1.5, 0.0, 1.5), "scale": 0.6})],
}


def both(lights, things, **changes):
    settings = {"camera": CAMERA, "max_depth": 3, "samples": 64, "resolution": (24, 24)} | changes
    scene_objects = [ball(), *things]
    by_rays = seen(shoot(scene_objects, lights, **settings))
    return by_rays, seen(shoot(scene_objects, lights, lobes=True, **settings))


def assert_equal(by_rays, by_lobes, relative):
    spread = 3.5 * np.hypot(by_rays.error, by_lobes.error)
    assert (spread < 0.02 * by_rays.mean).all(), f"too noisy: {by_rays}, {by_lobes}"
    off = np.abs(by_lobes.mean - by_rays.mean)
    assert (off < spread + relative * by_rays.mean).all(), f"{by_rays}, {by_lobes}"


@pytest.mark.parametrize("name", SURROUNDINGS)
def test_under_an_even_sky_lobes_change_nothing_but_noise(name):
    by_rays, by_lobes = both([EVEN], SURROUNDINGS[name])
    assert_equal(by_rays, by_lobes, 1e-3)


@pytest.mark.parametrize("name", SURROUNDINGS)
def test_under_an_image_they_change_as_much_as_eight_directions_for_its_lamps(name, sky):
    by_rays, by_lobes = both([sky, SUN], SURROUNDINGS[name])
    assert_equal(by_rays, by_lobes, 0.04)


def test_alone_under_an_even_sky_there_is_no_noise():
    by_rays, by_lobes = both([EVEN], [], samples=1)
    assert by_lobes.error.max() < 1e-3 * by_lobes.mean.min()
    assert by_rays.error.max() > 1e-3 * by_rays.mean.max()


def test_lobes_are_for_the_cpu(tmp_path):
    path = tmp_path / "scene.yaml"
    path.write_text(
        "ground: {}\ncamera: {position: [0, 1, 4], look_at: [0, 0, 0]}\n"
        "quality: {environment: lobes}\n"
    )
    with pytest.raises(SceneError, match=r"quality\.environment: lobes are for the CPU"):
        check_device("gpu", read_scene(path))

"""Which light a sample goes to, and what makes a light of a scene file's words."""

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from pydantic import ValidationError

from rna_render.image.images import write_exr
from rna_render.lights import LightSelection, make_light
from rna_render.scene import (
    CameraModel,
    EnvironmentModel,
    GroundModel,
    LightModel,
    Scene,
    SceneFile,
)
from rna_sdk.errors import SceneError
from tests.render.lights import light


def point(strength: float):
    return light("point", position=(0, 0, 0), intensity=(strength,) * 3)


def test_half_goes_by_power_and_half_evenly():
    selection = LightSelection([point(1), point(0), point(3)], 1.0)
    np.testing.assert_allclose(selection.probability, [0.375, 0, 0.625])
    assert selection.probability.dtype == np.float64


def test_choices_follow_the_probability():
    selection = LightSelection([point(1), point(0), point(3), point(0)], 1.0)
    chosen = selection.choose((np.arange(10_000) + 0.5) / 10_000)
    counts = np.bincount(chosen, minlength=4) / 10_000
    np.testing.assert_allclose(counts, selection.probability, atol=1e-4)
    assert selection.choose(np.array([0.0, 1 - 2**-53])).tolist() == [0, 2]


def test_the_sum_is_one_and_the_last_number_finds_a_light():
    lights = [point(value) for value in np.random.default_rng(1).random(1000)]
    selection = LightSelection(lights, 1.0)
    assert selection.probability.sum() == pytest.approx(1, abs=1e-12)
    assert selection.choose(np.array([np.nextafter(1.0, 0.0)])).tolist() == [999]


def test_lights_of_far_away_grow_with_the_scene():
    lights = [point(1), light("environment", radiance=(1, 1, 1))]
    small, large = (LightSelection(lights, radius).probability for radius in (0.1, 10.0))
    assert small[1] < large[1] and large[0] > 0.25


def test_no_power_and_no_lights():
    dark = LightSelection([point(0), point(0)], 1.0)
    assert dark.probability.tolist() == [0.5, 0.5]
    assert dark.choose(np.array([0.2, 0.7])).tolist() == [0, 1]
    none = LightSelection([], 1.0)
    assert none.probability.shape == (0,)
    assert none.choose(np.array([0.2, 0.7])).tolist() == [-1, -1]


def test_great_powers_do_not_overflow():
    bright: Any = [SimpleNamespace(power=lambda radius: 1e308)] * 2
    np.testing.assert_allclose(LightSelection(bright, 1.0).probability, [0.5, 0.5])


def test_an_image_is_found_beside_the_scene_file(tmp_path):
    write_exr(tmp_path / "sky.exr", {name: np.ones((2, 4), np.float32) for name in "RGB"}, {})
    model = EnvironmentModel(type="environment", path=Path("sky.exr"))
    sky = make_light(_read_in(tmp_path, model))
    assert sky.eval_environment(np.float32([[0, 1, 0]]))[0].tolist() == [[1, 1, 1]]
    with pytest.raises(SceneError, match=r"nowhere.sky\.exr: cannot read the image"):
        make_light(_read_in(tmp_path / "nowhere", model))


def _read_in(folder: Path, model: EnvironmentModel) -> LightModel:
    """The light as a scene file in the folder has it."""
    camera = CameraModel(position=(0, 0, 1), look_at=(0, 0, 0))
    scene = Scene(camera=camera, lights=(model,), ground=GroundModel())
    return SceneFile(folder / "scene.yaml", scene, {}).resolved.lights[0]


def test_every_light_keeps_its_group_and_whether_the_camera_sees_it(tmp_path):
    write_exr(tmp_path / "sky.exr", {name: np.ones((2, 4), np.float32) for name in "RGB"}, {})
    aimed = {"position": (0, 0, 1), "look_at": (0, 0, 0)}
    shining = {**aimed, "radiance": (1, 1, 1), "visible_to_camera": False}
    sun = {"direction": (0, 1, 0), "irradiance": (1, 1, 1)}
    made = [
        light("directional", **sun, group="key"),
        light("directional", **sun, angular_diameter_deg=1, group="key"),
        light("point", position=(0, 0, 0), intensity=(1, 1, 1), group="key"),
        light("spot", **aimed, intensity=(1, 1, 1), group="key"),
        light("rectangle", **shining, size=(1, 1), group="key"),
        light("disk", **shining, radius=1, group="key"),
        light("sphere", position=(0, 0, 0), radiance=(1, 1, 1), radius=1, group="key"),
        light("environment", visible_to_camera=False, group="key"),
        light("environment", path=tmp_path / "sky.exr", visible_to_camera=False, group="key"),
    ]
    assert {of.group for of in made} == {"key"}
    seen = [of.visible_to_camera for of in made if hasattr(of, "visible_to_camera")]
    assert seen == [False, False, False, True, False, False]


AIMED = {"position": (1, 1, 1), "look_at": (0, 0, 0)}
AIMLESS = {"position": (1, 1, 1), "look_at": (1, 1, 1)}
SPOT = {"type": "spot", "intensity": (1, 1, 1)}
RECTANGLE = {"type": "rectangle", "radiance": (1, 1, 1), "size": (1, 1)}
DISK = {"type": "disk", "radiance": (1, 1, 1), "radius": 1}
NO_CONE = "inner_angle_deg, 30, must not be more than outer_angle_deg, 20"
NO_AIM = "position and look_at are the same point"
NO_UP = "up must not be zero or along the line"


@pytest.mark.parametrize(
    ("message", "fields"),
    [
        (NO_CONE, {**SPOT, **AIMED, "outer_angle_deg": 20}),
        (NO_AIM, {**SPOT, **AIMLESS}),
        (NO_AIM, {**RECTANGLE, **AIMLESS}),
        (NO_AIM, {**DISK, **AIMLESS}),
        (NO_UP, {**RECTANGLE, **AIMED, "up": (2, 2, 2)}),
        (NO_UP, {**RECTANGLE, **AIMED, "up": (0, 0, 0)}),
    ],
)
def test_lights_that_make_no_sense_are_refused(message, fields):
    with pytest.raises(ValidationError, match=message):
        light(**fields)

"""The preview's camera and lights: where changes lead them."""

import numpy as np
import pytest

from rna_render.preview.lighting import Lighting, lighting_choices, lit, turned
from rna_render.preview.orbit import MAX_ELEVATION, Orbit
from rna_render.scene.light_models import DirectionalModel, EnvironmentModel, PointModel
from rna_render.scene.scene_model import CameraModel, Scene
from rna_render.world.camera import Camera

LOOK_AT = (1.0, 2.0, -3.0)
UPS = [(0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, -2.0), (1.0, 0.0, 0.0), (0.3, 0.8, -0.5)]


def camera(offset=(1.0, 0.5, 4.0), up=(0.0, 1.0, 0.0)) -> CameraModel:
    return CameraModel(position=np.add(LOOK_AT, offset), look_at=LOOK_AT, up=up)


@pytest.mark.parametrize("up", UPS)
def test_an_orbit_begins_at_the_scenes_own_camera(up):
    model = camera(up=up)
    there = Orbit.of(model).camera()
    np.testing.assert_allclose(there.position, model.position, rtol=1e-12)
    assert there.model_copy(update={"position": model.position}) == model


def test_azimuth_turns_counter_clockwise_seen_from_above():
    start = Orbit.of(camera(offset=(0, 0, 2)))
    there = start.turned(np.radians(90), 0.0).camera()
    np.testing.assert_allclose(np.subtract(there.position, LOOK_AT), (2, 0, 0), atol=1e-12)


def test_elevation_goes_up_and_stops_before_the_pole():
    start = Orbit.of(camera(offset=(0, 0, 2)))
    half = start.turned(0.0, np.radians(45)).camera()
    np.testing.assert_allclose(
        np.subtract(half.position, LOOK_AT), (0, np.sqrt(2), np.sqrt(2)), atol=1e-12
    )
    for sign in (1, -1):
        top = start.turned(0.0, sign * 10.0)
        assert top.elevation == pytest.approx(sign * MAX_ELEVATION)
        CameraModel.model_validate(top.camera().model_dump())


def test_a_scene_that_begins_nearer_to_the_pole_stays_there():
    start = Orbit.of(camera(offset=(0, 1, 1e-3)))
    assert start.elevation > MAX_ELEVATION
    assert start.turned(0.5, 0.0).elevation == start.elevation
    assert start.turned(0.0, 0.5).elevation == start.elevation


@pytest.mark.parametrize("up", UPS)
def test_turning_keeps_the_distance_and_there_and_back_is_nothing(up):
    start = Orbit.of(camera(up=up))
    there = start.turned(1.2, -0.2)
    distance = np.linalg.norm(np.subtract(there.camera().position, LOOK_AT))
    assert distance == pytest.approx(start.distance)
    back = there.turned(-1.2, 0.2).camera()
    np.testing.assert_allclose(back.position, camera(up=up).position, atol=1e-12)


def test_dolly_multiplies_the_distance_and_never_reaches_the_target():
    start = Orbit.of(camera(offset=(0, 0, 2)))
    there = start.dollied(0.5).camera()
    np.testing.assert_allclose(there.position, np.add(LOOK_AT, (0, 0, 1)))
    near = start
    for _ in range(100):
        near = near.dollied(0.01)
    assert near.camera().position != near.camera().look_at


@pytest.mark.parametrize("up", UPS)
def test_pan_by_one_moves_the_target_by_the_images_height(up):
    """What was in the middle of the image is at its upper edge after a move down by a half."""
    start = Orbit.of(camera(up=up))
    moved = start.panned(0.0, -0.5)
    model = moved.camera()
    view = Camera(model, (1, 1))
    d = view.directions(np.zeros(1, np.uint32), np.array([[0.5, 0.0]]))[0]
    to_old_target = np.subtract(LOOK_AT, model.position)
    np.testing.assert_allclose(d, to_old_target / np.linalg.norm(to_old_target), atol=1e-6)
    assert moved.distance == pytest.approx(start.distance)


def test_lights_turn_about_the_vertical_through_the_target():
    lights = (
        DirectionalModel(type="directional", direction=(0, 1, 1), irradiance=(1, 1, 1)),
        PointModel(type="point", position=(1, 2, -1), intensity=(1, 1, 1)),
        EnvironmentModel(type="environment", radiance=(1, 1, 1)),
    )
    sun, point, sky = turned(lights, 90.0, LOOK_AT)
    np.testing.assert_allclose(sun.direction, (1, 1, 0), atol=1e-12)
    np.testing.assert_allclose(point.position, (3, 2, -3), atol=1e-12)
    assert sky.radiance == (1, 1, 1)
    for there, light in zip(turned((sun, point), -90.0, LOOK_AT), lights, strict=False):
        for name in {"direction", "position"} & type(light).model_fields.keys():
            np.testing.assert_allclose(getattr(there, name), getattr(light, name), atol=1e-12)


def test_a_choice_replaces_the_scenes_lights(tmp_path):
    sun = DirectionalModel(type="directional", direction=(0, 1, 0), irradiance=(1, 1, 1))
    scene = Scene(assets=[{"path": "a.rna"}], camera=camera(), lights=[sun])
    choices = lighting_choices(tmp_path / "scene.yaml")
    assert lit(scene, choices["scene"], 0.0) == scene
    (white,) = lit(scene, choices["white"], 0.0).lights
    assert white.radiance == (1, 1, 1)
    assert lit(scene, Lighting("none", ()), 0.0).lights == ()


def test_images_beside_the_scene_and_in_a_folder_are_choices(tmp_path):
    from rna_render.image.images import write_exr

    more = tmp_path / "more"
    more.mkdir()
    plane = {"Y": np.ones((2, 4), np.float32)}
    write_exr(tmp_path / "sky.exr", plane, {})
    write_exr(tmp_path / "out.exr", plane, {"rnaScene": "{}"})
    (tmp_path / "broken.EXR").write_bytes(b"no image")
    (more / "studio.hdr").write_bytes(b"")
    (more / "same.exr").symlink_to(tmp_path / "sky.exr")
    choices = lighting_choices(tmp_path / "scene.yaml", more)
    images = {c.label: c.lights[0] for key, c in choices.items() if key.startswith("image-")}
    assert list(images) == ["broken", "sky", "studio"]
    assert images["sky"].path == tmp_path / "sky.exr"
    (sky,) = turned((images["sky"],), 30.0, LOOK_AT)
    assert sky.rotation_deg == 30.0

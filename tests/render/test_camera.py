"""Rays of the camera."""

import numpy as np
import pytest

from rna_render.scene.scene_model import CameraModel
from rna_render.world.camera import Camera

MODEL = CameraModel(position=(0, 0, 5), look_at=(0, 0, 0), vertical_fov_deg=90)


def direction(camera: Camera, column: int, row: int, u=(0.5, 0.5)) -> np.ndarray:
    pixel = np.uint32([row * camera.width + column])
    return camera.directions(pixel, np.array([u]))[0]


def test_the_middle_of_the_image_is_the_point_looked_at():
    np.testing.assert_allclose(direction(Camera(MODEL, (3, 3)), 1, 1), [0, 0, -1], atol=1e-7)


def test_the_image_is_upright_and_not_mirrored():
    camera = Camera(MODEL, (4, 4))
    assert direction(camera, 0, 0)[1] > 0 > direction(camera, 0, 3)[1]
    assert direction(camera, 3, 0)[0] > 0 > direction(camera, 0, 0)[0]


def test_the_angle_is_from_the_top_edge_to_the_bottom_edge():
    camera = Camera(MODEL, (400, 2))
    top = direction(camera, 200, 0, (0.0, 0.0))
    np.testing.assert_allclose(top, np.sqrt([0, 0.5, 0.5]) * [0, 1, -1], atol=1e-6)
    # Pixels are square: an image twice as wide sees twice the tangent.
    corner = direction(camera, 0, 0, (0.0, 0.0))
    np.testing.assert_allclose(corner[0] / corner[2], 200, rtol=1e-5)


def test_up_may_be_any_vector_off_the_line_of_sight():
    tilted = MODEL.model_copy(update={"up": (1.0, 0.0, 7.0)})
    assert direction(Camera(tilted, (1, 4)), 0, 0)[0] > 0


def test_height_of_a_ball_is_that_of_its_outline():
    """At two radii from its middle a ball is seen within 30 degrees of it."""
    camera = Camera(MODEL, (300, 200))
    heights = camera.heights(np.array([(0.0, 0.0, 3.0), (0.0, 0.0, -995.0)]), np.array([1.0, 1.0]))
    np.testing.assert_allclose(heights, [200 * np.tan(np.radians(30)), 0.2], rtol=1e-3)


def test_a_ball_that_the_image_does_not_show_has_no_height():
    camera = Camera(MODEL, (200, 200))
    # Behind, left of it, above it, across its edge, around the camera.
    centres = np.array([(0, 0, 9), (-8, 0, 0), (0, 7, 0), (-5.5, 0, 0), (0, 0, 5.5)], float)
    shown = camera.heights(centres, np.ones(5))
    assert shown.tolist() == [0, 0, 0, pytest.approx(200 / np.sqrt(24)), np.inf]


def lens(aperture: float, focus: float | None = None) -> Camera:
    return Camera(MODEL.model_copy(update={"aperture": aperture, "focus": focus}), (8, 8))


def test_a_pinhole_has_no_lens():
    assert not Camera(MODEL, (8, 8)).has_lens and lens(0.1).has_lens


@pytest.mark.parametrize("focus", [None, 2.0])
def test_rays_of_a_lens_meet_the_pinholes_ray_on_the_sharp_plane(focus):
    camera, u = lens(0.4, focus), np.random.default_rng(0).random((500, 2))
    straight = np.tile(direction(camera, 1, 6), (500, 1))
    origins, directions = camera.through_lens(straight, u)
    np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1.0, rtol=1e-6)
    np.testing.assert_allclose(origins[:, 2], 5.0, atol=1e-6)  # of the lens, which faces -z
    distance = focus or 5.0
    at = origins - directions * (distance / directions[:, 2])[:, None]
    expected = camera.position - straight[0] * distance / straight[0, 2]
    np.testing.assert_allclose(at, np.tile(expected, (500, 1)), atol=1e-5)


def test_points_on_a_lens_are_uniform_by_area_and_fill_it():
    """The second moment of a disk's radius is half of its square."""
    camera, u = lens(0.4), np.random.default_rng(1).random((20000, 2))
    ahead = np.tile(np.float32([0, 0, -1]), (len(u), 1))
    origins, _ = camera.through_lens(ahead, u)
    offset = origins - camera.position
    radius = np.hypot(offset[:, 0], offset[:, 1])
    assert radius.max() == pytest.approx(0.2, rel=0.01) and radius.max() <= 0.2 + 1e-6
    assert (radius**2).mean() == pytest.approx(0.5 * 0.2**2, rel=0.02)
    np.testing.assert_allclose(offset.mean(axis=0), 0.0, atol=4e-3)

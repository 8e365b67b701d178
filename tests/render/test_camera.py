"""Rays of the camera."""

from __future__ import annotations

import numpy as np

from rna_render.camera import Camera
from rna_render.scene_model import CameraModel

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

"""Matrices of scene files' transforms."""

import numpy as np
import pytest

from rna_render.scene.scene_model import TransformModel
from rna_render.scene.transforms import as_transform, world_from_object

X, Y, Z = np.eye(3)


def turned(vector, **transform) -> np.ndarray:
    return world_from_object(TransformModel(**transform))[:3, :3] @ vector


@pytest.mark.parametrize(
    ("degrees", "before", "after"), [((90, 0, 0), Y, Z), ((0, 90, 0), Z, X), ((0, 0, 90), X, Y)]
)
def test_turns_are_counter_clockwise(degrees, before, after):
    np.testing.assert_allclose(turned(before, rotation_deg=degrees), after, atol=1e-12)


def test_turns_go_about_x_then_y_then_z():
    np.testing.assert_allclose(turned(Y, rotation_deg=(90, 90, 0)), X, atol=1e-12)
    np.testing.assert_allclose(turned(Y, rotation_deg=(90, 0, 90)), Z, atol=1e-12)


def test_a_quaternion_is_the_same_rotation():
    half = np.radians(50) / 2
    for axis, degrees in ((X, (50, 0, 0)), (Y, (0, 50, 0)), (Z, (0, 0, 50))):
        quaternion = (*(3 * np.sin(half) * axis), 3 * np.cos(half))
        by_angle = world_from_object(TransformModel(rotation_deg=degrees))
        by_quaternion = world_from_object(TransformModel(quaternion=quaternion))
        np.testing.assert_allclose(by_quaternion, by_angle, atol=1e-12)


def test_scale_comes_first_and_translation_last():
    matrix = world_from_object(
        TransformModel(translation=(1, 2, 3), rotation_deg=(0, 0, 90), scale=2)
    )
    np.testing.assert_allclose(matrix @ [1, 0, 0, 1], [1, 4, 3, 1], atol=1e-12)


@pytest.mark.parametrize("scale", [1.0, 0.02, -3.0])
def test_the_transform_of_a_matrix(scale):
    """There and back, also of half turns, where rotations have no w."""
    for quaternion in [(0.1, -0.7, 0.3, 0.5), (0, 0, 1, 0), (1, 0, 0, 0), (0, 0, 0, 1)]:
        model = TransformModel(translation=(1, -2, 3), quaternion=quaternion, scale=scale)
        matrix = world_from_object(model)
        assert as_transform(matrix).scale == pytest.approx(scale)
        np.testing.assert_allclose(world_from_object(as_transform(matrix)), matrix, atol=1e-14)

"""Between object space and world space."""

import numpy as np
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.runtime import Transform
from tests.runtime.points import random_points, unit_vectors


def turned(scale: float = 1.0, seed: int = 0) -> np.ndarray:
    """A random rotation with scale and translation."""
    rotation, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    matrix = np.eye(4)
    matrix[:3, :3] = scale * rotation * np.sign(np.linalg.det(rotation))
    matrix[:3, 3] = [10, -20, 300]
    return matrix


@pytest.mark.parametrize("mirror", [1, -1])
@pytest.mark.parametrize("scale", [1e-3, 1.0, 50.0])
def test_there_and_back(scale, mirror):
    transform = Transform(turned(scale) @ np.diag([mirror, 1, 1, 1]))
    assert transform.scale == pytest.approx(scale)
    points = random_points(500)
    world = transform.to_world_points(points.positions)
    assert world.dtype == np.float32
    tolerance = 4e-5 / scale + 1e-6  # float32 world coordinates of up to 300
    np.testing.assert_allclose(transform.to_object_points(world), points.positions, atol=tolerance)
    for there, back in (
        (transform.to_world_directions, transform.to_object_directions),
        (transform.to_world_normals, transform.to_object_normals),
    ):
        np.testing.assert_allclose(back(there(points.wi)), points.wi, atol=3e-7)


def test_points_follow_the_matrix_and_directions_its_rotation():
    matrix = turned(3.0)
    transform = Transform(matrix)
    assert transform.scale == pytest.approx(3.0)
    points = random_points(100)
    homogeneous = np.concatenate([points.positions, np.ones((100, 1))], axis=1)
    np.testing.assert_allclose(
        transform.to_world_points(points.positions), (homogeneous @ matrix.T)[:, :3], rtol=1e-6
    )
    actual = transform.to_world_directions(points.wo)
    np.testing.assert_allclose(actual, points.wo @ (matrix[:3, :3] / 3).T, atol=2e-7)
    np.testing.assert_allclose(np.linalg.norm(actual, axis=1), 1, atol=3e-7)


def test_normals_stay_normal_to_their_surface():
    transform = Transform(turned(0.2, seed=4))
    n = unit_vectors(np.random.default_rng(0), 100)
    tangents = np.cross(n, unit_vectors(np.random.default_rng(1), 100)).astype(np.float32)
    n_world = transform.to_world_normals(n)
    tangents_world = transform.to_world_points(tangents) - transform.to_world_points(0 * n)
    # The difference of points near 300 keeps float32's spacing there.
    np.testing.assert_allclose(np.sum(n_world * tangents_world, axis=1), 0, atol=1e-4)


def test_a_row_does_not_depend_on_the_others():
    transform = Transform(turned(2.0))
    points = random_points(1001).positions
    expected = transform.to_object_points(points)
    parts = [transform.to_object_points(points[i : i + 7]) for i in range(0, 1001, 7)]
    np.testing.assert_array_equal(np.concatenate(parts), expected)


def changed(row: int, column: int, value: float) -> np.ndarray:
    matrix = np.eye(4)
    matrix[row, column] = value
    return matrix


@pytest.mark.parametrize(
    ("matrix", "message"),
    [
        (np.diag([1, 2, 1, 1]), "non-uniform scale"),
        (changed(0, 1, 0.5), "shear"),
        (np.diag([1, 0, 1, 1]), "singular"),
        (np.diag([1, 1, 1, 2]), "last row 0 0 0 1"),
        (changed(3, 0, 0.1), "last row 0 0 0 1"),
        (changed(0, 3, np.nan), "NaN or infinite"),
        (np.eye(3), r"found \(3, 3\)"),
        ("identity", "matrix of numbers"),
        ([[1, 2], [3]], "matrix of numbers"),
    ],
)
def test_any_other_matrix_is_refused(matrix, message):
    with pytest.raises(QueryError, match=message):
        Transform(matrix)  # type: ignore[arg-type]


def test_wrong_arrays_are_refused():
    with pytest.raises(QueryError, match=r"expected a \(n, 3\) float32 array"):
        Transform(np.eye(4)).to_world_points(np.zeros((4, 3)))  # type: ignore[arg-type]

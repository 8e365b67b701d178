"""A package's geometry follows a source mesh, whatever became of the order of its vertices."""

import numpy as np
import pytest

from rna_sdk.errors import MotionError
from rna_sdk.motion import bind
from rna_sdk.package import Curves, Mesh, SourceVertices
from tests.runtime.test_deformation import grid, rotation

SOURCE = grid(12)


def package_of(source: Mesh) -> Mesh:
    """The same surface, its triangles cut in four, every corner a vertex, in another order."""
    p = source.positions[source.triangles].astype(float)
    n = source.normals[source.triangles].astype(float)
    order = np.random.default_rng(0).permutation(4 * len(p))

    def quartered(a: np.ndarray) -> np.ndarray:
        ab, bc, ca = (a[:, i] + a[:, (i + 1) % 3] for i in range(3))
        ab, bc, ca = ab / 2, bc / 2, ca / 2
        rows = [(a[:, 0], ab, ca), (ab, a[:, 1], bc), (ca, bc, a[:, 2]), (ab, bc, ca)]
        return np.concatenate([np.stack(row, axis=1) for row in rows])[order].reshape(-1, 3)

    normals = quartered(n)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    count = 12 * len(p)
    triangles = np.arange(count, dtype=np.uint32).reshape(-1, 3)
    return Mesh(*np.float32([quartered(p), normals]), None, triangles)


def test_a_mesh_follows_a_motion_of_its_source():
    mesh = package_of(SOURCE)
    (binding,) = bind([mesh], SOURCE.positions, SOURCE.triangles)
    np.testing.assert_allclose(binding.positions(SOURCE.positions), mesh.positions, atol=1e-7)
    matrix = rotation(3) @ np.diag([2, 1, 0.5])
    moved = binding.positions(SOURCE.positions @ matrix.T)
    np.testing.assert_allclose(moved, mesh.positions @ matrix.T, atol=1e-6)


def test_a_mesh_follows_the_vertices_that_its_package_names():
    """Two sheets at one place with one normal, which places at rest cannot tell apart."""
    count = len(SOURCE.positions)
    order = np.random.default_rng(3).permutation(count).astype(np.uint32)
    sheet = Mesh(SOURCE.positions[order], SOURCE.normals[order], None, SOURCE.triangles)
    both = np.concatenate([SOURCE.positions, SOURCE.positions])
    triangles = np.concatenate([SOURCE.triangles, SOURCE.triangles + np.uint32(count)])
    known = SourceVertices(order + np.uint32(count), 2 * count)
    (binding,) = bind([sheet], both, triangles, numbers=[known])
    assert binding.by_number
    both[count:] += np.float32([0, 1, 0])
    moved = binding.positions(both)
    np.testing.assert_allclose(moved, sheet.positions + np.float32([0, 1, 0]), atol=1e-6)


def test_places_serve_where_the_source_has_other_vertices_than_the_package_names():
    mesh, (numbers, count) = SOURCE, (np.arange(len(SOURCE.positions)), len(SOURCE.positions))
    for known in (
        SourceVertices(numbers.astype(np.uint32), count + 1),
        SourceVertices(numbers[::-1].astype(np.uint32), count),
    ):
        (binding,) = bind([mesh], SOURCE.positions, SOURCE.triangles, numbers=[known])
        assert not binding.by_number
    other = SourceVertices(numbers.astype(np.uint32), count + 1)
    message = f"it has {count} vertices where the package's had {count + 1}$"
    with pytest.raises(MotionError, match=message):
        bind([mesh], 3 * SOURCE.positions, SOURCE.triangles, numbers=[other])


def test_surfaces_that_touch_part_in_motion():
    """Two sheets back to back: a vertex follows the one whose normal it has."""
    back = Mesh(SOURCE.positions, -SOURCE.normals, None, SOURCE.triangles[:, ::-1].copy())
    count = len(SOURCE.positions)
    both = np.concatenate([SOURCE.positions, SOURCE.positions])
    triangles = np.concatenate([SOURCE.triangles, back.triangles + np.uint32(count)])
    upper, lower = bind([package_of(SOURCE), package_of(back)], both, triangles)
    assert (upper.corners < count).all() and (lower.corners >= count).all()


def test_a_vertex_of_the_source_goes_before_a_triangle_that_touches_it():
    """Another piece ends on a vertex of a smooth sheet, and faces as the vertex's normal does."""
    leaning = np.float32([0.6, 0.8, 0])
    touched = SOURCE.positions[40]
    across = np.float32([[-0.8, 0.6, 0], [0, 0, 1]])
    piece = touched + 0.05 * (np.float32([[-1, -1], [2, -1], [-1, 2]]) @ across)
    if np.cross(piece[1] - piece[0], piece[2] - piece[0]) @ leaning < 0:
        piece = piece[::-1]
    count = len(SOURCE.positions)
    both = np.concatenate([SOURCE.positions, piece.astype(np.float32)])
    triangles = np.concatenate([SOURCE.triangles, np.uint32([[count, count + 1, count + 2]])])
    sheet = Mesh(SOURCE.positions, np.tile(leaning, (count, 1)), None, SOURCE.triangles)
    (binding,) = bind([sheet], both, triangles)
    both[count:] += np.float32([0, 1, 0])
    np.testing.assert_allclose(binding.positions(both)[40], touched, atol=1e-6)


def test_strands_follow_the_motion_of_their_roots():
    roots = SOURCE.positions[::7].astype(float)
    points = np.stack([roots + h * SOURCE.normals[::7] for h in (0, 0.1, 0.2)], axis=1)
    offsets = np.arange(0, 3 * len(roots) + 1, 3).astype(np.uint32)
    hair = Curves(
        np.float32(points.reshape(-1, 3)), np.full(3 * len(roots), 1e-3, np.float32), offsets
    )
    (binding,) = bind([hair], SOURCE.positions, SOURCE.triangles)
    np.testing.assert_allclose(binding.positions(SOURCE.positions), hair.points, atol=1e-7)
    turn = rotation(5)
    moved = binding.positions(SOURCE.positions @ turn.T + 1)
    np.testing.assert_allclose(moved, hair.points @ turn.T + 1, atol=1e-6)


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (
            SOURCE.positions * 100,
            "walk.glb has not the rest shape of toy.rna: .* 100 times as large",
        ),
        (SOURCE.positions + np.float32([0, 3, 0]), r"its middle is off by \[-?0.0, 3.0, -?0.0\] m"),
        (SOURCE.positions @ rotation(1).T, "vertices are off its surface, up to"),
    ],
)
def test_a_motion_of_another_shape_is_refused(source, message):
    with pytest.raises(MotionError, match=message):
        bind([package_of(SOURCE)], source, SOURCE.triangles, ("walk.glb", "toy.rna"))

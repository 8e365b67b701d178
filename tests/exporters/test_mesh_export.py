"""The geometry that leaves Blender: axes, normals, seams."""

import numpy as np
import pytest

from rna_export.capture.blender_axes import from_blender
from rna_export.capture.geometry.mesh_cleanup import welded

pytestmark = pytest.mark.blender


def test_world_space_in_the_packages_axes(open_worker):
    worker = open_worker(
        "add([(1, 2, 3), (2, 2, 3), (1, 4, 3)], [(0, 1, 2)], matrix=Matrix.Translation((0, 0, 10)))"
    )
    corners = worker.export_corners()
    expected = from_blender(np.float32([[1, 2, 13], [2, 2, 13], [1, 4, 13]]))
    assert np.array_equal(corners["positions"], expected)
    assert np.allclose(corners["normals"], [0, 1, 0])
    assert not corners["has_uv"]


def test_flat_faces_have_flat_normals(open_worker):
    corners = open_worker("add(CUBE, SIDES)").export_corners()
    assert np.array_equal(np.abs(corners["normals"]).max(axis=1), np.ones(36))
    assert np.all(np.sum(corners["normals"] * corners["positions"], axis=1) > 0.99)


def test_smooth_faces_have_smooth_normals(open_worker):
    mesh = welded(open_worker("add(*BALL, smooth=True)").export_corners())[0]
    assert len(mesh.positions) == 162  # no vertex was split
    assert np.sum(mesh.normals * mesh.positions, axis=1).min() > 0.999


def test_sharp_edges_split_the_normals(open_worker):
    sharp = "item.data.edges.foreach_set('use_edge_sharp', [True] * len(item.data.edges))"
    script = f"item = add(CUBE, SIDES, smooth=True)\n{sharp}"
    assert len(welded(open_worker(script).export_corners())[0].positions) == 24


@pytest.mark.parametrize("scale", [(1, 1, 1), (-1, 1, 1), (2, -1, -3), (-1, -1, -1)])
def test_triangles_wind_outwards_whatever_the_scale(open_worker, scale):
    worker = open_worker(f"add(*BALL, smooth=True, matrix=Matrix.Diagonal(({(*scale, 1)})))")
    mesh = welded(worker.export_corners())[0]
    a, b, c = np.moveaxis(mesh.positions[mesh.triangles], 1, 0)
    assert np.all(np.sum(np.cross(b - a, c - a) * (a + b + c), axis=1) > 0.0)
    x, y, z = np.abs(scale)
    gradient = mesh.positions / np.float32([x, z, y]) ** 2
    gradient /= np.linalg.norm(gradient, axis=1, keepdims=True)
    assert np.sum(mesh.normals * gradient, axis=1).min() > 0.98


def test_uvs_count_from_the_top(open_worker):
    corners = open_worker(
        """
item = add(*square(1))
layer = item.data.uv_layers.new()
for loop, uv in zip(item.data.loops, [(0, 0), (1, 0), (1, 0.75), (0, 0.75)]):
    layer.uv[loop.index].vector = uv
"""
    ).export_corners()
    assert corners["has_uv"]
    x, front = corners["positions"][:, 0], corners["positions"][:, 2]  # front is Blender's -y
    assert np.allclose(corners["uvs"][:, 0], (x + 1) / 2)
    assert np.allclose(corners["uvs"][:, 1], 1.0 - 0.75 * (1 - front) / 2)


def test_modifiers_are_applied(open_worker):
    corners = open_worker(
        "m = add(CUBE, SIDES).modifiers.new('two', 'ARRAY'); m.count = 2"
    ).export_corners()
    assert len(corners["positions"]) == 72
    assert corners["positions"][:, 0].max() == pytest.approx(3.0)


def test_the_order_of_polygons_does_not_matter(open_worker):
    """Blender's operators, such as that of spheres, give another one in each process."""
    origins = np.tile(np.float32([0, 0, 3]), (64, 1))
    directions = np.float32([[0.02 * (k % 8), 0.02 * (k // 8), -1] for k in range(64)])
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    actual = []
    for faces in ("BALL[1]", "BALL[1][::-1]"):
        worker = open_worker(f"add(BALL[0], {faces}, smooth=True)")
        rays = worker.render_rays(origins, directions, np.float32([0, 0.6, 0.8]), 4, seed=1)
        actual.append((worker.export_corners(), rays.radiance))
    (first, seen), (second, seen_again) = actual
    assert {k: v.tobytes() for k, v in first.items()} == {k: v.tobytes() for k, v in second.items()}
    assert np.array_equal(seen, seen_again)

"""Notes on sizes: details below the package's steps, places far away, units that look wrong."""

import numpy as np
import pytest

from rna_export.capture.geometry.source_notes import doubled, size_notes, too_coarse
from rna_sdk.package import Mesh
from tests.exporters.meshes import merged, moved, sphere, square


def scaled(mesh: Mesh, by: float) -> Mesh:
    return Mesh(mesh.positions * np.float32(by), mesh.normals, mesh.uvs, mesh.triangles)


def test_a_ball_on_a_large_plane_is_too_fine_for_16_bits():
    note = too_coarse("asset", merged(scaled(sphere(2), 0.02), square(1000.0)))
    assert note is not None and "0.04 m" in note and "0.0305 m" in note


@pytest.mark.parametrize("size", [0.01, 1.0, 1000.0])
def test_ordinary_objects_fit_their_steps(size):
    rivet = moved(scaled(sphere(2), 0.005), (0.0, 1.0, 0.0))
    assert too_coarse("asset", scaled(merged(sphere(4), rivet), size)) is None


def test_a_mesh_without_an_area_in_16_bits_is_kept():
    """As of a file with one coordinate that is wrong."""
    positions = np.float32([[0, 0, 0], [0, 1, 0], [0, 1, 1], [4e9, 1, 1]])
    triangles = np.uint32([[0, 1, 2], [0, 1, 3]])
    note = too_coarse("asset", Mesh(positions, np.float32([[0, 0, 1]] * 4), None, triangles))
    assert note is not None and "no triangle has an area" in note


def test_fine_details_of_one_surface_are_no_objects():
    """A pole of a fine sphere has tiny triangles that belong to large ones."""
    mesh = sphere(3)
    mesh.positions[:40] *= np.float32(1e-5)
    assert too_coarse("asset", mesh) is None


def test_geometry_far_from_the_origin_is_named():
    (note,) = size_notes({"asset": moved(sphere(2), (5e6, 0.0, 0.0))})
    assert "5,000,000 m from the origin" in note and "0.596 m" in note
    assert size_notes({"asset": moved(sphere(2), (50.0, 0.0, 0.0))}) == []


def test_what_looks_like_centimetres_is_named():
    (note,) = size_notes({"asset": scaled(sphere(2), 90.0)})
    assert "180 m" in note and "are read as centimetres, -- --unit 0.0001" in note
    assert size_notes({"asset": scaled(sphere(2), 5.0)}) == []


def test_triangles_on_others_are_named_with_their_material():
    ball = sphere(1)
    back = Mesh(ball.positions, -ball.normals, None, ball.triangles[:3, ::-1])
    mesh = merged(ball, back)
    materials = np.array(["skin"] * len(ball.triangles) + ["film"] * 3)
    note = doubled("asset", mesh, materials)
    assert note is not None and "3 triangles that lie exactly on others" in note
    assert "most of material 'film'" in note
    assert doubled("asset", ball, materials) is None

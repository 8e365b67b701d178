import numpy as np
import pytest

from rna_export.capture.geometry.mesh_cleanup import welded

TWO_TRIANGLES = np.float32([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0], [1, 1, 0], [0, 1, 0]])


def corners(positions, normals=None, uvs=None):
    n = len(positions)
    return {
        "positions": positions,
        "normals": np.tile(np.float32([0, 0, 1]), (n, 1)) if normals is None else normals,
        "uvs": np.zeros((n, 2), np.float32) if uvs is None else uvs,
        "has_uv": np.array(uvs is not None),
    }


def test_equal_corners_become_one_vertex():
    mesh = welded(corners(TWO_TRIANGLES))[0]
    assert len(mesh.positions) == 4
    assert np.array_equal(mesh.positions[mesh.triangles].reshape(-1, 3), TWO_TRIANGLES)
    assert mesh.uvs is None


def test_a_hard_edge_keeps_both_normals():
    normals = np.float32([[0, 0, 1]] * 3 + [[0, 1, 0]] * 3)
    mesh = welded(corners(TWO_TRIANGLES, normals))[0]
    assert len(mesh.positions) == 6
    assert np.array_equal(mesh.normals[mesh.triangles].reshape(-1, 3), normals)


def test_a_seam_keeps_both_uvs():
    uvs = np.float32([[0, 0], [1, 0], [1, 1], [0.5, 0.5], [1, 1], [0, 1]])
    mesh = welded(corners(TWO_TRIANGLES, uvs=uvs))[0]
    assert len(mesh.positions) == 5
    assert mesh.uvs is not None
    assert np.array_equal(mesh.uvs[mesh.triangles].reshape(-1, 2), uvs)


def test_minus_zero_is_zero():
    positions = TWO_TRIANGLES.copy()
    positions[3:, 2] = -0.0
    assert len(welded(corners(positions))[0].positions) == 4


def test_triangles_without_area_go():
    line = np.float32([[0, 0, 0], [1, 0, 0], [2, 0, 0]])
    mesh = welded(corners(np.concatenate([TWO_TRIANGLES, line])))[0]
    assert len(mesh.triangles) == 2


@pytest.mark.parametrize("value", [0.0, np.nan])
def test_a_corner_without_a_normal_gets_its_triangles(value):
    normals = np.float32([[0, 1, 0]] * 5 + [[value] * 3])
    mesh = welded(corners(TWO_TRIANGLES, normals))[0]
    actual = mesh.normals[mesh.triangles].reshape(-1, 3)
    assert np.allclose(actual, [[0, 1, 0]] * 5 + [[0, 0, 1]])

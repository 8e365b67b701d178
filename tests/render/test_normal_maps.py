"""Normals with the relief of normal maps, compiled, against the runtime's plain twin."""

import numpy as np
import pytest

from rna_sdk.package import Mesh
from rna_sdk.package.textures.normal_maps import NormalMap
from rna_sdk.runtime.normal_maps import mapped_normals
from rna_trace.normal_maps import NormalMaps
from rna_trace.parts_scene import PartsScene
from rna_trace.surface import interpolate_normals
from tests.render.assets import sphere
from tests.runtime.points import unit_vectors


def textured(rng: np.random.Generator, count: int = 60) -> Mesh:
    """Loose triangles with texture coordinates of either handedness, some of none."""
    positions = rng.normal(size=(3 * count, 3)).astype(np.float32)
    normals = unit_vectors(rng, 3 * count).astype(np.float32)
    uvs = (3.0 * rng.normal(size=(3 * count, 2))).astype(np.float32)
    uvs[:9] = uvs[0]  # triangles that are one point of the texture
    triangles = np.arange(3 * count, dtype=np.uint32).reshape(-1, 3)
    return Mesh(positions, normals, uvs, triangles)


def hits(rng: np.random.Generator, mesh: Mesh, n: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    triangle = rng.integers(len(mesh.triangles), size=n).astype(np.int32)
    u = rng.random(n).astype(np.float32)
    return triangle, u, ((1.0 - u) * rng.random(n)).astype(np.float32)


def test_equals_the_twin():
    rng = np.random.default_rng(0)
    mesh = textured(rng)
    maps = tuple(
        NormalMap(first, count, rng.integers(0, 255, size=(*size, 2)).astype(np.uint8))
        for first, count, size in ((0, 20, (7, 5)), (25, 30, (1, 1)))
    )
    at = hits(rng, mesh, 4000)
    n = interpolate_normals(mesh.normals, mesh.triangles, *at)
    actual = NormalMaps(mesh, maps).at(n, *at)
    assert np.abs(actual - mapped_normals(mesh, maps, *at)).max() < 2e-6
    assert np.abs(np.linalg.norm(actual, axis=1) - 1.0).max() < 1e-6
    plain = (at[0] < 3) | ((at[0] >= 20) & (at[0] < 25)) | (at[0] >= 55)
    assert np.array_equal(actual[plain], n[plain])
    assert np.abs(actual - n)[~plain].max(axis=1).mean() > 0.1


@pytest.mark.parametrize("lean", [(40, 0), (0, 40)])
def test_a_map_leans_along_u_and_against_v(lean):
    """A square in the plane z = 0 whose u grows along x and whose v grows along -y."""
    positions = np.float32([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    normals = np.tile(np.float32([0, 0, 1]), (4, 1))
    uvs = np.float32([[0, 1], [1, 1], [1, 0], [0, 0]])
    mesh = Mesh(positions, normals, uvs, np.uint32([[0, 1, 2], [0, 2, 3]]))
    texture = np.full((4, 4, 2), 127, np.uint8)
    texture += np.uint8(lean)
    scene = PartsScene([mesh], normal_maps=[NormalMaps(mesh, (NormalMap(0, 2, texture),))])
    above = np.float32([[0.3, 0.6, 1.0]])
    actual = scene.intersect(above, np.float32([[0, 0, -1]]))
    points = scene.points(0, actual.primitive, actual.u, actual.v, actual.ng)
    x, y = (k / 127.0 for k in lean)
    assert points.mapped[0] == pytest.approx([x, y, np.sqrt(1 - x * x - y * y)], abs=1e-6)
    assert np.array_equal(points.n, normals[:1])


def test_without_maps_the_normals_are_the_interpolated_ones():
    ball = sphere(2)
    scene = PartsScene([ball])
    actual = scene.intersect(np.float32([[0, 0, 5]]), np.float32([[0.01, 0, -1]]))
    points = scene.points(0, actual.primitive, actual.u, actual.v, actual.ng)
    assert np.array_equal(points.mapped, points.n)

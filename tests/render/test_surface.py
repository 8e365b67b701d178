"""Points on meshes, and rays that leave them."""

from dataclasses import replace

import numpy as np
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package.geometry.mesh import Mesh
from rna_trace.parts_scene import PartsScene
from rna_trace.surface import (
    SurfacePoints,
    geometric_normals,
    interpolate,
    interpolate_normals,
    leaving_origins,
)
from tests.render.assets import merged, sphere, square
from tests.runtime.points import unit_vectors


def points_on(mesh: Mesh, n: int, seed: int = 0) -> SurfacePoints:
    """n random points of the mesh."""
    rng = np.random.default_rng(seed)
    triangle = rng.integers(0, len(mesh.triangles), n).astype(np.int32)
    u, v = rng.random((2, n), np.float32)
    u, v = np.where(u + v > 1, (1 - u, 1 - v), (u, v)).astype(np.float32)
    return SurfacePoints.of(mesh, triangle, u, v)


def flat(x: np.ndarray, ng: np.ndarray) -> SurfacePoints:
    """Points of triangles whose shading normals are their own."""
    return SurfacePoints(x, ng, ng, np.zeros_like(x), ng)


def visible(mesh: Mesh, points: SurfacePoints, wi, tfar=np.inf) -> np.ndarray:
    return PartsScene([mesh]).visible(0, points, wi, tfar)


def moved(mesh: Mesh, scale: float, shift: float) -> Mesh:
    positions = (mesh.positions * np.float32(scale) + np.float32(shift)).astype(np.float32)
    return Mesh(positions=positions, normals=mesh.normals, uvs=None, triangles=mesh.triangles)


def test_interpolation_is_the_barycentric_sum():
    mesh = sphere(1)
    triangle = np.arange(80, dtype=np.int32)
    u, v = np.full(80, 0.2, np.float32), np.full(80, 0.5, np.float32)
    weights = np.array([0.3, 0.2, 0.5])
    at = mesh.triangles, triangle, u, v
    expected = np.einsum("c,tck->tk", weights, mesh.positions[mesh.triangles].astype(np.float64))
    np.testing.assert_allclose(interpolate(mesh.positions, *at), expected, atol=1e-7)
    n = interpolate_normals(mesh.normals, *at)
    np.testing.assert_allclose(n, expected / np.linalg.norm(expected, axis=1)[:, None], atol=1e-6)


def test_geometric_normals_are_those_of_the_counter_clockwise_side():
    mesh = square()
    ng = geometric_normals(mesh.positions, mesh.triangles, np.int32([0, 1, 0]))
    assert ng.tolist() == [[0, 1, 0]] * 3


def test_triangles_that_are_not_there_are_refused():
    mesh = square()
    u = np.zeros(1, np.float32)
    for number in (-1, 2):
        with pytest.raises(QueryError, match="outside"):
            interpolate(mesh.positions, mesh.triangles, np.int32([number]), u, u)


# Sizes and places of an asset, in metres: as modelled, a grain of rice, a stadium, and a chair
# at the far end of one.
PLACES = [(1.0, 0.0), (1e-3, 0.0), (200.0, 0.0), (1.0, 300.0)]


@pytest.mark.parametrize(("scale", "shift"), PLACES)
def test_a_convex_body_blocks_exactly_the_light_from_behind(scale, shift):
    mesh = moved(sphere(4), scale, shift)
    points = points_on(mesh, 100_000)
    wi = unit_vectors(np.random.default_rng(1), len(points))
    plane, smooth = (np.sum(a.astype(np.float64) * wi, axis=1) for a in (points.ng, points.n))
    rough = 1e-3 * (1.0 + shift / 3.0)  # at 300 m the facets themselves are
    clear = (np.abs(plane) > rough) & ((smooth < 0.0) | (smooth > 0.02) | (plane > 0.0))
    free = visible(mesh, points, wi)
    np.testing.assert_array_equal(free[clear], (smooth > 0)[clear])


@pytest.mark.parametrize("subdivisions", [1, 2, 3])
def test_facets_do_not_block_light_that_the_smooth_surface_sees(subdivisions):
    """But for a degree at most: light along the surface still meets the corners of facets."""
    mesh = sphere(subdivisions)
    points = points_on(mesh, 100_000)
    wi = unit_vectors(np.random.default_rng(1), len(points))
    plane, smooth = (np.sum(a * wi, axis=1) for a in (points.ng, points.n))
    behind_facet = (plane < 0.0) & (smooth > 0.02)
    assert behind_facet.sum() > 100
    assert visible(mesh, points, wi)[behind_facet].mean() > 0.99


@pytest.mark.parametrize("subdivisions", [1, 2, 3])
def test_facets_do_not_see_light_that_is_behind_the_smooth_surface(subdivisions):
    """They would be the teeth of the terminator."""
    mesh = sphere(subdivisions)
    points = points_on(mesh, 100_000)
    wi = unit_vectors(np.random.default_rng(1), len(points))
    plane, smooth = (np.sum(a * wi, axis=1) for a in (points.ng, points.n))
    free = visible(mesh, points, wi)
    assert ((smooth < 0.0) & (plane > 0.0)).sum() > 100
    assert not free[smooth < 0.0].any()
    wound_against = replace(mesh, triangles=np.ascontiguousarray(mesh.triangles[:, ::-1]))
    turned = replace(points, ng=-points.ng)
    away = np.abs(plane) > 1e-3
    free = visible(wound_against, turned, wi)
    np.testing.assert_array_equal(free[away], (plane > 0.0)[away])


def test_points_are_lifted_onto_the_smooth_surface():
    """Triangles of a unit sphere: lifted by the mean of the ways onto the tangent planes."""
    points = points_on(sphere(2), 1000)
    radius = np.linalg.norm(points.x + points.lift, axis=1)
    facets = 1.0 - np.linalg.norm(points.x, axis=1)
    assert (radius > 1.0 - 1e-6).all() and (radius - 1.0 < 1.01 * facets + 1e-6).all()
    assert not points_on(square(), 100).lift.any()


@pytest.mark.parametrize(("scale", "shift"), PLACES)
def test_a_flat_sheet_never_blocks_its_own_light(scale, shift):
    mesh = moved(square(size=3.0), scale, shift)
    points = points_on(mesh, 100_000)
    wi = unit_vectors(np.random.default_rng(2), len(points))
    assert visible(mesh, points, wi).all()


def test_a_roof_close_above_blocks():
    mesh = merged(square(), square(size=10.0, height=1e-3))
    x, ng = np.float32([[0.3, 0, 0.1]] * 2), np.float32([[0, 1, 0]] * 2)
    wi = np.float32([[0, 1, 0], [0, -1, 0]])
    assert visible(mesh, flat(x, ng), wi).tolist() == [False, True]


def test_what_lies_behind_the_light_does_not_block():
    mesh = merged(square(), square(height=2.0))
    x, ng = np.float32([[0.3, 0, 0.1]] * 2), np.float32([[0, 1, 0]] * 2)
    free = visible(mesh, flat(x, ng), ng, tfar=np.float32([1.5, 2.5]))
    assert free.tolist() == [True, False]


def test_offset_goes_to_the_side_of_the_direction():
    x, ng = np.zeros((3, 3), np.float32), np.float32([[0, 1, 0]] * 3)
    directions = np.float32([[0, 1, 0], [0, -1, 0], [1, 0, 0]])
    height = leaving_origins(flat(x, ng), directions, extent=2.0)[:, 1]
    assert height[0] == height[2] == -height[1] > 0
    assert height[0] < 2e-5


def test_wrong_points_are_told():
    right = np.float32([[0, 1, 0]])
    for name, wrong in (("x", np.zeros((2, 3), np.float32)), ("lift", np.zeros((1, 3)))):
        points = replace(flat(right, right), **{name: wrong})
        with pytest.raises(QueryError, match="expected"):
            visible(square(), points, right)


def test_no_points_are_legal():
    none = np.zeros((0, 3), np.float32)
    assert visible(square(), flat(none, none), none).shape == (0,)


def test_points_in_one_pass_are_what_each_formula_gives():
    mesh, rng = moved(sphere(1), 1.7, 0.3), np.random.default_rng(12)
    triangle = rng.integers(0, len(mesh.triangles), 300).astype(np.int32)
    u, v = rng.dirichlet([1, 1, 1], 300)[:, :2].T.astype(np.float32)
    at, corners = (mesh.triangles, triangle, u, v), mesh.triangles[triangle]
    points = SurfacePoints.of(mesh, triangle, u, v)
    np.testing.assert_array_equal(points.x, interpolate(mesh.positions, *at))
    np.testing.assert_array_equal(points.n, interpolate_normals(mesh.normals, *at))
    ng = geometric_normals(mesh.positions, mesh.triangles, triangle)
    np.testing.assert_array_equal(points.ng, ng)
    weights = np.stack([1 - u - v, u, v], axis=1).astype(np.float64)
    way = points.x[:, None] - mesh.positions[corners]
    below = np.minimum(np.sum(way * mesh.normals[corners], axis=2), 0.0)
    lift = -np.sum((weights * below)[..., None] * mesh.normals[corners], axis=1)
    np.testing.assert_allclose(points.lift, lift, atol=1e-6)
    row, wi = rng.permutation(300)[:100], unit_vectors(rng, 100)
    origins = leaving_origins(points, wi, 2.0, row)
    np.testing.assert_array_equal(origins, leaving_origins(points.take(row), wi, 2.0))

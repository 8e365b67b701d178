"""Rays against triangles, next to a plain twin."""

import gc
import resource
import weakref

import numpy as np
import pytest

from rna_sdk.errors import QueryError, SceneError
from rna_trace.embree import TriangleScene
from rna_trace.embree.library import Device, SceneHandle
from tests.render.assets import EMBREE_ROUNDING, sphere, square
from tests.runtime.points import unit_vectors


def moeller_trumbore(positions, triangles, origins, directions):
    """Closest hits in float64, all rays against all triangles (Moeller and Trumbore, 1997)."""
    p0, p1, p2 = (positions[triangles[:, k]].astype(np.float64)[None] for k in range(3))
    o, d = origins[:, None].astype(np.float64), directions[:, None].astype(np.float64)
    e1, e2 = p1 - p0, p2 - p0
    p = np.cross(d, e2)
    with np.errstate(divide="ignore", invalid="ignore"):
        inverse = 1.0 / np.sum(e1 * p, axis=2)
        s = o - p0
        u = np.sum(s * p, axis=2) * inverse
        q = np.cross(s, e1)
        v = np.sum(d * q, axis=2) * inverse
        t = np.sum(e2 * q, axis=2) * inverse
        t[~((u >= 0) & (v >= 0) & (u + v <= 1) & (t >= 0))] = np.inf
    triangle = t.argmin(axis=1)
    row = np.arange(len(t))
    return t[row, triangle], np.where(np.isfinite(t[row, triangle]), triangle, -1), u, v


@pytest.fixture(scope="module")
def ball():
    mesh = sphere(2)
    return mesh, TriangleScene([(mesh.positions, mesh.triangles)])


def test_closest_hits_are_those_of_the_plain_twin(ball):
    mesh, scene = ball
    rng = np.random.default_rng(1)
    origins = 3.0 * unit_vectors(rng, 3000)
    directions = (unit_vectors(rng, 3000) - origins) / np.float32(2.0)
    hits = scene.intersect(origins, directions)
    t, triangle, u, v = moeller_trumbore(mesh.positions, mesh.triangles, origins, directions)
    same = hits.primitive == triangle
    assert same.mean() > 0.999  # a ray through an edge may fall to either side
    assert 0.3 < np.mean(triangle >= 0) < 1.0
    np.testing.assert_array_equal(hits.geometry[same], np.where(triangle[same] >= 0, 0, -1))
    np.testing.assert_allclose(hits.t[same], t[same], rtol=1e-5)
    rows = np.flatnonzero(same & (triangle >= 0))
    np.testing.assert_allclose(hits.u[rows], u[rows, triangle[rows]], atol=1e-4)
    np.testing.assert_allclose(hits.v[rows], v[rows, triangle[rows]], atol=1e-4)
    np.testing.assert_array_equal(scene.occluded(origins, directions), hits.geometry >= 0)


def test_geometry_is_the_place_in_the_list():
    low, high = square(height=0.0), square(height=1.0)
    nothing = np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint32)
    scene = TriangleScene(
        [(low.positions, low.triangles), nothing, (high.positions, high.triangles)]
    )
    origins = np.array([[0.5, -1, 0], [0.5, 2, 0], [5, 2, 0]], np.float32)
    directions = np.array([[0, 1, 0], [0, -1, 0], [0, -1, 0]], np.float32)
    hits = scene.intersect(origins, directions)
    assert hits.geometry.tolist() == [0, 2, -1]
    np.testing.assert_allclose(hits.t, [1.0, 1.0, np.inf], rtol=EMBREE_ROUNDING)
    assert scene.extent == 1.0


def test_the_interval_limits_what_is_hit(ball):
    scene = ball[1]
    origins, directions = np.float32([[0, 0, 3]] * 4), np.float32([[0, 0, -1]] * 4)
    near, far = np.float32([0, 2.5, 0, 4.5]), np.float32([np.inf, np.inf, 1.5, np.inf])
    hits = scene.intersect(origins, directions, near, far)
    np.testing.assert_allclose(hits.t, [2, 4, np.inf, np.inf], rtol=1e-3)
    assert scene.occluded(origins, directions, near, far).tolist() == [True, True, False, False]
    assert not scene.occluded(origins, directions, tfar=1.5).any()


def test_rays_that_are_not_rays_miss(ball):
    scene = ball[1]
    origins = np.float32([[0, 0, 0], [np.nan, 0, 0], [0, 0, 0], [0, 0, np.inf]])
    directions = np.float32([[0, 0, 0], [0, 0, 1], [0, np.nan, 1], [0, 0, -1]])
    hits = scene.intersect(origins, directions)
    assert hits.geometry.tolist() == [-1] * 4
    assert hits.t.tolist() == [np.inf] * 4
    assert not scene.occluded(origins, directions).any()


def test_no_rays_and_no_triangles_are_legal(ball):
    none = np.zeros((0, 3), np.float32)
    hits = ball[1].intersect(none, none)
    assert hits.t.shape == hits.geometry.shape == hits.primitive.shape == (0,)
    assert hits.t.dtype == hits.u.dtype == np.float32 and hits.geometry.dtype == np.int32
    ray = np.float32([[0, 0, 1]])
    assert TriangleScene([]).intersect(ray, ray).geometry.tolist() == [-1]


def test_views_and_read_only_arrays_are_legal(ball):
    origins = np.zeros((10, 6), np.float32)[:, ::2]
    directions = np.tile(np.float32([0, 0, 1]), (10, 1))
    directions.flags.writeable = False
    assert (ball[1].intersect(origins, directions).geometry == 0).all()


@pytest.mark.parametrize(
    ("origins", "directions", "tfar"),
    [
        (np.zeros((2, 3)), np.zeros((2, 3), np.float32), np.inf),
        (np.zeros((2, 3), np.float32), np.zeros((3, 3), np.float32), np.inf),
        (np.zeros(3, np.float32), np.zeros(3, np.float32), np.inf),
        ([[0, 0, 0]], [[0, 0, 1]], np.inf),
        (np.zeros((2, 3), np.float32), np.zeros((2, 3), np.float32), np.ones(3)),
    ],
)
def test_wrong_rays_are_refused(ball, origins, directions, tfar):
    with pytest.raises(QueryError):
        ball[1].intersect(origins, directions, 0.0, tfar)
    with pytest.raises(QueryError):
        ball[1].occluded(origins, directions, 0.0, tfar)


@pytest.mark.parametrize(
    ("positions", "triangles", "message"),
    [
        (np.zeros((3, 3)), np.zeros((1, 3), np.uint32), "positions must be float32"),
        (np.zeros((3, 3), np.float32), np.zeros((1, 3), np.int64), "triangles must be uint32"),
        (np.zeros((3, 2), np.float32), np.zeros((1, 3), np.uint32), r"must be \(n, 3\)"),
        (np.full((3, 3), np.nan, np.float32), np.zeros((1, 3), np.uint32), "finite"),
        (np.zeros((3, 3), np.float32), np.uint32([[0, 1, 3]]), "names vertex 3"),
    ],
)
def test_wrong_meshes_are_refused(positions, triangles, message):
    with pytest.raises(SceneError, match=message):
        TriangleScene([(positions, triangles)])


def test_a_device_lives_as_long_as_its_scenes():
    device = Device()
    scene, alive = SceneHandle(device), weakref.ref(device)
    del device
    gc.collect()
    assert alive() is not None
    del scene
    gc.collect()
    assert alive() is None


def test_scenes_that_are_gone_give_their_memory_back():
    mesh = sphere(6)
    arrays = mesh.positions, mesh.triangles
    TriangleScene([arrays])
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(30):
        TriangleScene([arrays])
    grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
    assert grown < 60  # MB; one scene takes about 6

"""Rays against round curves, next to an exact twin."""

import numpy as np
import pytest

from rna_render.scene.scene_model import TransformModel
from rna_render.scene.transforms import world_from_object
from rna_sdk.errors import PackageError, QueryError, SceneError
from rna_sdk.package import Curves
from rna_trace.embree.instances import Instance, InstanceScene
from rna_trace.parts_scene import PartsScene
from tests.render.round_cones import entries
from tests.render.strands import curls, straight
from tests.runtime.points import unit_vectors


def scene_of(curves: Curves) -> PartsScene:
    return PartsScene([curves])


def rays_through(curves: Curves, n: int) -> tuple[np.ndarray, np.ndarray]:
    """Rays from outside towards points near the strands."""
    rng = np.random.default_rng(1)
    directions = unit_vectors(rng, n)
    targets = rng.choice(curves.points, n) + 0.02 * rng.normal(size=(n, 3))
    return (targets - 3.0 * directions).astype(np.float32), directions


def test_a_cylinder_a_cone_and_caps_are_hit_where_they_are():
    """A strand of radius 0.1 up the y axis, and a cone of half-angle asin(0.2) along x."""
    curves = Curves(
        np.float32([[0, 0, 0], [0, 1, 0], [3, 0, 0], [4, 0, 0]]),
        np.float32([0.1, 0.1, 0.2, 0.4]),
        np.uint32([0, 2, 4]),
    )
    tilt = np.sqrt(1 - 0.2**2)
    # The cone's slope is 0.2 / tilt; (0.5 + 0.04) / tilt^2 puts the sphere that touches at x = 3.5.
    u = 0.54 / 0.96
    origins = np.float32([[0, 0.25, 5], [0.06, 0.5, 5], [3.5, 0, 5], [0.06, -3, 0], [9, 0.24, 0]])
    directions = np.float32([[0, 0, -1]] * 3 + [[0, 1, 0], [-1, 0, 0]])
    directions[3] += np.float32([0, 0, 1e-3])  # a ray that is parallel to the axis is not seen
    origins[3, 2] -= 2.92e-3
    hits = scene_of(curves).intersect(origins, directions)
    assert hits.primitive.tolist() == [0, 0, 1, 0, 1]
    end = 4 + np.sqrt(0.4**2 - 0.24**2)
    radius = 0.2 + 0.2 * u
    np.testing.assert_allclose(hits.t, [4.9, 4.92, 5 - radius * tilt, 2.92, 9 - end], rtol=1e-5)
    np.testing.assert_allclose(hits.u, [0.25, 0.5, u, 0, 1], atol=1e-6)
    expected = [[0, 0, 1], [0.6, 0, 0.8], [-0.2, 0, tilt], [0.6, -0.8, 0], [0.8, 0.6, 0]]
    np.testing.assert_allclose(hits.ng, expected, atol=1e-4)


@pytest.mark.parametrize("spread", [0.5, 0.15])
def test_closest_hits_are_those_of_the_exact_twin(spread):
    """Curls with strong taper, loose and dense: their cones, joints and caps."""
    curves = curls(40, radius=0.03, spread=spread)
    origins, directions = rays_through(curves, 2000)
    hits = scene_of(curves).intersect(origins, directions)
    exact = entries(curves, origins, directions)
    t = exact.min(axis=1)
    actual = hits.primitive >= 0
    assert np.sum(actual != np.isfinite(t)) <= 1  # one that grazes may fall to either side
    rows = np.flatnonzero(actual & np.isfinite(t))
    assert 0.5 < len(rows) / len(t) < 1.0
    np.testing.assert_allclose(hits.t[rows], t[rows], atol=1e-5)
    assert np.mean(hits.primitive[rows] == exact[rows].argmin(axis=1)) > 0.99  # joints are of both
    np.testing.assert_allclose(np.linalg.norm(hits.ng[rows], axis=1), 1, atol=1e-6)
    assert (np.sum(hits.ng[rows] * directions[rows], axis=1) <= 1e-3).all()
    assert (hits.ng[~actual] == 0).all() and (hits.t[~actual] == np.inf).all()
    scene = scene_of(curves)
    np.testing.assert_array_equal(scene.occluded(origins, directions), actual)


def test_a_strand_has_no_caps_inside():
    """From the axis of a bent strand with a joint, a ray meets nothing but its own way out."""
    bent = straight(((-1, 0, 0), (0, 0, 0), (1, 0.2, 0)))
    hits = scene_of(bent).intersect(np.float32([[-0.9, 0, 0]]), np.float32([[1, 0.05, 0]]))
    assert hits.t[0] > 1.5 and hits.primitive[0] == 1
    # Two strands that meet there do have caps: the first one's is the way out.
    apart = straight(((-1, 0, 0), (0, 0, 0)), ((0, 0, 0), (1, 0.2, 0)))
    hits = scene_of(apart).intersect(np.float32([[-0.9, 0, 0]]), np.float32([[1, 0.05, 0]]))
    assert hits.t[0] < 1.1


def test_round_curves_are_hit_from_however_near():
    """Embree's avoidance of hits within two radii is for flat curves."""
    gap = np.float32([1e-5, 1e-3, 0.05, 0.15, 0.25])
    origins = np.column_stack([np.zeros(5), np.zeros(5), 0.1 + gap]).astype(np.float32)
    scene = scene_of(straight(((0, -1, 0), (0, 1, 0))))
    hits = scene.intersect(origins, np.tile(np.float32([0, 0, -1]), (5, 1)))
    np.testing.assert_allclose(hits.t, gap, rtol=1e-3)


def test_a_sphere_that_holds_the_rest_of_its_segment_is_hit():
    """A bud: from one point to the next the radius shrinks by more than the distance."""
    curves = Curves(
        np.float32([[0, 0, 0], [0, 0.05, 0]]), np.float32([0.2, 0.1]), np.uint32([0, 2])
    )
    rng = np.random.default_rng(3)
    directions = unit_vectors(rng, 2000)
    origins = (0.25 * unit_vectors(rng, 2000) - 3 * directions).astype(np.float32)
    hits = scene_of(curves).intersect(origins, directions)
    t = entries(curves, origins, directions)[:, 0]
    clear = np.isfinite(t) == (hits.primitive >= 0)
    assert np.sum(~clear) <= 2 and 0.3 < np.mean(np.isfinite(t)) < 1.0
    np.testing.assert_allclose(hits.t[clear], t[clear], atol=1e-4)


@pytest.mark.parametrize("scale", [0.01, 1.0, 30.0])
def test_an_instance_is_hit_as_the_strands_are_in_their_own_space(scale):
    """Radii scale with it, and normals stay in object space."""
    curves = curls(30, seed=2, radius=0.03)
    model = TransformModel(translation=(0.1, -2, 3), rotation_deg=(10, 70, -40), scale=scale)
    matrix = world_from_object(model)
    origins, directions = rays_through(curves, 3000)
    expected = scene_of(curves).intersect(origins, directions)
    origins_world = (origins @ matrix[:3, :3].T + matrix[:3, 3]).astype(np.float32)
    directions_world = (directions @ matrix[:3, :3].T / scale).astype(np.float32)
    hits = InstanceScene([Instance(scene_of(curves), matrix)]).intersect(
        origins_world, directions_world
    )
    same = hits.primitive == expected.primitive
    assert same.mean() > 0.99 and np.mean(expected.primitive >= 0) > 0.4
    # At a scale of 0.01 the world's coordinates are rounded to 2e-5 of the strands' own.
    near = np.abs(hits.ng - expected.ng)[same].max(axis=1) < 0.1
    assert near.mean() > 0.98
    np.testing.assert_allclose(hits.t[same][near], expected.t[same][near] * scale, rtol=2e-3)
    np.testing.assert_allclose(hits.u[same][near], expected.u[same][near], atol=0.02)


def test_no_rays_are_legal():
    none = np.zeros((0, 3), np.float32)
    hits = scene_of(straight(((0, 0, 0), (0, 1, 0)))).intersect(none, none)
    assert hits.t.shape == hits.primitive.shape == (0,) and hits.ng.shape == (0, 3)


def test_wrong_curves_are_refused():
    points, radii = np.float32([[0, 0, 0], [0, 1, 0]]), np.ones(2, np.float32)
    offsets = np.uint32([0, 2])
    with pytest.raises(PackageError, match="GEOMETRY_ARRAY"):
        PartsScene([Curves(points.astype(np.float64), radii, offsets)])
    with pytest.raises(PackageError, match="GEOMETRY_STRANDS"):
        PartsScene([Curves(points, radii, np.uint32([0, 1, 2]))])
    for bad in (np.nan, np.inf):
        with pytest.raises(SceneError, match="points must be finite"):
            PartsScene([Curves(np.float32([[0, 0, 0], [0, bad, 0]]), radii, offsets)])
    for bad in (np.nan, np.inf, 0.0, -1.0):
        with pytest.raises(SceneError, match="radii must be finite and more than 0"):
            PartsScene([Curves(points, np.float32([1, bad]), offsets)])


def test_wrong_rays_are_refused():
    scene = scene_of(straight(((0, 0, 0), (0, 1, 0))))
    ray = np.zeros((2, 3), np.float32)
    with pytest.raises(QueryError):
        scene.intersect(ray, ray.astype(np.float64))

"""Points on fibers, and rays that leave a strand."""

import numpy as np
import pytest

from rna_sdk.errors import QueryError
from rna_sdk.package import Curves
from rna_trace.fiber import FiberPoints, hit_points, tangents
from rna_trace.parts_scene import PartsScene
from tests.render.round_cones import depths, entries
from tests.render.strands import curls, straight
from tests.runtime.points import unit_vectors


def scene_of(curves: Curves) -> PartsScene:
    return PartsScene([curves])


def visible(scene: PartsScene, x, segment, wi, tfar=np.inf) -> np.ndarray:
    """Visibility of points x of the first part, whatever their normals and tangents."""
    return scene.visible(0, FiberPoints(x, x, x, segment), wi, tfar)


def seen_points(curves: Curves, n: int, far: float = 3.0):
    """Segments and points that n rays from outside hit first, and those rays."""
    rng = np.random.default_rng(1)
    directions = unit_vectors(rng, n)
    targets = rng.choice(curves.points, n) + 0.02 * rng.normal(size=(n, 3))
    origins = (targets - far * directions).astype(np.float32)
    hits = scene_of(curves).intersect(origins, directions)
    row = np.flatnonzero(hits.primitive >= 0)
    at = hits.primitive[row], hits.u[row], hits.ng[row]
    points = hit_points(curves.points, curves.radii, curves.segments(), *at)
    return hits.primitive[row], points, origins[row], directions[row]


def test_hit_points_are_those_of_the_exact_twin():
    curves = curls(40, radius=0.03)
    segment, points, origins, directions = seen_points(curves, 2000)
    t = entries(curves, origins, directions)[np.arange(len(segment)), segment]
    exact = origins + t[:, None] * directions.astype(np.float64)
    hit = np.isfinite(t)
    assert hit.mean() > 0.99 and hit.sum() > 1000
    assert np.abs(points - exact)[hit].max() < 1e-5


@pytest.mark.parametrize("far", [3.0, 1000.0])
def test_hit_points_lie_on_the_strand_however_far_the_ray_came_from(far):
    """Radii are 1e-3 to 4e-2; the distance alone is known to 3e-5 at 1000."""
    curves = curls(40, radius=0.03)
    segment, points, *_ = seen_points(curves, 2000, far)
    off = np.abs(depths(curves, points)[np.arange(len(segment)), segment])
    assert len(segment) > 1000 and off.max() < 2e-7


def test_tangents_go_from_root_to_tip():
    curves = straight(((0, 0, 0), (0, 2, 0), (3, 2, 0)), ((0, 0, 1), (0, 0, -8)))
    t = tangents(curves.points, curves.segments(), np.int32([1, 0, 2]))
    assert t.dtype == np.float32
    assert t.tolist() == [[1, 0, 0], [0, 1, 0], [0, 0, -1]]


@pytest.mark.parametrize(("strands", "spread"), [(60, 0.5), (60, 0.2), (150, 0.05)])
def test_visibility_is_that_of_the_exact_twin(strands, spread):
    """Dense curls: blocked is what enters another strand than its own."""
    curves = curls(strands, radius=0.03, spread=spread)
    segment, points, *_ = seen_points(curves, 1500)
    wi = unit_vectors(np.random.default_rng(2), len(points))
    scene = scene_of(curves)
    strand = np.repeat(np.arange(strands), 19)
    same_strand = strand == strand[segment][:, None]
    blocked = (np.isfinite(entries(curves, points, wi)) & ~same_strand).any(axis=1)
    assert 0.1 < blocked.mean() < 0.9
    disagreements = np.sum(visible(scene, points, segment, wi) == blocked)
    assert disagreements <= 1  # rays that graze


def test_visibility_inside_other_strands_counts_only_what_is_entered():
    """Points within strands that run through one another: the way out blocks nothing."""
    crossing = straight(((-1, 0, 0), (1, 0, 0)), ((0, -1, 0.05), (0, 1, 0.05)))
    x, segment = np.float32([[0.02, 0, 0.1]]), np.int32([0])
    assert depths(crossing, x)[0, 1] > 0
    for wi in ([0, 0, 1], [0, 0.6, 0.8], [1, 0, 0]):
        assert visible(scene_of(crossing), x, segment, np.float32([wi])).tolist() == [True]


def test_a_strand_never_blocks_its_own_light():
    """A hairpin: one leg over the other, which light from above reaches all the same."""
    legs = ((-1, 0, 0), (0, 0, 0), (1, 0, 0)), ((1, 1, 0), (0, 1, 0), (-1, 1, 0))
    x, up = np.float32([[-0.5, 0.1, 0], [-0.5, -0.1, 0], [0, 0.1, 0]]), np.float32([[0, 1, 0]] * 3)
    segment = np.int32([0, 0, 1])
    assert visible(scene_of(straight(legs[0] + legs[1])), x, segment, up).all()
    assert not visible(scene_of(straight(*legs)), x, segment, up).any()


def test_curls_alone_are_visible_from_everywhere():
    """Joints, caps and windings of single strands, with strong taper."""
    for seed in range(5):
        curves = curls(1, seed, radius=0.05)
        segment, points, *_ = seen_points(curves, 2000)
        wi = unit_vectors(np.random.default_rng(seed), len(points))
        assert visible(scene_of(curves), points, segment, wi).all() and len(points) > 500


@pytest.mark.parametrize("gap", [1e-5, 1e-3, 0.05, 0.15])
def test_a_neighbour_nearer_than_two_radii_blocks(gap):
    pair = straight(((0, -1, 0), (0, 1, 0)), ((0.2 + gap, -1, 0), (0.2 + gap, 1, 0)))
    x, segment = np.float32([[0.1, 0.3, 0]] * 3), np.int32([0, 0, 0])
    wi = np.float32([[1, 0.01, 0], [-1, 0.01, 0], [1e-3, 0.01, 1]])
    assert visible(scene_of(pair), x, segment, wi).tolist() == [False, True, True]


def test_what_lies_behind_the_light_does_not_block():
    pair = straight(((0, -1, 0), (0, 1, 0)), ((1, -1, 0), (1, 1, 0)))
    x, segment = np.float32([[0.1, 0, 0]] * 2), np.int32([0, 0])
    towards, distance = np.float32([[1, 0.1, 0]] * 2), np.float32([0.5, 1.5])
    assert visible(scene_of(pair), x, segment, towards, distance).tolist() == [True, False]


def test_wrong_arguments_are_refused():
    curves = straight(((0, 0, 0), (0, 1, 0)))
    scene, x, u = scene_of(curves), np.zeros((1, 3), np.float32), np.zeros(1, np.float32)
    for number in (-1, 1):
        segment = np.int32([number])
        with pytest.raises(QueryError, match="outside"):
            tangents(curves.points, curves.segments(), segment)
        with pytest.raises(QueryError, match="outside"):
            hit_points(curves.points, curves.radii, curves.segments(), segment, u, x)
        with pytest.raises(QueryError, match="outside"):
            visible(scene, x, segment, x)
    one = np.int32([0])
    with pytest.raises(QueryError, match="1 segments, but 2 u"):
        hit_points(curves.points, curves.radii, curves.segments(), one, np.zeros(2), x)
    with pytest.raises(QueryError, match="wi"):
        visible(scene, x, one, np.zeros((2, 3), np.float32))
    with pytest.raises(QueryError, match="strand"):
        visible(scene, x, np.int32([0, 0]), x)


def test_no_points_are_legal():
    none = np.zeros((0, 3), np.float32)
    scene = scene_of(straight(((0, 0, 0), (0, 1, 0))))
    assert visible(scene, none, np.zeros(0, np.int32), none).shape == (0,)

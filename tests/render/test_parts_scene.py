"""Assets of several parts as rays meet them."""

import numpy as np
import pytest

from rna_sdk.package import Curves, Mesh
from rna_trace.fiber import FiberPoints
from rna_trace.parts_scene import PartsScene
from rna_trace.surface import OFFSET, SurfacePoints
from tests.render.assets import merged, sphere, square
from tests.render.round_cones import entries
from tests.render.strands import curls, straight
from tests.runtime.points import unit_vectors

UPRIGHT = straight(((0, 0.5, 0), (0, 1.5, 0)))
BESIDE = straight(((0.5, 0.5, 0), (0.5, 1.5, 0)), ((5, 0, 0), (5, 1, 0)))


def rays(*pairs) -> tuple[np.ndarray, np.ndarray]:
    return tuple(np.float32(rows) for rows in zip(*pairs, strict=True))


def on_square(x: float, z: float) -> SurfacePoints:
    up = np.float32([[0, 1, 0]])
    return SurfacePoints(np.float32([[x, 0, z]]), up, up, 0 * up, up)


def on_strand(x) -> FiberPoints:
    x = np.float32([x])
    return FiberPoints(x, x, x, np.int32([0]))


def test_hits_name_part_and_primitive():
    scene = PartsScene([UPRIGHT, square(), BESIDE])
    origins, directions = rays(
        ((0, 1, 3), (0, 0, -1)), ((0.3, 3, 0.9), (0, -1, 0)), ((0.5, 1, 3), (0, 0, -1)),
        ((5, 0.5, 3), (0, 0, -1)), ((9, 9, 9), (0, 1, 0)),
    )  # fmt: skip
    hits = scene.intersect(origins, directions)
    assert hits.geometry.tolist() == [0, 1, 2, 2, -1]
    assert hits.primitive.tolist() == [0, 0, 0, 1, -1]
    np.testing.assert_allclose(hits.t, [2.9, 3, 2.9, 2.9, np.inf])
    np.testing.assert_allclose(hits.ng[:3], [[0, 0, 1], [0, 1, 0], [0, 0, 1]], atol=1e-6)
    strand, floor = (
        scene.points(p, hits.primitive[k], hits.u[k], hits.v[k], hits.ng[k])
        for p, k in ((2, [2]), (1, [1]))
    )
    np.testing.assert_allclose(strand.x, [[0.5, 1, 0.1]], atol=1e-6)
    np.testing.assert_allclose(strand.tangent, [[0, 1, 0]])
    np.testing.assert_allclose(floor.x, [[0.3, 0, 0.9]], atol=1e-6)
    assert scene.extent == np.float32(5.1)


def test_parts_block_one_another():
    """Strands of other parts, the floor, and a strand of another part with the same number."""
    scene = PartsScene([UPRIGHT, square(), BESIDE])
    right, left, down = (np.float32([d]) for d in ((1, 0.1, 0), (-1, 0.1, 0), (0.1, -1, 0.1)))
    assert not scene.visible(0, on_strand((0.1, 1, 0)), right)[0]
    assert scene.visible(0, on_strand((0.1, 1, 0)), right, 0.2)[0]
    assert scene.visible(0, on_strand((0.1, 1, 0)), left)[0]
    assert not scene.visible(2, on_strand((0.4, 1, 0)), left)[0]
    assert scene.visible(2, on_strand((0.4, 1, 0)), right)[0]
    assert not scene.visible(2, on_strand((0.6, 1, 0)), down)[0]
    for x, up, free in ((0, 1, False), (0.3, 1, True), (0.3, -1, True)):
        assert scene.visible(1, on_square(x, 0), np.float32([[0.02, up, 0]]))[0] == free


def test_a_point_of_a_mesh_within_a_strand_is_not_in_its_shadow():
    """A root sunk into the floor: what the ray leaves does not block, what it enters does."""
    through = straight(((0, -0.5, 0), (0, 0.5, 0)))
    scene, up = PartsScene([square(), through]), np.float32([[0, 1, 0.001]])
    assert scene.visible(0, on_square(0.05, 0), up)[0]
    assert not scene.visible(0, on_square(0.05, 0.3), np.float32([[0, 0.1, -1]]))[0]


def test_the_floor_blocks_from_both_sides_wherever_the_root_is():
    root = straight(((0, -0.5, 0), (0, 0.5, 0)))
    scene, up = PartsScene([root, square()]), np.float32([[0.1, 1, 0]])
    assert not scene.visible(0, on_strand((0.1, -0.2, 0)), up)[0]
    assert not scene.visible(0, on_strand((0.1, 0.2, 0)), -up)[0]


def test_visibility_of_mixed_parts_is_that_of_each_alone_together():
    """A ball with curls in two parts: blocked is what the ball blocks, or a strand is entered."""
    ball, first, second = sphere(3, 0.5), curls(30, 1), curls(30, 2)
    scene = PartsScene([first, ball, second])
    both = Curves(
        np.concatenate([first.points, second.points]),
        np.concatenate([first.radii, second.radii]),
        np.concatenate([first.offsets, second.offsets[1:] + first.offsets[-1]]),
    )
    rng = np.random.default_rng(4)
    origins = 3 * unit_vectors(rng, 3000)
    directions = (0.6 * unit_vectors(rng, 3000) - origins).astype(np.float32)
    hits, wi = scene.intersect(origins, directions), unit_vectors(rng, 3000)
    alone = PartsScene([ball])
    for part in range(3):
        row = np.flatnonzero(hits.geometry == part)
        assert len(row) > 150
        at = (a[row] for a in (hits.primitive, hits.u, hits.v, hits.ng))
        points, towards = scene.points(part, *at), wi[row]
        actual = scene.visible(part, points, towards)
        enters = np.isfinite(entries(both, points.x, towards))
        if part != 1:
            strand = np.repeat(np.arange(60), 19)
            start_strand = strand[points.segment + 570 * (part == 2)]
            enters &= strand != start_strand[:, None]
            ball_free = ~alone.occluded(points.x, towards)
        else:
            ball_free = alone.visible(0, points, towards)
        assert np.sum(actual != (ball_free & ~enters.any(axis=1))) <= 2  # rays that graze
        assert 0.1 < actual.mean() < 0.9


@pytest.mark.parametrize("cut", [0, 1])
def test_two_halves_of_a_mesh_block_as_the_whole_does(cut):
    """The step is that of the whole asset: parts far from the origin do not tell its halves."""
    far = Mesh(np.float32([[9, 0, 0], [9, 1, 0], [9, 0, 1]]), np.eye(3, dtype=np.float32), None,
               np.uint32([[0, 1, 2]]))  # fmt: skip
    ball = sphere(2)
    whole, parts = PartsScene([merged(ball, far)]), PartsScene([ball, far][:: 1 - 2 * cut])
    assert whole.extent == parts.extent == 9
    rng = np.random.default_rng(1)
    triangle = rng.integers(0, len(ball.triangles), 5000).astype(np.int32)
    at = SurfacePoints.of(ball, triangle, *np.full((2, 5000), 0.3, np.float32))
    wi = unit_vectors(rng, 5000)
    np.testing.assert_array_equal(parts.visible(cut, at, wi), whole.visible(0, at, wi))


def test_the_step_is_a_part_of_the_largest_coordinate():
    """A lid between the step of a small asset and that of a large one."""
    lid = square(size=0.5, height=float(1.5 * OFFSET))
    up = np.float32([[0, 1, 0]])
    near = PartsScene([square(size=0.5), lid])
    far = PartsScene([square(size=0.5), lid, straight(((9, 0, 0), (9, 1, 0)))])
    assert not near.visible(0, on_square(0.1, 0), up)[0]
    assert far.visible(0, on_square(0.1, 0), up)[0]


def test_the_side_from_which_parts_are_seen():
    """A solid shows one side, whichever its triangles are wound to, and a card both."""
    ball = sphere(3)
    turned = Mesh(ball.positions, ball.normals, None, ball.triangles[:, ::-1].copy())
    assert PartsScene([ball]).sides.tolist() == [1]
    assert PartsScene([turned]).sides.tolist() == [-1]
    assert PartsScene([square(), UPRIGHT]).sides.tolist() == [0, 0]
    assert PartsScene([sphere(3, radius=3), ball]).sides.tolist() == [1, 0]  # not seen

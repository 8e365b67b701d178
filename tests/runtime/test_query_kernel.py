"""The compiled query kernel against its numpy twin: features, and the blocks of surfaces."""

from dataclasses import replace

import numpy as np
import pytest

from rna_sdk.package import INPUT_BLOCKS
from rna_sdk.package.blocks import blocks_for
from rna_sdk.runtime.kernels.block_columns import block_columns
from tests.package.builders import INPUTS, make_planes
from tests.reference.queries import queries_reference
from tests.runtime.filling import CORNERS, filled
from tests.runtime.points import Points, random_points

SURFACE_BLOCKS = tuple(blocks_for("surface"))


@pytest.mark.parametrize("precision", ["int8", "float16", "float32"])
@pytest.mark.parametrize(("resolution", "channels"), [(16, 8), (1, 4), (2, 1), (7, 5), (32, 33)])
def test_equals_its_twin(precision, resolution, channels):
    planes = make_planes(resolution, channels, precision)
    points = random_points(1000, reach=2.5)
    queries, valid = filled(planes, points, INPUTS)
    assert valid.all()
    features = planes.decoded() if precision == "int8" else planes
    np.testing.assert_allclose(
        queries, queries_reference(features, CORNERS, INPUTS, *points), rtol=1e-6, atol=2e-6
    )


@pytest.mark.parametrize(
    "inputs",
    [
        SURFACE_BLOCKS,
        SURFACE_BLOCKS[::-1],
        ("features",),
        ("half_vector", "position"),
        ("learned_normal", "wi"),
        ("wi", "features", "wo"),
    ],
)
def test_blocks_stand_in_the_order_of_the_tier(inputs):
    planes = make_planes(8, 4)
    points = random_points(200)
    queries, _ = filled(planes, points, inputs)
    np.testing.assert_allclose(
        queries, queries_reference(planes, CORNERS, inputs, *points), rtol=1e-6, atol=2e-6
    )


def test_columns_of_blocks_that_are_not_there_are_negative():
    columns = dict(zip(INPUT_BLOCKS, block_columns(("wi", "h", "features"), 8), strict=True))
    assert {name: at for name, at in columns.items() if at >= 0} == {"wi": 0, "h": 3, "features": 4}
    assert set(columns.values()) == {-1, 0, 3, 4}


def test_planes_are_xy_yz_zx_with_u_along_rows():
    planes = np.zeros((3, 4, 4, 1), np.float32)
    planes[0, 1, 3], planes[1, 2, 1], planes[2, 3, 2] = 1, 10, 100
    # x in column 3 of 4, y in 1, z in 2: texel centres, so nothing is interpolated.
    low, high = CORNERS
    position = low + (high - low) * (np.array([3, 1, 2]) + 0.5) / 4
    points = Points(np.float32([position]), *np.float32([[[0, 0, 1]]] * 3))
    queries, _ = filled(planes, points, ("features",))
    np.testing.assert_allclose(queries, [[111]], rtol=1e-4)


def test_blocks_of_opposite_directions_are_in_the_middle_of_those_nearby():
    """Half vectors around one pair of opposite directions turn once around them."""
    inputs, planes = ("half_vector", "highlight", "learned_normal"), make_planes(8, 4)
    points = random_points(64)[np.zeros(64, np.int64)]
    o = points.wo[0].astype(float)
    side = np.cross(o, points.normals[0])
    side /= np.linalg.norm(side)
    turn = np.arange(64)[:, None] * np.pi / 32
    around = 1e-3 * (np.cos(turn) * side + np.sin(turn) * np.cross(o, side))
    nearby, valid = filled(planes, replace(points, wi=np.float32(around - o)), inputs)
    exactly, _ = filled(planes, replace(points, wi=-points.wo), inputs)
    assert valid.all()
    cosines = [0, 2, 3, 4, 6]  # of m with n, wi and q; of n with wi and wo
    np.testing.assert_allclose(exactly[0, cosines], nearby[:, cosines].mean(axis=0), atol=1e-3)
    # Where m is across n they agree in all; q is another vector: its gap is among those nearby.
    across = nearby[[0, 32]].mean(axis=0)
    np.testing.assert_allclose(exactly[0, [1, 5]], across[[1, 5]], atol=1e-3)
    assert nearby[:, 7].min() < exactly[0, 7] < nearby[:, 7].max()


def test_features_lean_the_learned_normal():
    """A feature of 1 moves the normal's end by a tenth along its axis; one of -10 undoes it."""
    point = Points(*np.float32([[[0, 0, 0.5]], [[0, 0, 1]], [[0, 0, 1]], [[0, 0, 1]]]))
    for features, cosine in (
        ([0, 1, 0, 7], 1 / np.sqrt(1.01)),
        ([0, 0, -10, 0], 1.0),
        ([5], 0.8944272),
    ):
        planes = np.zeros((3, 1, 1, len(features)), np.float32)
        planes[0, 0, 0] = features
        queries, valid = filled(planes, point, ("learned_normal",))
        assert valid.all()
        gap = np.log2(1 - cosine + 1e-4) / 6
        np.testing.assert_allclose(queries, [[cosine, gap]], rtol=1e-5)


def test_highlights_are_resolved():
    """1 - n.h keeps its digits where n.h is nearly 1, which float32 dot products would lose."""
    points = random_points(500)
    n = points.normals
    wi = n + np.float32(2e-3) * points.wi
    wi /= np.linalg.norm(wi, axis=1, keepdims=True)
    points = Points(points.positions, n, n, wi)
    planes = make_planes(8, 4)
    queries, _ = filled(planes, points, ("half_vector", "highlight"))
    expected = queries_reference(planes, CORNERS, ("half_vector", "highlight"), *points)
    np.testing.assert_allclose(queries[:, 1], expected[:, 1], atol=1e-6)
    # Of unit vectors in float32 an angle of 1e-3 has no more digits: the D of spec/RNA.md, 8.2.
    np.testing.assert_allclose(queries[:, 5], expected[:, 5], atol=6e-5)


def test_length_of_directions_does_not_count():
    planes = make_planes(8, 4)
    points = random_points(100)
    scaled = Points(
        points.positions, points.normals * 2.0**20, points.wo * 2.0**-60, points.wi * 2.0**60
    )
    expected, _ = filled(planes, points, INPUTS)
    queries, valid = filled(planes, scaled, INPUTS)
    assert valid.all()
    np.testing.assert_array_equal(queries, expected)

import numpy as np
import pytest

from rna_export.capture.rays.asset_scene import AssetScene
from tests.exporters.meshes import merged, moved, ring, sphere, square
from tests.exporters.two_parts import spikes
from tests.runtime.points import unit_vectors


def test_points_on_a_ball_are_where_the_ball_is():
    scene = AssetScene([sphere(5)])
    towards = unit_vectors(np.random.default_rng(0), 500)
    points = scene.shade_points(3.0 * towards, -towards)
    assert points.hit.all()
    assert np.abs(points.position - towards).max() < 1e-3
    assert np.sum(points.on[0].points.n * towards, axis=1).min() > 0.99999
    assert np.sum(points.geometric_normal * towards, axis=1).min() > 0.999


def test_points_of_a_pose_are_recorded_at_rest():
    """A pose that is the rest shape as a whole, turned: rays that are turned say the same."""
    parts = sphere(4), spikes(60, radius=0.03)
    turn = np.roll(np.eye(3, dtype=np.float32), 1, axis=0)
    posed = [parts[0].positions @ turn.T, parts[1].points @ turn.T]
    rest, pose = AssetScene(parts), AssetScene(parts, positions=posed)
    towards = unit_vectors(np.random.default_rng(0), 2000)
    aside = 0.3 * unit_vectors(np.random.default_rng(1), 2000)
    origins, wi = (3.0 * towards + aside).astype(np.float32), np.float32([[0.6, 0.8, 0.0]])
    expected = rest.shade_points(origins, -towards)
    actual = pose.shade_points(origins @ turn.T, -towards @ turn.T)
    same = expected.part == actual.part
    assert same.mean() > 0.99
    lit = rest.visible(expected, np.repeat(wi, 2000, axis=0))
    assert (lit == pose.visible(actual, np.repeat(wi @ turn.T, 2000, axis=0))).mean() > 0.98
    for one, other in zip(expected.on, actual.on, strict=True):
        row, a, b = np.intersect1d(one.rows, other.rows, return_indices=True)
        assert len(row) > 40
        for name, values in one.fields.items():
            away = np.abs(values[a] - other.fields[name][b]).reshape(len(row), -1).max(axis=1)
            assert np.quantile(away, 0.98) < 1e-3, name
        turned = other.at_rest(np.repeat(wi @ turn.T, len(other.rows), axis=0))
        np.testing.assert_allclose(turned, np.repeat(wi, len(turned), axis=0), atol=1e-3)


def test_a_miss_leaves_zeros():
    points = AssetScene([sphere(2)]).shade_points(np.float32([[0, 3, 0]]), np.float32([[0, 1, 0]]))
    assert not points.hit.any()
    for values in (points.position, points.geometric_normal):
        assert not values.any()


def test_sampled_points_are_uniform_by_area():
    # One square four times the other's area, its triangles as few as the other's.
    scene = AssetScene([merged(square(2.0), square(1.0, height=5.0))])
    points, normals = scene.sample_points(20_000, np.random.default_rng(0))
    assert np.mean(points[:, 1] > 2.5) == pytest.approx(0.2, abs=0.015)
    assert np.allclose(normals, [0, 1, 0])
    assert np.abs(points[points[:, 1] < 2.5, 0]).mean() == pytest.approx(1.0, abs=0.03)


def test_a_ball_hides_the_square_below_it():
    scene = AssetScene([merged(square(2.0), moved(sphere(4, radius=0.5), (0, 1, 0)))])
    x = np.linspace(-1.5, 1.5, 61, dtype=np.float32)
    origins = np.stack([x, np.full_like(x, 0.3), np.zeros_like(x)], axis=1)
    points = scene.shade_points(origins, np.tile(np.float32([0, -1, 0]), (61, 1)))
    visible = scene.visible(points, np.tile(np.float32([0, 1, 0]), (61, 1)))
    clear = np.abs(np.abs(x) - 0.5) > 0.01
    assert np.array_equal(visible[clear], np.abs(x[clear]) > 0.5)


def test_free_distance_on_the_inside_of_a_ring():
    scene = AssetScene([ring()])
    point, inwards = np.float32([[0.9, 0, 0]]), np.float32([[-1, 0, 0]])
    across = scene.free_distance(point, inwards, inwards)
    assert across == pytest.approx(1.8, abs=0.01)
    assert np.isinf(scene.free_distance(point, inwards, np.float32([[0, 1, 0]])))


@pytest.mark.parametrize("sharpest", [0.02, 0.14])
def test_views_of_highlights_are_spread_down_to_the_sharpest_lobe(sharpest):
    scene, wi = AssetScene([sphere(5)], sharpest), np.float32([0, 0, 1])
    towards = unit_vectors(np.random.default_rng(1), 20_000)
    points = scene.shade_points(3.0 * towards, -towards)
    rows, wo = scene.highlight_views(points, wi, np.random.default_rng(2))
    half = wo + wi
    half /= np.linalg.norm(half, axis=1, keepdims=True)
    angle = np.linalg.norm(np.cross(points.on[0].points.n[rows], half), axis=1)
    # Half of a GGX lobe lies within its alpha; alphas are even in the logarithm, up to 0.8.
    alpha = sharpest**2
    decades = np.log10(0.8 / alpha)
    assert np.mean(angle < alpha) == pytest.approx(0.15 / decades, rel=0.25)
    assert np.median(angle) == pytest.approx(np.sqrt(0.8 * alpha), rel=0.15)

"""Embree's spheres and discs against closed forms."""

import numpy as np
import pytest

from rna_sdk.errors import SceneError
from rna_trace.embree import DiscScene, SphereScene
from rna_trace.embree.tracing import closest_hits, rays_of
from tests.runtime.points import unit_vectors


def hits(scene, origins, directions):
    return closest_hits(scene.handle, rays_of(origins, directions))


@pytest.mark.parametrize("start", [3.0, 0.2])
def test_spheres(start):
    """From outside and from inside."""
    rng = np.random.default_rng(1)
    center, radius = np.float32([[0.3, -0.2, 0.5]]), np.float32([0.7])
    origins = (center + start * unit_vectors(rng, 20_000)).astype(np.float32)
    target = center + 0.9 * unit_vectors(rng, 20_000)
    d = target - origins
    d = (d / np.linalg.norm(d, axis=1, keepdims=True)).astype(np.float32)
    actual = hits(SphereScene(center, radius), origins, d)

    offset, d64 = (center - origins).astype(np.float64), d.astype(np.float64)
    along = np.sum(offset * d64, axis=1)
    discriminant = 0.49 - np.sum((offset - along[:, None] * d64) ** 2, axis=1)
    root = np.sqrt(np.maximum(discriminant, 0))
    near, far = along - root, along + root
    expected = np.where(near > 0, near, far)
    clear = np.abs(discriminant) > 1e-3
    hit = (discriminant > 0) & (far > 0)
    np.testing.assert_array_equal((actual.geometry >= 0)[clear], hit[clear])
    both = clear & hit
    np.testing.assert_allclose(actual.t[both], expected[both], rtol=1e-4)
    normals = (origins + expected[:, None] * d64 - center) / 0.7
    np.testing.assert_allclose(actual.ng[both], normals[both], atol=1e-3)
    assert (actual.u == 0).all() and (actual.v == 0).all()


def test_discs_from_both_sides():
    center, normal = np.float32([[0.3, -0.2, 0.5]]), np.float32([[0, 3, 4]])
    scene = DiscScene(center, normal, np.float32([0.7]))
    rng = np.random.default_rng(2)
    origins = (3 * unit_vectors(rng, 20_000)).astype(np.float32)
    d = center + unit_vectors(rng, 20_000) * np.float32(0.8) - origins
    d = (d / np.linalg.norm(d, axis=1, keepdims=True)).astype(np.float32)
    actual = hits(scene, origins, d)
    n = np.array([0, 0.6, 0.8])
    t = ((center - origins) @ n) / (d @ n)
    distance = np.linalg.norm(origins + t[:, None] * d - center, axis=1)
    clear = np.abs(distance - 0.7) > 1e-3
    hit = (distance < 0.7) & (t > 0)
    np.testing.assert_array_equal((actual.geometry >= 0)[clear], hit[clear])
    both = clear & hit
    assert 0.2 < both.mean() < 0.8
    np.testing.assert_allclose(actual.t[both], t[both], rtol=1e-4)
    np.testing.assert_allclose(actual.ng[both], np.tile(n, (both.sum(), 1)), atol=1e-6)


def test_several_are_told_apart_and_none_are_legal():
    centers = np.float32([[0, 0, 0], [0, 0, 5]])
    scene = SphereScene(centers, np.float32([1, 2]))
    ray = np.float32([[0, 0, 10], [0, 0, -10]]), np.float32([[0, 0, -1], [0, 0, 1]])
    actual = hits(scene, *ray)
    assert actual.primitive.tolist() == [1, 0] and actual.t.tolist() == pytest.approx([3, 9])
    assert scene.extent == 7
    none = np.zeros((0, 3), np.float32)
    for scene in (SphereScene(none, none[:, 0]), DiscScene(none, none, none[:, 0])):
        assert hits(scene, *ray).geometry.tolist() == [-1, -1]


CENTER, RADIUS = np.zeros((1, 3), np.float32), np.ones(1, np.float32)


@pytest.mark.parametrize(
    ("centers", "radii"),
    [
        (CENTER.astype(np.float64), RADIUS),
        (CENTER[0], RADIUS),
        (CENTER, np.ones(2, np.float32)),
        (CENTER * np.nan, RADIUS),
        (CENTER, -RADIUS),
        (CENTER, RADIUS * 0),
        (CENTER, RADIUS * np.inf),
    ],
)
def test_bad_points_are_refused(centers, radii):
    with pytest.raises(SceneError, match="spheres: "):
        SphereScene(centers, radii)
    with pytest.raises(SceneError, match="discs: "):
        DiscScene(centers, np.float32([[0, 0, 1]]), radii)


def test_bad_normals_are_refused():
    for normals in (np.float32([[0, 0, 0]]), np.float32([[0, 0, np.nan]]), np.zeros((1, 3))):
        with pytest.raises(SceneError, match="discs: normals"):
            DiscScene(CENTER, normals, RADIUS)

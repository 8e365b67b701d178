"""Placed scenes: where rays hit them, and which of them block."""

import numpy as np
import pytest

from rna_render.scene.scene_model import TransformModel
from rna_render.scene.transforms import world_from_object
from rna_trace.embree import TriangleScene
from rna_trace.embree.instances import (
    ALL_RAYS,
    CAMERA_RAY,
    INDIRECT_RAY,
    NO_INSTANCE,
    SHADOW_RAY,
    Instance,
    InstanceScene,
)
from tests.render.assets import EMBREE_ROUNDING, sphere, square
from tests.runtime.points import unit_vectors


def placed(**transform) -> np.ndarray:
    return world_from_object(TransformModel(**transform))


def scene_of(mesh) -> TriangleScene:
    return TriangleScene([(mesh.positions, mesh.triangles)])


def test_an_instance_is_hit_where_a_moved_mesh_would_be():
    mesh = sphere(3)
    matrix = placed(translation=(1, -2, 3), rotation_deg=(10, 70, -40), scale=0.4)
    moved = (mesh.positions @ matrix[:3, :3].T + matrix[:3, 3]).astype(np.float32)
    rng = np.random.default_rng(3)
    origins = (unit_vectors(rng, 5000) * np.float32(2) + np.float32([1, -2, 3])).astype(np.float32)
    directions = unit_vectors(rng, 5000)
    directions[::2] = np.float32([1, -2, 3]) - origins[::2]
    hits = InstanceScene([Instance(scene_of(mesh), matrix)]).intersect(origins, directions)
    expected = TriangleScene([(moved, mesh.triangles)]).intersect(origins, directions)
    assert np.mean(hits.primitive == expected.primitive) > 0.999
    same = (hits.primitive == expected.primitive) & (hits.instance >= 0)
    assert same.mean() > 0.4
    np.testing.assert_allclose(hits.t[same], expected.t[same], rtol=1e-4)
    np.testing.assert_allclose(hits.u[same], expected.u[same], atol=2e-3)


def test_hits_name_the_instance_in_front():
    one = scene_of(square())
    scene = InstanceScene([Instance(one, placed(translation=(0, y, 0))) for y in (0, 2, 1)])
    origins = np.float32([[0, 3, 0], [0, -1, 0], [0, 1.5, 0], [9, 3, 0]])
    directions = np.float32([[0, -1, 0], [0, 1, 0], [0, -1, 0], [0, -1, 0]])
    hits = scene.intersect(origins, directions)
    assert hits.instance.tolist() == [1, 0, 2, -1]
    np.testing.assert_allclose(hits.t, [1, 1, 0.5, np.inf], rtol=EMBREE_ROUNDING)
    assert hits.primitive[-1] == -1


def test_a_ray_passes_through_its_own_instance_and_no_other():
    """From inside a ball, with or without a lid over it."""
    ball, lid = scene_of(sphere(3)), scene_of(square(size=3.0))
    scene = InstanceScene([Instance(ball, np.eye(4)), Instance(lid, placed(translation=(0, 2, 0)))])
    instance = np.int32([0, 0, 1, 1])
    origins = np.float32([[0, 0, 0], [0, 0, 0], [0, 2, 0], [0, 2, 0]])
    directions = np.float32([[0, 1, 0], [0, -1, 0], [0, 1, 0], [0, -1, 0]])
    blocked = scene.occluded(origins, directions, start_instance=instance)
    assert blocked.tolist() == [True, False, False, True]
    near = scene.occluded(origins, directions, np.float32([1.5, 9, 9, 0.5]), instance)
    assert near.tolist() == [False] * 4


def test_two_copies_of_one_scene_block_one_another_many_times_over():
    """Rays through many layers of their own instance still find the other one behind."""
    layers = [square(height=y) for y in np.linspace(-1, 1, 50)]
    stack = TriangleScene([(mesh.positions, mesh.triangles) for mesh in layers])
    scene = InstanceScene(
        [Instance(stack, np.eye(4)), Instance(stack, placed(translation=(0, 5, 0)))]
    )
    rng = np.random.default_rng(4)
    origins = (0.1 * unit_vectors(rng, 2000)).astype(np.float32)
    up = np.tile(np.float32([0, 1, 0]), (2000, 1))
    start_instance = np.zeros(2000, np.int32)
    assert scene.occluded(origins, up, start_instance=start_instance).all()
    assert not scene.occluded(origins, -up, start_instance=start_instance).any()


@pytest.mark.parametrize("mask_bits", [0, 3])
def test_what_rays_pass_through_does_not_depend_on_how_they_are_told(monkeypatch, mask_bits):
    """By a bit of the mask for each instance, or by a filter."""
    monkeypatch.setattr("rna_trace.embree.instances.MASK_BITS", mask_bits)
    ball = scene_of(sphere(3))
    scene = InstanceScene(
        [
            Instance(ball, np.eye(4)),
            Instance(ball, placed(translation=(0.5, 0, 0))),
            Instance(scene_of(square(size=3.0)), placed(translation=(0, 2, 0)), SHADOW_RAY),
        ]
    )
    up = np.float32([[0, 1, 0]])
    for start_instance, rays, owner in (
        (None, ALL_RAYS, 2),
        ([0], CAMERA_RAY, 1),
        ([1], INDIRECT_RAY, 0),
        ([NO_INSTANCE], SHADOW_RAY, 2),
        ([2], SHADOW_RAY, -1),
    ):
        start = np.float32([[0.25, 1.5 if owner in (2, -1) else 0, 0]])
        passed = None if start_instance is None else np.int32(start_instance)
        hits = scene.intersect(start, up, passed, rays)
        assert hits.instance.tolist() == [owner], (start_instance, rays)
    blocked = scene.occluded(np.float32([[0.25, 1.5, 0]]), up, start_instance=np.int32([2]))
    assert blocked.tolist() == [False]

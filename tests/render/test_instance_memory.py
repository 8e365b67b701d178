"""Instances of an asset cost its memory once."""

import ctypes

import numpy as np
import pytest

from rna_render.world.placements import Placement
from rna_render.world.world import World
from rna_trace.embree import library as embree_library
from tests.render.assets import LambertAsset, sphere

_Monitor = ctypes.CFUNCTYPE(ctypes.c_bool, ctypes.c_void_p, ctypes.c_ssize_t, ctypes.c_bool)


class EmbreeBytes:
    """Counts what Embree's device allocates, less what it gives back."""

    def __enter__(self):
        self.now = 0
        self._device = embree_library.shared_device()  # which lasts as long as someone has it
        self._callback = _Monitor(self._count)
        self._set(ctypes.cast(self._callback, ctypes.c_void_p))
        return self

    def __exit__(self, *_):
        self._set(None)

    def _count(self, _, size, after):
        self.now += size
        return True

    def _set(self, callback):
        function = embree_library.library().rtcSetDeviceMemoryMonitorFunction
        function.argtypes = [ctypes.c_void_p] * 3
        function.restype = None
        function(self._device.handle, callback, None)


def placed(objects) -> World:
    """The things in a row."""
    result = []
    for k, scene_object in enumerate(objects):
        matrix = np.eye(4)
        matrix[0, 3] = 3.0 * k
        result.append(Placement(scene_object, matrix))
    return World(result)


def bytes_of(objects) -> tuple[int, World]:
    with EmbreeBytes() as counted:
        world = placed(objects)
    return counted.now, world


def test_64_instances_of_an_asset_cost_its_memory_once():
    mesh = sphere(5)
    asset = LambertAsset(mesh)
    one, _ = bytes_of([asset])
    many, world = bytes_of([asset] * 64)
    assert one > 20_480 * 3 * 4  # at least its triangles
    assert many < 1.5 * one
    assert len(set(map(id, world._bodies))) == 1
    apart, _ = bytes_of([LambertAsset(mesh) for _ in range(4)])
    assert apart > 3 * one  # the counter sees what is there twice


@pytest.mark.parametrize("count", [1, 64])
def test_all_instances_are_there(count):
    world = placed([LambertAsset(sphere(1))] * count)
    x = 3.0 * np.arange(count)
    origins = np.column_stack([x, np.full(count, 5.0), 0 * x]).astype(np.float32)
    down = np.tile(np.float32([0, -1, 0]), (count, 1))
    hits = world.scene.intersect(origins, down)
    np.testing.assert_array_equal(np.sort(world.number[hits.instance]), np.arange(count) + 1)

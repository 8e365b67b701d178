"""Placed copies of scenes: one acceleration structure a geometry, however often it is used."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from rna_render import embree_kernels as kernels
from rna_render import embree_library as api
from rna_render.embree_filters import own_instance_filter
from rna_render.rays import per_ray
from rna_render.tracing import ClosestHits, GeometryScene, any_hits, closest_hits


class InstanceScene:
    """Scenes of one mesh or one set of curves each, placed in the world.

    instances: for each, its scene and world_from_object, (4, 4) affine. The same scene may be
    there many times; it is stored once. Raises SceneError if Embree refuses one.
    """

    def __init__(self, instances: Sequence[tuple[GeometryScene, np.ndarray]]) -> None:
        self._count = len(instances)
        self._scene = api.SceneHandle(api.shared_device())
        self._filter = own_instance_filter()
        embree = api.library()
        for index, (scene, world_from_object) in enumerate(instances):
            instance = embree.rtcNewGeometry(self._scene.device.handle, api.GEOMETRY_INSTANCE)
            embree.rtcSetGeometryInstancedScene(instance, scene.handle.handle)
            matrix = np.ascontiguousarray(world_from_object[:3], np.float32)
            layout = api.FORMAT_FLOAT3X4_ROW_MAJOR
            embree.rtcSetGeometryTransform(instance, 0, layout, matrix.ctypes.data)
            self._scene.attach(instance, index)
        self._scene.commit()

    def intersect(self, origins_world: np.ndarray, directions_world: np.ndarray) -> ClosestHits:
        """The closest hit of each ray; its owner is the instance, its normal in object space.

        origins_world, directions_world: (n, 3) float32; n may be 0. Raises QueryError for other
        dtypes or shapes.
        """
        rays = origins_world, directions_world, 0.0, np.inf
        return closest_hits(self._scene, kernels.HIT_INSTANCE, *rays)

    def occluded_by_others(
        self,
        instance: np.ndarray,
        origins_world: np.ndarray,
        directions_world: np.ndarray,
        tfar: np.ndarray | float = np.inf,
    ) -> np.ndarray:
        """Whether each ray hits any instance but its own: (n,) bool.

        It passes through the instance it starts on, by the transport contract, and needs no
        offset for that. instance: (n,) int32. tfar: one number or (n,), distance to the light.
        Other arguments and errors are those of `intersect`.
        """
        if self._count < 2:
            return np.zeros(len(instance), bool)
        own = per_ray("instance", instance, len(instance), np.uint32)
        arguments = self._filter.ctypes.data
        return any_hits(self._scene, arguments, own, origins_world, directions_world, 0.0, tfar)

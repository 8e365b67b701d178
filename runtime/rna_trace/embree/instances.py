"""Placed copies of scenes: one acceleration structure a geometry, however often it is used."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rna_trace.embree import library as api
from rna_trace.embree.filters import (
    random_transmittance_filters,
    start_instance_filter,
    transmittance_filter,
)
from rna_trace.embree.kernels import Rays
from rna_trace.embree.tracing import (
    ClosestHits,
    GeometryScene,
    any_hits,
    closest_hits,
    closest_hits_through,
    rays_of,
    transmitted,
)
from rna_trace.rays import per_ray

# Bits of Embree's masks. Up to as many instances have a bit each, and a ray that passes through
# one does not enter it. Of more instances, bits stand for the sorts of rays that meet them, and a
# filter refuses the hits on a ray's own, one by one: slow where there is much hair to pass through.
MASK_BITS = 32

# Sorts of rays, bits of a mask.
CAMERA_RAY, INDIRECT_RAY, SHADOW_RAY = 1, 2, 4
ALL_RAYS = CAMERA_RAY | INDIRECT_RAY | SHADOW_RAY

_SORTS = (CAMERA_RAY, INDIRECT_RAY, SHADOW_RAY, ALL_RAYS)

NO_INSTANCE = -1


@dataclass(frozen=True, slots=True)
class Instance:
    """A scene, placed.

    world_from_object: (4, 4) affine. rays: bits of the sorts of rays that meet it.
    """

    scene: GeometryScene
    world_from_object: np.ndarray
    rays: int = ALL_RAYS


class InstanceScene:
    """Scenes, placed in the world.

    The same scene may be in many instances; it is stored once. Raises SceneError if Embree
    refuses one.

    Attributes:
        transmits: whether one of them may let light through: rays then pass through hits at
            random, and shadow rays are weakened.
    """

    def __init__(self, instances: Sequence[Instance]) -> None:
        self._count = len(instances)
        # Embree keeps the geometries alive, but not the tables that filters read.
        self._scenes = {placed.scene for placed in instances}
        self._scene = api.SceneHandle(api.shared_device())
        self.transmits = any(placed.scene.transmits for placed in instances)
        self._coloured = any(placed.scene.coloured for placed in instances)
        self._start_bits = len(instances) <= MASK_BITS
        self._met = {rays: _met_by(rays, instances) for rays in _SORTS} if self._start_bits else {}
        embree = api.library()
        for index, placed in enumerate(instances):
            instance = embree.rtcNewGeometry(self._scene.device.handle, api.GEOMETRY_INSTANCE)
            embree.rtcSetGeometryInstancedScene(instance, placed.scene.handle.handle)
            matrix = np.ascontiguousarray(placed.world_from_object[:3], np.float32)
            layout = api.FORMAT_FLOAT3X4_ROW_MAJOR
            embree.rtcSetGeometryTransform(instance, 0, layout, matrix.ctypes.data)
            embree.rtcSetGeometryMask(instance, 1 << index if self._start_bits else placed.rays)
            self._scene.attach(instance, index)
        self._scene.commit()

    def intersect(
        self,
        origins_world: np.ndarray,
        directions_world: np.ndarray,
        start_instance: np.ndarray | None = None,
        rays: int = ALL_RAYS,
    ) -> ClosestHits:
        """The closest hit of each ray; its normal is in object space.

        origins_world, directions_world: (n, 3) float32; n may be 0. start_instance: (n,) int32, the
        instance that each ray passes through; NO_INSTANCE, or None for all, for none of them.
        rays: which sort they are. Raises QueryError for other dtypes or shapes.

        Where hits let light through, rays pass as often as they do; see `ClosestHits.weight`.
        """
        if self._passes_everything(start_instance):
            return _misses(len(origins_world))
        traced = self._rays(origins_world, directions_world, np.inf, start_instance, rays)
        if self.transmits:
            filters = random_transmittance_filters()
            return closest_hits_through(self._scene, filters, self._coloured, traced)
        return closest_hits(self._scene, traced, self._filter(start_instance))

    def occluded(
        self,
        origins_world: np.ndarray,
        directions_world: np.ndarray,
        tfar: np.ndarray | float = np.inf,
        start_instance: np.ndarray | None = None,
    ) -> np.ndarray:
        """Whether each shadow ray hits any instance but its own: (n,) bool.

        tfar: one number or (n,), distance to the light. Other arguments and errors are those of
        `intersect`.
        """
        if self._passes_everything(start_instance):
            return np.zeros(len(origins_world), bool)
        rays = self._rays(origins_world, directions_world, tfar, start_instance, SHADOW_RAY)
        return any_hits(self._scene, rays, self._filter(start_instance))

    def transmittance(
        self,
        origins_world: np.ndarray,
        directions_world: np.ndarray,
        tfar: np.ndarray | float = np.inf,
        start_instance: np.ndarray | None = None,
    ) -> np.ndarray:
        """Transmittance along each shadow ray: (n, 3) float32, 0 where it is blocked.

        Arguments and errors are those of `occluded`, which knows nothing of transmittance.
        """
        if self._passes_everything(start_instance):
            return np.ones((len(origins_world), 3), np.float32)
        rays = self._rays(origins_world, directions_world, tfar, start_instance, SHADOW_RAY)
        return transmitted(self._scene, transmittance_filter(), rays)

    def _passes_everything(self, start_instance: np.ndarray | None) -> bool:
        return self._count == 1 and start_instance is not None and bool((start_instance == 0).all())

    def _filter(self, start_instance: np.ndarray | None) -> int:
        """Address of the arguments by which rays pass what their masks do not leave out, or 0."""
        if start_instance is None or self._start_bits:
            return 0
        return int(start_instance_filter().ctypes.data)

    def _rays(
        self,
        origins: np.ndarray,
        directions: np.ndarray,
        tfar: np.ndarray | float,
        start_instance: np.ndarray | None,
        rays: int,
    ) -> Rays:
        """Rays of a sort, with the instance that each passes through."""
        start = NO_INSTANCE if start_instance is None else start_instance
        ids = per_ray("start_instance", start, len(origins), np.int32).view(np.uint32)
        mask = np.full(1, self._met.get(rays, rays), np.uint32)
        if start_instance is not None and self._start_bits:
            # A shift by 32, for NO_INSTANCE, leaves no bit in 64.
            bit = np.left_shift(np.uint64(1), np.minimum(ids, MASK_BITS).astype(np.uint64))
            mask = mask & ~bit.astype(np.uint32)
        return rays_of(origins, directions, 0.0, tfar, ids, mask)


def _met_by(rays: int, instances: Sequence[Instance]) -> np.uint32:
    """The bits of the instances that a sort of rays meets."""
    bits = (1 << index for index, placed in enumerate(instances) if placed.rays & rays)
    return np.uint32(sum(bits))


def _misses(n: int) -> ClosestHits:
    nothing = np.full(n, -1, np.int32)
    zeros = np.zeros(n, np.float32)
    return ClosestHits(
        np.full(n, np.inf, np.float32),
        *(nothing, nothing, nothing),
        *(zeros, zeros),
        np.zeros((n, 3), np.float32),
    )

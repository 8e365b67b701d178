"""Batches of rays against any Embree scene."""

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from rna_sdk.arrays import vectors
from rna_trace.embree import kernels
from rna_trace.embree import library as api
from rna_trace.embree.filters import transmittance_filter
from rna_trace.rays import per_ray


@dataclass(frozen=True, slots=True)
class ClosestHits:
    """The closest hit of each ray, in Embree's terms; each (n,), misses with -1, infinity or 0.

    instance: int32, number of the instance; -1 in a scene without instances, too.
    geometry: int32, number of the geometry in its scene.
    primitive: int32, number of the triangle or of the curve segment.
    ng: (n, 3) float32, unit geometric normals in the space of the geometry.
    weight: (n, 3) float32, what the light found has to be multiplied by, since rays passed or met
        something coloured at random; None for 1.
    """

    t: np.ndarray
    instance: np.ndarray
    geometry: np.ndarray
    primitive: np.ndarray
    u: np.ndarray
    v: np.ndarray
    ng: np.ndarray
    weight: np.ndarray | None = None

    def take(self, row: np.ndarray) -> "ClosestHits":
        """The given rows."""
        values: list[Any] = [getattr(self, field.name) for field in fields(self)]
        taken: list[Any] = [None if a is None else a.take(row, axis=0) for a in values]
        return ClosestHits(*taken)


# The id of a ray that passes through no instance and no strand, in a scene of either.
NO_START = 0xFFFFFFFE
_NO_ID = np.full(1, NO_START, np.uint32)
_EVERY_BIT = np.full(1, 0xFFFFFFFF, np.uint32)


class GeometryScene:
    """Geometry in one space, for rays in that space and for instances of it.

    A subclass attaches what there is and calls `_commit`.
    """

    def __init__(self) -> None:
        self._scene = api.SceneHandle(api.shared_device())
        self.extent = 0.0
        """Largest absolute coordinate of the geometry: the scale of rounding errors here."""
        self.transmits = False
        """Whether hits may let light through, so that filters have to ask."""
        self.coloured = False
        """Whether some may let more through of one colour than of another."""

    @property
    def handle(self) -> api.SceneHandle:
        """The Embree scene, for another scene to instance; valid as long as this object."""
        return self._scene

    def intersect(
        self,
        origins: np.ndarray,
        directions: np.ndarray,
        tnear: np.ndarray | float = 0.0,
        tfar: np.ndarray | float = np.inf,
    ) -> ClosestHits:
        """The closest hit of each ray within [tnear, tfar]; arguments as for `occluded`.

        Points of triangles are (1 - u - v) p0 + u p1 + v p2. On a segment u is in [0, 1] from its
        first point to its second, and v means nothing.
        """
        return closest_hits(self._scene, rays_of(origins, directions, tnear, tfar))

    def occluded(
        self,
        origins: np.ndarray,
        directions: np.ndarray,
        tnear: np.ndarray | float = 0.0,
        tfar: np.ndarray | float = np.inf,
    ) -> np.ndarray:
        """Whether each ray hits anything within [tnear, tfar]: (n,) bool.

        origins, directions: (n, 3) float32; n may be 0. tnear, tfar: one number, or (n,).
        A ray that is not finite or has no direction misses. Raises QueryError for other dtypes
        or shapes.
        """
        return any_hits(self._scene, rays_of(origins, directions, tnear, tfar))

    def transmittance(
        self,
        origins: np.ndarray,
        directions: np.ndarray,
        tnear: np.ndarray | float = 0.0,
        tfar: np.ndarray | float = np.inf,
    ) -> np.ndarray:
        """Transmittance of each ray between tnear and tfar: (n, 3) float32, 0 where it is blocked.

        Arguments and errors are those of `occluded`.
        """
        rays = rays_of(origins, directions, tnear, tfar)
        return transmitted(self._scene, transmittance_filter(), rays)


def rays_of(
    origins: np.ndarray,
    directions: np.ndarray,
    tnear: np.ndarray | float = 0.0,
    tfar: np.ndarray | float = np.inf,
    ray_id: np.ndarray = _NO_ID,
    mask: np.ndarray = _EVERY_BIT,
) -> kernels.Rays:
    """Rays for the functions below. Arguments and errors are those of GeometryScene.occluded.

    ray_id: (n,) or (1,) uint32, the instance or the strand that rays pass through, as a filter has
    it. mask: (n,) or (1,) uint32; rays meet instances that share one of its bits.
    """
    origins = vectors("origins", origins)
    n = len(origins)
    directions = vectors("directions", directions, n)
    return kernels.Rays(
        ray_id, mask, origins, directions, per_ray("tnear", tnear, n), per_ray("tfar", tfar, n)
    )


def closest_hits(scene: api.SceneHandle, rays: kernels.Rays, arguments: int = 0) -> ClosestHits:
    """Closest hits in any Embree scene. arguments: address of those of an embree_filter, or 0."""
    hits = _hits(len(rays.origins))
    kernels.intersect(api.function_address("rtcIntersect1"), scene.handle, arguments, rays, hits)
    return ClosestHits(*hits)


def any_hits(scene: api.SceneHandle, rays: kernels.Rays, arguments: int = 0) -> np.ndarray:
    """Whether each ray hits anything in any Embree scene: (n,) bool; as `closest_hits`."""
    result = np.empty(len(rays.origins), bool)
    kernels.occluded(api.function_address("rtcOccluded1"), scene.handle, arguments, rays, result)
    return result


def transmitted(scene: api.SceneHandle, arguments: np.ndarray, rays: kernels.Rays) -> np.ndarray:
    """Transmittance along rays in any Embree scene: (n, 3) float32.

    arguments: of a transmittance filter.
    """
    result = np.empty((len(rays.origins), 3), np.float32)
    kernels.transmitted(api.function_address("rtcOccluded1"), scene.handle, arguments, rays, result)
    return result


def closest_hits_through(
    scene: api.SceneHandle,
    filters: tuple[np.ndarray, np.ndarray],
    coloured: bool,
    rays: kernels.Rays,
) -> ClosestHits:
    """Closest hits of rays that pass through hits at random, as often as these let light through.

    filters: random_transmittance_filters. coloured: whether `weight` is wanted, else it is 1.
    """
    hits = _hits(len(rays.origins))
    weight = np.empty((len(rays.origins) if coloured else 0, 3), np.float32)
    functions = api.function_address("rtcIntersect1"), api.function_address("rtcOccluded1")
    kernels.intersect_through(functions, scene.handle, filters, rays, hits, weight)
    return ClosestHits(*hits, weight if coloured else None)


def _hits(n: int) -> kernels.Hits:
    t, u, v = (np.empty(n, np.float32) for _ in range(3))
    instance, geometry, primitive = (np.empty(n, np.int32) for _ in range(3))
    ng = np.empty((n, 3), np.float32)
    return kernels.Hits(t, instance, geometry, primitive, u, v, ng)

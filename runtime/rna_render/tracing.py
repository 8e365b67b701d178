"""Batches of rays against any Embree scene."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from rna_render import embree_kernels as kernels
from rna_render import embree_library as api
from rna_render.rays import per_ray, vectors


@dataclass(frozen=True, slots=True)
class ClosestHits:
    """The closest hit of each ray, in Embree's terms; each (n,), misses with -1, infinity or 0.

    instance: int32, number of the instance; -1 in a scene without instances, too.
    geometry: int32, number of the geometry in its scene.
    primitive: int32, number of the triangle or of the curve segment.
    ng: (n, 3) float32, unit geometric normals in the space of the geometry; (0, 3) if not asked
        for.
    """

    t: np.ndarray
    instance: np.ndarray
    geometry: np.ndarray
    primitive: np.ndarray
    u: np.ndarray
    v: np.ndarray
    ng: np.ndarray


@dataclass(frozen=True, slots=True)
class Passing:
    """What rays pass through.

    arguments: address of the arguments of an embree_filter, or 0. ray_id: (n,) or (1,) uint32,
    what the filter refuses hits on. mask: (n,) or (1,) uint32; rays meet instances that share one
    of its bits.
    """

    arguments: int = 0
    ray_id: np.ndarray = field(default_factory=lambda: np.zeros(1, np.uint32))
    mask: np.ndarray = field(default_factory=lambda: np.full(1, 0xFFFFFFFF, np.uint32))


NOTHING = Passing()


class GeometryScene:
    """Geometry in one space, for rays in that space and for instances of it.

    A subclass attaches what there is and calls `_commit`.
    """

    def __init__(self) -> None:
        self._scene = api.SceneHandle(api.shared_device())
        self.extent = 0.0
        """Largest absolute coordinate of the geometry: the scale of rounding errors here."""

    @property
    def handle(self) -> api.SceneHandle:
        """The Embree scene, for another scene to instance; valid as long as this object."""
        return self._scene

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
        return any_hits(self._scene, origins, directions, tnear, tfar)


def closest_hits(
    scene: api.SceneHandle,
    origins: np.ndarray,
    directions: np.ndarray,
    tnear: np.ndarray | float,
    tfar: np.ndarray | float,
    with_normals: bool = True,
    passing: Passing = NOTHING,
) -> ClosestHits:
    """Closest hits in any Embree scene.

    Arguments and errors are those of GeometryScene.occluded.
    """
    origins = vectors("origins", origins)
    n = len(origins)
    directions = vectors("directions", directions, n)
    interval = per_ray("tnear", tnear, n), per_ray("tfar", tfar, n)
    t, u, v = (np.empty(n, np.float32) for _ in range(3))
    instance, geometry, primitive = (np.empty(n, np.int32) for _ in range(3))
    ng = np.empty((n if with_normals else 0, 3), np.float32)
    function = api.function_address("rtcIntersect1")
    out = t, instance, geometry, primitive, u, v, ng
    through = passing.arguments, passing.ray_id, passing.mask
    rays = origins, directions, *interval
    kernels.intersect(function, scene.handle, *through, *rays, *out)
    return ClosestHits(*out)


def any_hits(
    scene: api.SceneHandle,
    origins: np.ndarray,
    directions: np.ndarray,
    tnear: np.ndarray | float,
    tfar: np.ndarray | float,
    passing: Passing = NOTHING,
) -> np.ndarray:
    """Whether each ray hits anything in any Embree scene: (n,) bool.

    Arguments and errors are those of GeometryScene.occluded.
    """
    origins = vectors("origins", origins)
    n = len(origins)
    directions = vectors("directions", directions, n)
    interval = per_ray("tnear", tnear, n), per_ray("tfar", tfar, n)
    result = np.empty(n, bool)
    function = api.function_address("rtcOccluded1")
    through = passing.arguments, passing.ray_id, passing.mask
    kernels.occluded(function, scene.handle, *through, origins, directions, *interval, result)
    return result

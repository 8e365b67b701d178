"""Triangle meshes that rays are traced against in one space."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rna_render import embree_kernels as kernels
from rna_render import embree_library as api
from rna_render.rays import per_ray, vectors
from rna_sdk.errors import SceneError


@dataclass(frozen=True, slots=True)
class Hits:
    """The closest hit of each ray.

    t: (n,) float32, distance in units of the direction's length; infinity for a miss.
    geometry: (n,) int32, place of the mesh in the scene's list; -1 for a miss.
    triangle: (n,) int32, place of the triangle in its mesh; -1 for a miss.
    u, v: (n,) float32, barycentrics: the point is (1 - u - v) p0 + u p1 + v p2; 0 for a miss.
    """

    t: np.ndarray
    geometry: np.ndarray
    triangle: np.ndarray
    u: np.ndarray
    v: np.ndarray


class TriangleScene:
    """Meshes in one space, behind Embree's robust (watertight) triangle intersection.

    meshes: for each mesh, positions (v, 3) float32 and triangles (t, 3) uint32. Embree keeps a
    copy of both. A scene with no triangles is legal; nothing hits it.

    Raises SceneError for other dtypes or shapes, for positions that are not finite, and for
    triangles that name a vertex that is not there.
    """

    def __init__(self, meshes: Sequence[tuple[np.ndarray, np.ndarray]]) -> None:
        self._scene = api.SceneHandle(api.shared_device())
        self.extent = 0.0
        """Largest absolute coordinate of any vertex: the scale of rounding errors in this space."""
        for index, (positions, triangles) in enumerate(meshes):
            _check_mesh(index, positions, triangles)
            if len(triangles):
                self._attach(index, positions, triangles)
                self.extent = max(self.extent, float(np.abs(positions).max()))
        self._scene.commit()

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
    ) -> Hits:
        """The closest hit of each ray within [tnear, tfar].

        origins, directions: (n, 3) float32; n may be 0. tnear, tfar: one number, or (n,).
        A ray that is not finite or has no direction misses. Raises QueryError for other dtypes
        or shapes.
        """
        return Hits(
            *closest_hits(self._scene, kernels.HIT_GEOMETRY, origins, directions, tnear, tfar)
        )

    def occluded(
        self,
        origins: np.ndarray,
        directions: np.ndarray,
        tnear: np.ndarray | float = 0.0,
        tfar: np.ndarray | float = np.inf,
    ) -> np.ndarray:
        """Whether each ray hits anything within [tnear, tfar]: (n,) bool.

        Arguments and errors are those of `intersect`.
        """
        no_filter, no_ids = 0, np.zeros(1, np.uint32)
        return any_hits(self._scene, no_filter, no_ids, origins, directions, tnear, tfar)

    def _attach(self, index: int, positions: np.ndarray, triangles: np.ndarray) -> None:
        embree = api.library()
        geometry = embree.rtcNewGeometry(self._scene.device.handle, api.GEOMETRY_TRIANGLE)
        for buffer, layout, values in (
            (api.BUFFER_VERTEX, api.FORMAT_FLOAT3, positions),
            (api.BUFFER_INDEX, api.FORMAT_UINT3, triangles),
        ):
            # Memory that Embree allocates has the padding that its 16-byte loads need.
            to = embree.rtcSetNewGeometryBuffer(geometry, buffer, 0, layout, 12, len(values))
            self._scene.device.check(f"copying mesh {index}")
            contiguous = np.ascontiguousarray(values)
            ctypes.memmove(to, contiguous.ctypes.data, contiguous.nbytes)
        self._scene.attach(geometry, index)


def closest_hits(
    scene: api.SceneHandle,
    owner_word: int,
    origins: np.ndarray,
    directions: np.ndarray,
    tnear: np.ndarray | float,
    tfar: np.ndarray | float,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Closest hits in any Embree scene: t, owner, triangle, u, v, each (n,).

    owner_word says which number `owner` is: HIT_GEOMETRY or HIT_INSTANCE of the kernels. The
    rest, and the errors, are those of TriangleScene.intersect.
    """
    origins = vectors("origins", origins)
    n = len(origins)
    directions = vectors("directions", directions, n)
    interval = per_ray("tnear", tnear, n), per_ray("tfar", tfar, n)
    t, u, v = (np.empty(n, np.float32) for _ in range(3))
    owner, triangle = np.empty(n, np.int32), np.empty(n, np.int32)
    function = api.function_address("rtcIntersect1")
    kernels.intersect(
        function, scene.handle, owner_word, origins, directions, *interval, t, owner, triangle, u, v
    )
    return t, owner, triangle, u, v


def any_hits(
    scene: api.SceneHandle,
    arguments: int,
    ray_id: np.ndarray,
    origins: np.ndarray,
    directions: np.ndarray,
    tnear: np.ndarray | float,
    tfar: np.ndarray | float,
) -> np.ndarray:
    """Whether each ray hits anything in any Embree scene: (n,) bool.

    arguments: address of RTCOccludedArguments, or 0. ray_id: (n,) or (1,) uint32. The rest, and
    the errors, are those of TriangleScene.intersect.
    """
    origins = vectors("origins", origins)
    n = len(origins)
    directions = vectors("directions", directions, n)
    interval = per_ray("tnear", tnear, n), per_ray("tfar", tfar, n)
    result = np.empty(n, bool)
    function = api.function_address("rtcOccluded1")
    kernels.occluded(
        function, scene.handle, arguments, ray_id, origins, directions, *interval, result
    )
    return result


def _check_mesh(index: int, positions: np.ndarray, triangles: np.ndarray) -> None:
    for name, values, dtype in (
        ("positions", positions, np.float32),
        ("triangles", triangles, np.uint32),
    ):
        if not isinstance(values, np.ndarray) or values.dtype != dtype:
            found = getattr(values, "dtype", type(values).__name__)
            raise SceneError(f"mesh {index}: {name} must be {dtype.__name__}, found {found}")
        if values.ndim != 2 or values.shape[1] != 3:
            raise SceneError(f"mesh {index}: {name} must be (n, 3), found {values.shape}")
    if not np.isfinite(positions).all():
        raise SceneError(f"mesh {index}: positions must be finite")
    if len(triangles) and int(triangles.max()) >= len(positions):
        raise SceneError(
            f"mesh {index}: a triangle names vertex {int(triangles.max())}, "
            f"but there are {len(positions)}"
        )

"""Geometry that rays are traced against in one space: meshes, spheres or discs."""

from collections.abc import Sequence

import numpy as np

from rna_sdk.errors import SceneError
from rna_sdk.package import Curves
from rna_trace.embree import library as api
from rna_trace.embree.tracing import GeometryScene
from rna_trace.transmittance import Transmittance


class TriangleScene(GeometryScene):
    """Meshes in one space, behind Embree's robust (watertight) triangle intersection.

    meshes: for each mesh, positions (v, 3) float32 and triangles (t, 3) uint32. Embree keeps a
    copy of both. A scene with no triangles is legal; nothing hits it. transmittance: of each mesh,
    None where it is opaque; none at all if left out. `intersect` and `occluded` do not ask for it.

    Raises SceneError for other dtypes or shapes, for positions that are not finite, and for
    triangles that name a vertex that is not there.
    """

    def __init__(
        self,
        meshes: Sequence[tuple[np.ndarray, np.ndarray]],
        transmittance: Sequence[Transmittance | None] = (),
    ) -> None:
        super().__init__()
        self._transmittance = transmittance
        self.transmits = any(of_mesh is not None for of_mesh in transmittance)
        self.coloured = any(of_mesh is not None and of_mesh.coloured for of_mesh in transmittance)
        for index, (positions, triangles) in enumerate(meshes):
            table = transmittance[index] if transmittance else None
            extent = add_mesh(self._scene, index, positions, triangles, table)
            self.extent = max(self.extent, extent)
        self._scene.commit()


class SphereScene(GeometryScene):
    """Spheres in one space; rays hit them from outside and from inside, with u = v = 0.

    centers: (n, 3) float32. radii: (n,) float32. Embree keeps a copy.

    Raises SceneError for other dtypes or shapes, and for values that are not finite or radii that
    are not positive.
    """

    def __init__(self, centers: np.ndarray, radii: np.ndarray) -> None:
        super().__init__()
        _check_points("spheres", centers, radii)
        if len(centers):
            points = (api.BUFFER_VERTEX, api.FORMAT_FLOAT4, np.column_stack([centers, radii]))
            self._scene.add(api.GEOMETRY_SPHERE_POINT, 0, [points])
            self.extent = float((np.abs(centers).max(axis=1) + radii).max())
        self._scene.commit()


class DiscScene(GeometryScene):
    """Discs in one space; rays hit them from both sides, with u = v = 0 and the disc's normal.

    centers: (n, 3) float32. normals: (n, 3) float32, of any length but zero. radii: (n,) float32.
    Embree keeps a copy.

    Raises SceneError for other dtypes or shapes, for values that are not finite, radii that are
    not positive and normals that are zero.
    """

    def __init__(self, centers: np.ndarray, normals: np.ndarray, radii: np.ndarray) -> None:
        super().__init__()
        _check_points("discs", centers, radii)
        if normals.dtype != np.float32 or normals.shape != centers.shape:
            raise SceneError(f"discs: normals must be float32 {centers.shape}")
        if not (np.isfinite(normals).all() and normals.any(axis=1).all()):
            raise SceneError("discs: normals must be finite and not zero")
        if len(centers):
            points = (api.BUFFER_VERTEX, api.FORMAT_FLOAT4, np.column_stack([centers, radii]))
            directions = (api.BUFFER_NORMAL, api.FORMAT_FLOAT3, normals)
            self._scene.add(api.GEOMETRY_ORIENTED_DISC_POINT, 0, [points, directions])
            self.extent = float((np.abs(centers).max(axis=1) + radii).max())
        self._scene.commit()


def _check_points(name: str, centers: np.ndarray, radii: np.ndarray) -> None:
    if centers.dtype != np.float32 or centers.ndim != 2 or centers.shape[1] != 3:
        raise SceneError(f"{name}: centers must be float32 (n, 3)")
    if radii.dtype != np.float32 or radii.shape != centers.shape[:1]:
        raise SceneError(f"{name}: radii must be float32 {centers.shape[:1]}")
    if not (np.isfinite(centers).all() and np.isfinite(radii).all() and (radii > 0).all()):
        raise SceneError(f"{name}: centers and radii must be finite, and radii more than 0")


def add_mesh(
    scene: api.SceneHandle,
    geometry_id: int,
    positions: np.ndarray,
    triangles: np.ndarray,
    transmittance: Transmittance | None = None,
) -> float:
    """Add a mesh, unless it has no triangles; returns its largest absolute coordinate.

    Arguments and errors are those of TriangleScene, but the caller keeps `transmittance` alive.
    """
    _check_mesh(geometry_id, positions, triangles)
    if not len(triangles):
        return 0.0
    buffers = [
        (api.BUFFER_VERTEX, api.FORMAT_FLOAT3, positions),
        (api.BUFFER_INDEX, api.FORMAT_UINT3, triangles),
    ]
    table = 0 if transmittance is None else transmittance.address
    scene.add(api.GEOMETRY_TRIANGLE, geometry_id, buffers, table)
    return float(np.abs(positions).max())


def add_curves(
    scene: api.SceneHandle, geometry_id: int, curves: Curves, table: np.ndarray
) -> float:
    """Add chains of round cones, Embree's round linear curves; returns the largest coordinate
    plus radius.

    Joints inside a strand are spheres that the cones on both sides cover, so a ray inside a
    strand meets no cap there; this is the surface that Cycles renders as THICK_LINEAR. Ends of
    strands are capped by half spheres. Embree does not see a segment without taper along whose
    axis a ray goes to within 1e-4, and a segment longer than some 1,000 radii has a rough outline
    (float32: 1% of its rays fall to the wrong side, and 10% at 3,000).

    table: of their strands, as transmittance.geometry_table; the caller keeps it alive. Raises
    PackageError for Curves that are none, SceneError for points that are not finite and for radii
    that are not finite and positive.
    """
    points, radii, segments = curves.points, curves.radii, curves.segments()
    if not np.isfinite(points).all():
        raise SceneError("curves: points must be finite")
    if not (np.isfinite(radii).all() and (radii > 0).all()):
        raise SceneError("curves: radii must be finite and more than 0")
    buffers = [
        (api.BUFFER_VERTEX, api.FORMAT_FLOAT4, np.column_stack([points, radii])),
        (api.BUFFER_INDEX, api.FORMAT_UINT, segments),
        (api.BUFFER_FLAGS, api.FORMAT_UCHAR, _neighbours(segments)),
    ]
    scene.add(api.GEOMETRY_ROUND_LINEAR_CURVE, geometry_id, buffers, table.ctypes.data)
    return float((np.abs(points).max(axis=1) + radii).max())


def _neighbours(segments: np.ndarray) -> np.ndarray:
    """(m,) uint8, on which sides each segment continues: its point is the next one's first."""
    chained = np.diff(segments) == 1
    left = np.concatenate([[False], chained]) * api.CURVE_NEIGHBOUR_LEFT
    right = np.concatenate([chained, [False]]) * api.CURVE_NEIGHBOUR_RIGHT
    return np.asarray(left | right, np.uint8)


def _check_mesh(index: int, positions: np.ndarray, triangles: np.ndarray) -> None:
    for name, values, dtype in (
        ("positions", positions, np.float32),
        ("triangles", triangles, np.uint32),
    ):
        if not isinstance(values, np.ndarray) or values.dtype != dtype:
            result = getattr(values, "dtype", type(values).__name__)
            raise SceneError(f"mesh {index}: {name} must be {dtype.__name__}, found {result}")
        if values.ndim != 2 or values.shape[1] != 3:
            raise SceneError(f"mesh {index}: {name} must be (n, 3), found {values.shape}")
    if not np.isfinite(positions).all():
        raise SceneError(f"mesh {index}: positions must be finite")
    if len(triangles) and int(triangles.max()) >= len(positions):
        raise SceneError(
            f"mesh {index}: a triangle names vertex {int(triangles.max())}, "
            f"but there are {len(positions)}"
        )

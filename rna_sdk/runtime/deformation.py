"""Rest points: the decoder's queries of a deformed shape. spec/RNA.md, 8.3.

A point of the deformed shape is the same place of the same triangle, or of the same segment, at
rest. Its decoder is evaluated there, with directions turned by the rotation of the deformation.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import first_not_finite, indices, scalars, vectors
from rna_sdk.errors import QueryError
from rna_sdk.machine.kernel_threads import at_most
from rna_sdk.package import Curves, Mesh

Float32 = NDArray[np.float32]

_NEIGHBOURS = 6
"""Strands on either side, in the order of a space-filling curve, that tell a root's rotation."""

_TO_IDENTITY = 1e-9
"""Share of the identity in the fit of a root's rotation, which decides ambiguous cases."""


@dataclass(frozen=True, slots=True)
class RestPoints:
    """Where to query a part for n points of a deformed shape.

    positions: (n, 3) float32, at rest, object space, metres. axes: (n, 3) float32, unit, at rest:
    normals of a mesh, before normal maps, or tangents of strands. rotations: (n, 3, 3) float32,
    from the deformed shape to rest. threads: that a
    call takes at most; None for as many as its caller may.

    Examples:
        >>> asset = load("toy.rna")
        >>> x, y, z = asset.mesh.positions.T
        >>> shape = asset.deformed(np.stack([-x, y, -z], axis=1))  # half a turn about y
        >>> first, middle = np.zeros(1, np.int32), np.full(1, 1 / 3, np.float32)
        >>> rest = shape.rest_points(first, middle, middle)
        >>> bool(np.allclose(rest.to_rest(np.float32([[1, 0, 0]])), [[-1, 0, 0]], atol=1e-4))
        True
    """

    positions: Float32
    axes: Float32
    rotations: Float32
    threads: int | None = None

    def __len__(self) -> int:
        return len(self.positions)

    def to_rest(self, directions: Float32, row: NDArray[np.integer] | None = None) -> Float32:
        """Directions of the deformed shape, turned to rest; both (k, 3) float32.

        row: (k,) indices of the points; None for all, in order.

        Raises:
            QueryError: `directions` is no such array, or a row is not there.
        """
        return self._turned(directions, row, inverse=False)

    def to_deformed(self, directions: Float32, row: NDArray[np.integer] | None = None) -> Float32:
        """Directions at rest, turned to the deformed shape: the inverse of `to_rest`."""
        return self._turned(directions, row, inverse=True)

    def _turned(
        self, directions: Float32, row: NDArray[np.integer] | None, inverse: bool
    ) -> Float32:
        from rna_sdk.runtime.kernels.rest_kernels import turn_rows  # numba loads when it is used

        at = np.arange(len(self)) if row is None else indices("row", row, len(self))
        values = vectors("directions", directions, len(at))
        result = np.empty_like(values)
        with at_most(self.threads):
            turn_rows(self.rotations, inverse, values, at, result)
        return result


class RestMesh:
    """The mesh of a part at rest, with the data that all its deformed shapes share."""

    def __init__(self, mesh: Mesh, threads: int | None = None) -> None:
        self.mesh, self.threads = mesh, threads
        p = mesh.positions[mesh.triangles].astype(np.float64)
        self.weights = _corner_angles(p)
        places = np.column_stack([mesh.positions, mesh.normals]) + np.float32(0)  # no -0
        keys = np.ascontiguousarray(places).view(f"V{places.strides[0]}")[:, 0]
        _, group = np.unique(keys, return_inverse=True)
        self.group = group.reshape(-1).astype(np.int64)

    def deformed(self, positions: Float32) -> "DeformedMesh":
        """The shape with other positions; see `SurfaceAsset.deformed`."""
        return DeformedMesh(self, positions)


class DeformedMesh:
    """A part's mesh with other positions; made by `SurfaceAsset.deformed`.

    Attributes:
        mesh: positions as given, normals turned with the triangles around each vertex; texture
            coordinates and triangles of the package.

    Examples:
        >>> asset = load("toy.rna")
        >>> shape = asset.deformed(2 * asset.mesh.positions)
        >>> bool(np.allclose(shape.mesh.normals, asset.mesh.normals, atol=1e-4))
        True
    """

    def __init__(self, rest: RestMesh, positions: Float32) -> None:
        from rna_sdk.runtime.kernels.rest_kernels import deformed_normals

        mesh, self._rest, self._threads = rest.mesh, rest.mesh, rest.threads
        moved = _checked("positions", positions, len(mesh.positions))
        normals, sums = np.empty_like(moved), np.zeros((len(mesh.positions), 3))
        deformed_normals(
            mesh.positions,
            mesh.normals,
            mesh.triangles,
            rest.weights,
            rest.group,
            moved,
            sums,
            normals,
        )
        self.mesh = Mesh(moved, normals, mesh.uvs, mesh.triangles)

    def rest_points(self, triangle: NDArray[np.integer], u: Float32, v: Float32) -> RestPoints:
        """The rest points of ray hits on the deformed mesh.

        triangle: (n,) int32, indices of triangles. u, v: (n,) float32, barycentric coordinates of
        the second and third corner.

        The rotation is the triangle's (the polar factor of its deformation gradient, normal
        to normal), and then the smallest one that takes the deformed mesh's interpolated normal
        to that at rest. A triangle without area turns as its normal does.

        Raises:
            QueryError: arrays of different length, or a triangle that is not there.
        """
        from rna_sdk.runtime.kernels.rest_kernels import surface_rest_points

        number = indices("triangle", triangle, len(self._rest.triangles)).astype(np.int32)
        count = len(number)
        u, v = scalars("u", u, count), scalars("v", v, count)
        result = _empty(count, self._threads)
        rest = self._rest.positions, self._rest.normals, self._rest.triangles
        moved = self.mesh.positions, self.mesh.normals
        with at_most(self._threads):
            surface_rest_points(
                rest, moved, number, u, v, result.positions, result.axes, result.rotations
            )
        return result


class RestCurves:
    """The strands of a part at rest, with the data that all their deformed shapes share."""

    def __init__(self, curves: Curves, threads: int | None = None) -> None:
        self.curves, self.threads = curves, threads
        self.segments = curves.segments()
        self.offsets = curves.offsets.astype(np.int64)
        self.order = _curve_order(curves.points[self.offsets[:-1]])

    def deformed(self, points: Float32) -> "DeformedCurves":
        """The shape with other points; see `FiberAsset.deformed`."""
        return DeformedCurves(self, points)


class DeformedCurves:
    """A part's strands with other points; made by `FiberAsset.deformed`.

    Attributes:
        curves: points as given, where those of a segment differ; radii and strands of the package.

    Examples:
        >>> hair = load("curls.rna")
        >>> shape = hair.deformed(hair.curves.points + np.float32([0, 1, 0]))
        >>> shape.curves.points.shape == hair.curves.points.shape
        True
    """

    def __init__(self, rest: RestCurves, points: Float32) -> None:
        from rna_sdk.runtime.kernels.rest_kernels import root_covariances, strand_rotations

        curves, self._rest = rest.curves, rest
        moved = _checked("points", points, len(curves.points))
        first, stop = rest.offsets[:-1], rest.offsets[1:]
        strands = np.arange(len(first))
        sums = np.zeros((len(strands), 3, 3))
        self._quaternions = np.empty((len(rest.segments), 4), np.float32)
        with at_most(rest.threads):
            root_covariances(
                curves.points, moved, first, stop - first, rest.order, strands, _NEIGHBOURS, sums
            )
            roots = _quaternions(_nearest_rotations(sums))
            strand_rotations(
                curves.points, moved, first, stop, first - strands, roots, self._quaternions
            )
        self.curves = Curves(_parted(moved, curves, rest.segments), curves.radii, curves.offsets)

    def rest_points(self, segment: NDArray[np.integer], u: Float32, normals: Float32) -> RestPoints:
        """The rest points of ray hits on the deformed strands.

        segment: (n,) int32, indices of segments, in the order of `Curves.segments()`. u: (n,)
        float32, from 0 at a segment's first point to 1 at its second. normals: (n, 3) float32,
        unit, outward normals of the round cones at the hits, deformed.

        The rotation of a strand's first segment is fitted to it and to the strands around its
        root; along the strand it goes on by the smallest rotations from segment to segment.

        Raises:
            QueryError: arrays of different length, or a segment that is not there.
        """
        from rna_sdk.runtime.kernels.rest_kernels import fiber_rest_points

        rest = self._rest.curves
        number = indices("segment", segment, len(self._rest.segments)).astype(np.int32)
        count = len(number)
        u, normals = scalars("u", u, count), vectors("normals", normals, count)
        result = _empty(count, self._rest.threads)
        curves = rest.points, rest.radii, self._rest.segments
        with at_most(self._rest.threads):
            fiber_rest_points(
                curves,
                self._quaternions,
                number,
                u,
                normals,
                result.positions,
                result.axes,
                result.rotations,
            )
        return result


def _empty(count: int, threads: int | None) -> RestPoints:
    positions, axes = np.empty((2, count, 3), np.float32)
    return RestPoints(positions, axes, np.empty((count, 3, 3), np.float32), threads)


def _checked(name: str, value: object, count: int) -> Float32:
    """The positions of a deformed shape: finite, one for each point of the package."""
    moved = vectors(name, value, count)
    if (at := first_not_finite(moved)) is not None:
        raise QueryError(f"{name}: row {at} is {moved[at].tolist()}, expected finite numbers")
    return moved


def _corner_angles(p: NDArray[np.float64]) -> Float32:
    """Angles of triangles (t, 3, 3) at their corners: (t, 3) float32; 0 where there is none."""
    result = np.zeros(p.shape[:2], np.float32)
    for k in range(3):
        a, b = p[:, (k + 1) % 3] - p[:, k], p[:, (k + 2) % 3] - p[:, k]
        across = np.linalg.norm(np.cross(a, b), axis=1)
        result[:, k] = np.arctan2(across, np.sum(a * b, axis=1))
    return result


def _curve_order(points: Float32) -> NDArray[np.int64]:
    """Points along Morton's curve, on which neighbours in space are mostly near: (s,) int64."""
    low, size = points.min(axis=0), float(np.ptp(points, axis=0).max())
    cells = ((points - low) / max(size, 1e-30) * 1023.0).astype(np.uint64)
    code = np.zeros(len(points), np.uint64)
    for bit in range(10):
        for axis in range(3):
            code |= ((cells[:, axis] >> np.uint64(bit)) & np.uint64(1)) << np.uint64(3 * bit + axis)
    return np.argsort(code, kind="stable").astype(np.int64)


def _nearest_rotations(sums: NDArray[np.float64]) -> NDArray[np.float64]:
    """The rotations R for which the trace of R^T sums is largest: (s, 3, 3).

    A share of the identity makes that the smallest rotation where several are as good: about a
    single straight strand, of which nothing tells how it is twisted.
    """
    size = np.linalg.norm(sums, axis=(1, 2))[:, None, None]
    sums = sums / np.where(size > 0.0, size, 1.0) + _TO_IDENTITY * np.eye(3)
    left, _, right = np.linalg.svd(sums)
    left[:, :, 2] *= np.linalg.det(left @ right)[:, None]
    result: NDArray[np.float64] = left @ right
    return result


def _quaternions(m: NDArray[np.float64]) -> NDArray[np.float64]:
    """(s, 4) unit quaternions of rotations (s, 3, 3): columns of the matrix 4 q q^T, the longest.

    Shepperd, "Quaternion from Rotation Matrix" (Journal of Guidance and Control 1(3), 1978).
    """
    x, y, z = m[:, 0, 0], m[:, 1, 1], m[:, 2, 2]
    products = np.empty((len(m), 4, 4))
    for k, value in enumerate((x + y + z, x - y - z, y - x - z, z - x - y)):
        products[:, k, k] = 1.0 + value
    for k, (i, j) in enumerate(((2, 1), (0, 2), (1, 0)), start=1):
        products[:, 0, k] = products[:, k, 0] = m[:, i, j] - m[:, j, i]
    for a, b in ((0, 1), (0, 2), (1, 2)):
        products[:, a + 1, b + 1] = products[:, b + 1, a + 1] = m[:, a, b] + m[:, b, a]
    best = np.argmax(np.diagonal(products, axis1=1, axis2=2), axis=1)
    q = products[np.arange(len(m)), best]
    return np.asarray(q / np.linalg.norm(q, axis=1, keepdims=True))


def _parted(moved: Float32, curves: Curves, segments: NDArray[np.uint32]) -> Float32:
    """The points, those on top of the one before them moved on by a thousandth of the radius."""
    result = moved
    for a in segments[(moved[segments] == moved[segments + 1]).all(axis=1)].tolist():
        result = moved.copy() if result is moved else result
        way = (curves.points[a + 1] - curves.points[a]).astype(np.float64)
        step = max(1e-3 * float(curves.radii[a]), 1e-6 * float(np.abs(moved[a]).max()))
        result[a + 1] = result[a] + step * way / np.linalg.norm(way)
    return result

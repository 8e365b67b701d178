"""Points on fibers: the point and tangent of a hit.

What Embree gives for a hit on a round cone is the sphere of the cone that touches the surface
there (by its place u along the segment) and the normal. Centre plus radius times normal is the
point, with an error of a few units in the last place however far the ray came from.
"""

from dataclasses import dataclass

import numpy as np

from rna_sdk.arrays import check_numbers
from rna_sdk.errors import QueryError
from rna_sdk.machine.compiled import compiled
from rna_sdk.package import Curves
from rna_trace.vectors import Vector, unit, vector_at


def hit_points(
    points: np.ndarray,
    radii: np.ndarray,
    first: np.ndarray,
    segment: np.ndarray,
    u: np.ndarray,
    normals: np.ndarray,
) -> np.ndarray:
    """The points of hits: (n, 3) float32.

    points, radii, first: (p, 3) float32, (p,) float32 and (m,) uint32, as in
    rna_sdk.package.Curves and its `segments()`. segment, u, normals: primitive, u and normals of
    PartHits, without misses. Raises QueryError for a segment that is not there, or arrays
    of different length.
    """
    check_numbers("segment", segment, len(first))
    if not len(segment) == len(u) == len(normals):
        raise QueryError(f"{len(segment)} segments, but {len(u)} u and {len(normals)} normals")
    result = np.empty((len(segment), 3), np.float32)
    _hit_points(points, radii, first, segment, u, normals, result)
    return result


def tangents(points: np.ndarray, first: np.ndarray, segment: np.ndarray) -> np.ndarray:
    """Unit directions of segments, from root to tip: (n, 3) float32.

    A segment without length gives (0, 0, 0). Arguments and errors are those of `hit_points`.
    """
    check_numbers("segment", segment, len(first))
    result = np.empty((len(segment), 3), np.float32)
    _tangents(points, first, segment, result)
    return result


@dataclass(frozen=True, slots=True)
class FiberPoints:
    """Points of strands.

    x: (m, 3) float32, positions. n: (m, 3) float32, outward normals of the round cones.
    tangent: (m, 3) float32, unit, root to tip. segment: (m,) int32, that each is on.
    """

    x: np.ndarray
    n: np.ndarray
    tangent: np.ndarray
    segment: np.ndarray

    @classmethod
    def of(
        cls,
        curves: Curves,
        first: np.ndarray,
        segment: np.ndarray,
        u: np.ndarray,
        normals: np.ndarray,
    ) -> "FiberPoints":
        """The points of hits; arguments as for `hit_points`, first: `curves.segments()`."""
        x = hit_points(curves.points, curves.radii, first, segment, u, normals)
        return cls(x, normals, tangents(curves.points, first, segment), segment)

    def __len__(self) -> int:
        return len(self.x)

    def take(self, row: np.ndarray) -> "FiberPoints":
        """The given rows."""
        x, n, tangent = (a.take(row, axis=0) for a in (self.x, self.n, self.tangent))
        return FiberPoints(x, n, tangent, self.segment[row])


@compiled(fastmath=())
def point_on_cone(points: np.ndarray, radii: np.ndarray, a: int, u: float, n: Vector) -> Vector:
    """The point of a hit at u of the segment that begins at point a: three float64."""
    b = a + 1
    radius = (1.0 - u) * radii[a] + u * radii[b]
    return (
        (1.0 - u) * points[a, 0] + u * points[b, 0] + radius * n[0],
        (1.0 - u) * points[a, 1] + u * points[b, 1] + radius * n[1],
        (1.0 - u) * points[a, 2] + u * points[b, 2] + radius * n[2],
    )


@compiled(fastmath=())
def tangent_at(points: np.ndarray, a: int) -> Vector:
    """The unit direction of the segment that begins at point a."""
    p, q = vector_at(points, a), vector_at(points, a + 1)
    return unit((q[0] - p[0], q[1] - p[1], q[2] - p[2]))


@compiled(rows="segment u normals result", fastmath=())
def _hit_points(
    points: np.ndarray,
    radii: np.ndarray,
    first: np.ndarray,
    segment: np.ndarray,
    u: np.ndarray,
    normals: np.ndarray,
    result: np.ndarray,
) -> None:
    for i in range(len(segment)):
        at = first[segment[i]], np.float64(u[i]), vector_at(normals, i)
        result[i, 0], result[i, 1], result[i, 2] = point_on_cone(points, radii, at[0], at[1], at[2])


@compiled(rows="segment result", fastmath=())
def _tangents(
    points: np.ndarray, first: np.ndarray, segment: np.ndarray, result: np.ndarray
) -> None:
    for i in range(len(segment)):
        result[i, 0], result[i, 1], result[i, 2] = tangent_at(points, first[segment[i]])

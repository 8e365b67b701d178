"""Points on fibers: the point and tangent of a hit, and rays that leave a strand.

What Embree gives for a hit on a round cone is the sphere of the cone that touches the surface
there (by its place u along the segment) and the normal. Centre plus radius times normal is the
point, with an error of a few units in the last place however far the ray came from.
"""

from __future__ import annotations

import numpy as np
from numba import prange

from rna_render.embree import CurveScene
from rna_render.rays import check_numbers, vectors
from rna_sdk.compiled import compiled
from rna_sdk.errors import QueryError


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
    rna_sdk.package.Curves and its `segments()`. segment, u, normals: as in CurveHits, without
    misses. Raises QueryError for a segment that is not there, or arrays of different length.
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


def visible(
    scene: CurveScene,
    positions: np.ndarray,
    segment: np.ndarray,
    wi: np.ndarray,
    tfar: np.ndarray | float = np.inf,
) -> np.ndarray:
    """Whether the rays from fiber points along `wi` meet no other strand of `scene`: (n,) bool.

    This is the visibility of the transport contract for fibers, and the rule of Cycles, whose
    shadow rays skip all segments of the curve they start on and all hits from inside
    (kernel/device/cpu/bvh.h: kernel_embree_is_self_intersection compares curves, not segments;
    kernel_embree_filter_occluded_func_backface_cull). Light that comes through its own strand is
    part of the strand's scattering, and joints and bends shade nothing.

    An offset along the normal, as on meshes, cannot do this: from inside a cone Embree reports
    the exit. The self-intersection avoidance of Embree, which ignores hits within two radii, is
    for flat curves alone: round ones are hit from however near, so touching strands are seen.

    positions, wi: (n, 3) float32, in the scene's space; n may be 0. segment: (n,) int32, that
    each position is on. tfar: one number or (n,), the distance to the light in units of wi's
    length. Raises QueryError for other dtypes or shapes, or a segment that is not there.
    """
    positions = vectors("positions", positions)
    wi = vectors("wi", wi, len(positions))
    check_numbers("segment", segment, len(scene.strands))
    return ~scene.occluded_by_others(scene.strands[segment], positions, wi, tfar)


@compiled(parallel=True, fastmath=())
def _hit_points(points, radii, first, segment, u, normals, result):
    for i in prange(len(segment)):
        a = first[segment[i]]
        b, fu = a + 1, np.float64(u[i])
        radius = (1.0 - fu) * radii[a] + fu * radii[b]
        for axis in range(3):
            centre = (1.0 - fu) * points[a, axis] + fu * points[b, axis]
            result[i, axis] = centre + radius * normals[i, axis]


@compiled(parallel=True, fastmath=())
def _tangents(points, first, segment, result):
    for i in prange(len(segment)):
        a = first[segment[i]]
        b = a + 1
        x = np.float64(points[b, 0]) - points[a, 0]
        y = np.float64(points[b, 1]) - points[a, 1]
        z = np.float64(points[b, 2]) - points[a, 2]
        length = np.sqrt(x * x + y * y + z * z)
        scale = 1.0 / length if length > 0.0 else 0.0
        result[i, 0], result[i, 1], result[i, 2] = x * scale, y * scale, z * scale

"""Points on a mesh: interpolation at a hit, and rays that leave the surface.

The hit point comes from the barycentrics, in float64 and rounded once, so its error is half a
unit in the last place of its coordinates, however far the ray came from.
"""

from __future__ import annotations

import numpy as np
from numba import njit, prange

from rna_render.embree import TriangleScene
from rna_render.rays import check_numbers, vectors
from rna_sdk.errors import QueryError

# An origin moves off the surface by this part of the largest coordinate in its space: some thirty
# times the rounding of the point and of Embree's robust test, which are a few 2^-24 each.
OFFSET = 2.0**-18


def interpolate_positions(
    positions: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
) -> np.ndarray:
    """The points at barycentrics (u, v) of the given triangles: (n, 3) float32.

    positions: (v, 3) float32. triangles: (t, 3) uint32. triangle: (n,) int32, each within
    [0, t). u, v: (n,) float32. Raises QueryError for other shapes, or a triangle out of range.
    """
    return _at_hits(positions, triangles, triangle, u, v, normalise=False)


def interpolate_normals(
    normals: np.ndarray,
    triangles: np.ndarray,
    triangle: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
) -> np.ndarray:
    """Unit shading normals, interpolated from the corners' (v, 3) float32: (n, 3) float32.

    Other arguments and errors are those of `interpolate_positions`. They are not turned towards
    the viewer. Corner normals that cancel give (0, 0, 0).
    """
    return _at_hits(normals, triangles, triangle, u, v, normalise=True)


def geometric_normals(
    positions: np.ndarray, triangles: np.ndarray, triangle: np.ndarray
) -> np.ndarray:
    """Unit normals of the flat triangles, counter-clockwise side: (n, 3) float32.

    Arguments and errors are those of `interpolate_positions`; a triangle without area gives
    (0, 0, 0).
    """
    check_numbers("triangle", triangle, len(triangles))
    result = np.empty((len(triangle), 3), np.float32)
    _geometric_normals(positions, triangles, triangle, result)
    return result


def offset_origins(
    positions: np.ndarray, geometric_normals: np.ndarray, directions: np.ndarray, extent: float
) -> np.ndarray:
    """Origins for rays that leave surface points and must not hit the surface there.

    Each point moves along its geometric normal, to the side its direction is on (the normal's
    own side if it is on neither), by OFFSET * extent. Waechter and Binder, "A Fast and Robust
    Method for Avoiding Self-Intersection" (Ray Tracing Gems, chapter 6), scale the step by the
    point's own coordinates; that fails near the origin of large triangles, whose corners bring
    the rounding errors. So `extent` is the largest absolute coordinate of the whole scene.

    positions, geometric_normals, directions: (n, 3) float32. Returns (n, 3) float32.
    """
    result = np.empty_like(positions)
    _offset(positions, geometric_normals, directions, OFFSET * extent, result)
    return result


def visible(
    scene: TriangleScene,
    positions: np.ndarray,
    geometric_normals: np.ndarray,
    wi: np.ndarray,
    tfar: np.ndarray | float = np.inf,
) -> np.ndarray:
    """Whether the rays from surface points along `wi` meet nothing of `scene`: (n,) bool.

    This is the visibility of the transport contract: it picks the decoder's `visible` or
    `shadowed` output. Light from behind a closed surface is blocked, because the ray starts on
    the side that `wi` is on and so has to leave through the asset.

    positions, geometric_normals, wi: (n, 3) float32, in the scene's space; n may be 0. tfar: one
    number or (n,), the distance to the light in units of wi's length. Raises QueryError for
    other dtypes or shapes.
    """
    positions = vectors("positions", positions)
    geometric_normals = vectors("geometric_normals", geometric_normals, len(positions))
    wi = vectors("wi", wi, len(positions))
    origins = offset_origins(positions, geometric_normals, wi, scene.extent)
    return ~scene.occluded(origins, wi, 0.0, tfar)


def _at_hits(values, triangles, triangle, u, v, normalise):
    check_numbers("triangle", triangle, len(triangles))
    if not len(triangle) == len(u) == len(v):
        raise QueryError(f"{len(triangle)} triangles, but {len(u)} u and {len(v)} v")
    result = np.empty((len(triangle), 3), np.float32)
    _interpolate(values, triangles, triangle, u, v, normalise, result)
    return result


@njit(cache=True, parallel=True, nogil=True)
def _interpolate(values, triangles, triangle, u, v, normalise, result):
    for i in prange(len(triangle)):
        a, b, c = triangles[triangle[i]]
        fu, fv = np.float64(u[i]), np.float64(v[i])
        x = (1.0 - fu - fv) * values[a, 0] + fu * values[b, 0] + fv * values[c, 0]
        y = (1.0 - fu - fv) * values[a, 1] + fu * values[b, 1] + fv * values[c, 1]
        z = (1.0 - fu - fv) * values[a, 2] + fu * values[b, 2] + fv * values[c, 2]
        length = np.sqrt(x * x + y * y + z * z) if normalise else 1.0
        scale = 1.0 / length if length > 0.0 else 0.0
        result[i, 0], result[i, 1], result[i, 2] = x * scale, y * scale, z * scale


@njit(cache=True, parallel=True, nogil=True)
def _geometric_normals(positions, triangles, triangle, result):
    for i in prange(len(triangle)):
        a, b, c = triangles[triangle[i]]
        e1x, e2x = np.float64(positions[b, 0]) - positions[a, 0], positions[c, 0] - positions[a, 0]
        e1y, e2y = np.float64(positions[b, 1]) - positions[a, 1], positions[c, 1] - positions[a, 1]
        e1z, e2z = np.float64(positions[b, 2]) - positions[a, 2], positions[c, 2] - positions[a, 2]
        x = e1y * e2z - e1z * e2y
        y = e1z * e2x - e1x * e2z
        z = e1x * e2y - e1y * e2x
        length = np.sqrt(x * x + y * y + z * z)
        scale = 1.0 / length if length > 0.0 else 0.0
        result[i, 0], result[i, 1], result[i, 2] = x * scale, y * scale, z * scale


@njit(cache=True, parallel=True, nogil=True)
def _offset(positions, geometric_normals, directions, step, result):
    for i in prange(len(positions)):
        toward = np.float64(0.0)
        for axis in range(3):
            toward += np.float64(geometric_normals[i, axis]) * directions[i, axis]
        signed = -step if toward < 0.0 else step
        for axis in range(3):
            result[i, axis] = positions[i, axis] + signed * geometric_normals[i, axis]

"""Offset of a ray across a fiber's width."""

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import vectors


def offset_across(
    normals: NDArray[np.float32], tangents: NDArray[np.float32], wo: NDArray[np.float32]
) -> NDArray[np.float32]:
    """(n,) float32: h of `FiberAsset.evaluate`, n . (t x wo) / |t x wo|, within [-1, 1].

    normals: of the fiber's round surface at the hit. tangents: along the fiber. wo: away from it,
    towards the viewer. All (n, 3) float32 of any length, in one space. Seen from the viewer with t
    upwards, h is the distance to the right of the fiber's axis, in radii. It is 0 where wo is
    parallel to t, and where a vector has length zero or is not finite.

    Raises:
        QueryError: an argument is not an (n, 3) float32 array, or they differ in n.

    Examples:
        >>> eye, up = np.float32([[0, 0, 1]]), np.float32([[0, 1, 0]])
        >>> right = np.float32([[1, 0, 0]])
        >>> offset_across(right, up, eye).tolist()  # the right edge of an upright fiber
        [1.0]
    """
    from rna_sdk.runtime.kernels.row_kernels import fill_offsets  # numba loads when it is used

    normals = vectors("normals", normals)
    tangents = vectors("tangents", tangents, len(normals))
    wo = vectors("wo", wo, len(normals))
    h = np.empty(len(normals), np.float32)
    fill_offsets(normals, tangents, wo, h)
    return h

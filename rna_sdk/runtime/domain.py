"""Whether directions are within the domain of training."""

import numpy as np
from numpy.typing import NDArray

from rna_sdk.arrays import vectors
from rna_sdk.errors import QueryError
from rna_sdk.package.manifest.manifest_fields import Region


def in_region(region: Region, directions: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Whether directions lie in a region of a package's domain: (n,) bool.

    region: `wo` or `wi` of `Asset.domain`. directions: (n, 3) float32, unit, object space.

    Raises:
        QueryError: `directions` is not an (n, 3) float32 array, or `region` has no such name.

    Examples:
        >>> asset = load("toy.rna")  # trained for the whole sphere
        >>> in_region(asset.domain.wi, np.float32([[0, -1, 0]])).tolist()
        [True]
    """
    directions = vectors("directions", directions)
    if region == "sphere":
        return np.ones(len(directions), bool)
    if region == "hemisphere":
        return directions[:, 1] >= 0.0
    if isinstance(region, str):
        expected = "sphere, hemisphere or cones"
        raise QueryError(f"region: expected {expected}, found {region!r}")
    axes = np.array([cone.axis for cone in region])
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    cosines = np.cos([cone.half_angle for cone in region]).astype(np.float32)
    # Without BLAS, whose threads' locks a process forked beside them never gets.
    dots = np.einsum("nc,kc->nk", directions, axes.astype(np.float32))
    return np.asarray((dots >= cosines - _ROUNDING).any(axis=1))


_ROUNDING = np.float32(1e-6)
"""Tolerance for cosines in float32; a cone of angle 0 still contains its axis."""

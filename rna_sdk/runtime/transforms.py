"""Transforms between an asset's object space and world space."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rna_sdk.arrays import vectors
from rna_sdk.errors import QueryError

_TOLERANCE = 1e-5
"""Largest deviation of an entry from a rotation's; matrices often come from float32."""


class Transform:
    """A rotation, a uniform scale and a translation from object space to world space.

    Transport is captured for the asset's own shape, so shear and non-uniform scale are refused.
    Uniform scale does not change radiance: points move and directions rotate. A matrix may mirror:
    the light of a mirrored asset is the mirrored light.

    Attributes:
        matrix: (4, 4) float64, read-only; columns are the object's axes and origin in the world.
        scale: ratio of world to object lengths, positive.

    Examples:
        >>> matrix = np.eye(4)
        >>> matrix[:3, 3] = 0.0, 1.0, 0.0
        >>> placed = Transform(matrix)
        >>> placed.scale
        1.0
        >>> placed.to_object_points(np.float32([[0, 3, 0]])).tolist()
        [[0.0, 2.0, 0.0]]
    """

    def __init__(self, matrix: ArrayLike) -> None:
        """matrix: (4, 4), object to world, acting on column vectors; the last row is 0 0 0 1.

        Raises:
            QueryError: it is not a rotation or mirroring with uniform scale and translation.
        """
        self.matrix = _as_matrix(matrix)
        linear = self.matrix[:3, :3]
        self.scale = float(np.cbrt(abs(np.linalg.det(linear))))
        if not self.scale > 0:
            raise QueryError("transform: the matrix is singular")
        rotation = linear / self.scale
        error = np.abs(rotation.T @ rotation - np.eye(3)).max()
        if not error <= _TOLERANCE:
            raise QueryError("transform: the matrix has shear or non-uniform scale")
        # Contiguous copies: the kernel is compiled for these alone.
        self._to_world = np.ascontiguousarray(linear)
        self._to_object = np.ascontiguousarray(np.linalg.inv(linear), np.float64)
        self._rotate = np.ascontiguousarray(rotation)
        self._rotate_back = np.ascontiguousarray(rotation.T)
        self._origin = np.ascontiguousarray(self.matrix[:3, 3])

    def to_world_points(self, points: NDArray[np.float32]) -> NDArray[np.float32]:
        """Points from object to world space; both (n, 3) float32."""
        return _mapped(points, self._to_world, np.zeros(3), self._origin)

    def to_object_points(self, points: NDArray[np.float32]) -> NDArray[np.float32]:
        """Points from world to object space; both (n, 3) float32."""
        return _mapped(points, self._to_object, self._origin, np.zeros(3))

    def to_world_directions(self, directions: NDArray[np.float32]) -> NDArray[np.float32]:
        """Directions from object to world space, length unchanged; both (n, 3) float32."""
        return _mapped(directions, self._rotate, np.zeros(3), np.zeros(3))

    def to_object_directions(self, directions: NDArray[np.float32]) -> NDArray[np.float32]:
        """Directions from world to object space, length unchanged; both (n, 3) float32."""
        return _mapped(directions, self._rotate_back, np.zeros(3), np.zeros(3))

    def to_world_normals(self, normals: NDArray[np.float32]) -> NDArray[np.float32]:
        """Normals from object to world space: as directions, since scale is uniform."""
        return self.to_world_directions(normals)

    def to_object_normals(self, normals: NDArray[np.float32]) -> NDArray[np.float32]:
        """Normals from world to object space: as directions, since scale is uniform."""
        return self.to_object_directions(normals)


def _as_matrix(matrix: ArrayLike) -> NDArray[np.float64]:
    try:
        result = np.array(matrix, np.float64)
    except (TypeError, ValueError) as error:
        raise QueryError(f"transform: expected a (4, 4) matrix of numbers: {error}") from None
    if result.shape != (4, 4):
        raise QueryError(f"transform: expected a (4, 4) matrix, found {result.shape}")
    if not np.isfinite(result).all():
        raise QueryError("transform: the matrix holds NaN or infinite values")
    if not np.array_equal(result[3], [0, 0, 0, 1]):
        raise QueryError(f"transform: expected a last row 0 0 0 1, found {result[3].tolist()}")
    result.flags.writeable = False
    return result


def _mapped(
    values: NDArray[np.float32],
    linear: NDArray[np.float64],
    before: NDArray[np.float64],
    after: NDArray[np.float64],
) -> NDArray[np.float32]:
    """linear @ (v - before) + after for each row v, in float64, rounded to float32."""
    from rna_sdk.runtime.kernels.row_kernels import map_rows  # numba loads when it is used

    source = vectors("values", values)
    result = np.empty_like(source)
    map_rows(source, linear, before, after, result)
    return result

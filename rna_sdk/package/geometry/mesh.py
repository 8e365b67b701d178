"""The geometry of a surface asset, as arrays."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.issues import Code, refuse

if TYPE_CHECKING:
    from rna_sdk.package.geometry.quantised_mesh import QuantisedMesh


@dataclass(frozen=True, eq=False)
class Mesh:
    """A triangle mesh in object space, metres, right-handed with +Y up.

    Attributes:
        positions: (v, 3) float32.
        normals: (v, 3) float32, unit; vertices on hard edges are duplicated, one per normal.
        uvs: (v, 2) float32 with glTF's origin (top left), or None.
        triangles: (t, 3) uint32, counter-clockwise from outside.
        quantised: the integers that the arrays were restored from and that are stored in the
            file; None if the arrays themselves are stored. `dataclasses.replace` resets it.

    Raises:
        PackageError: GEOMETRY_ARRAY, if a shape or dtype differs.

    Examples:
        >>> corners = np.float32([[0, 0, 0], [1, 0, 0], [0, 0, -1]])
        >>> up = np.tile(np.float32([0, 1, 0]), (3, 1))
        >>> mesh = Mesh(corners, up, None, np.uint32([[0, 1, 2]]))
        >>> mesh.box()[1].tolist()
        [1.0, 0.0, 0.0]
    """

    positions: NDArray[np.float32]
    normals: NDArray[np.float32]
    uvs: NDArray[np.float32] | None
    triangles: NDArray[np.uint32]
    quantised: QuantisedMesh | None = field(default=None, init=False, repr=False)

    def __post_init__(self) -> None:
        v, t = len(self.positions), len(self.triangles)
        check_array("positions", self.positions, (v, 3), np.float32)
        check_array("normals", self.normals, (v, 3), np.float32)
        check_array("triangles", self.triangles, (t, 3), np.uint32)
        if self.uvs is not None:
            check_array("uvs", self.uvs, (v, 2), np.float32)
        if v == 0 or t == 0:
            refuse(Code.GEOMETRY_ARRAY, "/geometry", f"{v} vertices, {t} triangles", "some of both")

    def box(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Lower and upper corner of the bounding box, each (3,) float32."""
        return self.positions.min(axis=0), self.positions.max(axis=0)


def check_array(name: str, array: NDArray[np.generic], shape: tuple[int, ...], dtype: type) -> None:
    """Raises PackageError (GEOMETRY_ARRAY) if the shape or dtype differs."""
    if array.shape != shape or array.dtype != dtype:
        found = f"{name} {array.dtype} {list(array.shape)}"
        refuse(Code.GEOMETRY_ARRAY, "/geometry", found, f"{np.dtype(dtype)} {list(shape)}")

"""A mesh in integers, 16 bits an axis, and the mesh that every reader restores."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.geometry.mesh import Mesh

POSITION_STEPS = 65535
NORMAL_STEPS = 32767
UV_STEPS = 65535


@dataclass(frozen=True, eq=False)
class QuantisedMesh:
    """Contents of a file of a quantised mesh (glTF's KHR_mesh_quantization).

    Attributes:
        translation: (3,) float64, metres.
        scale: (1,) float64, metres a step, greater than 0.
        positions: (v, 3) uint16, steps.
        normals: (v, 3) int16, of 32767.
        uvs: (v, 2) uint16, of 65535; or float32, as they are; or None.
        triangles: (t, 3) uint32.
    """

    translation: NDArray[np.float64]
    scale: NDArray[np.float64]
    positions: NDArray[np.uint16]
    normals: NDArray[np.int16]
    uvs: NDArray[Any] | None
    triangles: NDArray[np.uint32]

    def restored(self) -> Mesh:
        """The mesh that all readers use: float64 throughout, rounded to float32 once.

        Raises:
            PackageError: GEOMETRY_ARRAY, where a shape or dtype is another.
        """
        with np.errstate(over="ignore"):  # to infinity, which readers refuse
            positions = (self.translation + self.scale * self.positions).astype(np.float32)
        mesh = Mesh(positions, _unit(self.normals), self._uvs(), self.triangles)
        object.__setattr__(mesh, "quantised", self)
        return mesh

    def _uvs(self) -> NDArray[np.float32] | None:
        if self.uvs is None or self.uvs.dtype == np.float32:
            return self.uvs
        return (self.uvs / np.float64(UV_STEPS)).astype(np.float32)


def stored_normals(normals: NDArray[np.int16]) -> NDArray[np.float64]:
    """(v, 3) in [-1, 1], as glTF reads normalised int16."""
    values: NDArray[np.float64] = np.maximum(normals / np.float64(NORMAL_STEPS), -1.0)
    return values


def quantise_mesh(mesh: Mesh) -> Mesh:
    """The nearest mesh that 16 bits an axis hold; one that is quantised stays as it is.

    A step is the longest side of its box over 65535. Texture coordinates that leave [0, 1] stay
    float32.
    """
    if mesh.quantised is not None:
        return mesh
    low, high = (corner.astype(np.float64) for corner in mesh.box())
    # An extent of 0 has no step; any will do.
    scale = float((high - low).max()) / POSITION_STEPS or 1.0
    uvs: NDArray[Any] | None = mesh.uvs
    if mesh.uvs is not None and mesh.uvs.min() >= 0 and mesh.uvs.max() <= 1:
        uvs = _rounded(mesh.uvs.astype(np.float64) * UV_STEPS, np.uint16)
    return QuantisedMesh(
        translation=low,
        scale=np.array([scale]),
        positions=_rounded(np.clip((mesh.positions - low) / scale, 0, POSITION_STEPS), np.uint16),
        normals=_rounded(np.clip(mesh.normals, -1.0, 1.0) * np.float64(NORMAL_STEPS), np.int16),
        uvs=uvs,
        triangles=mesh.triangles,
    ).restored()


def _rounded(values: NDArray[np.float64], dtype: type) -> NDArray[Any]:
    return np.rint(values).astype(dtype)


def _unit(normals: NDArray[np.int16]) -> NDArray[np.float32]:
    """Normals scaled to unit length; (0, 0, 0) is unchanged."""
    x, y, z = stored_normals(normals).T
    lengths = np.sqrt(x * x + y * y + z * z)
    lengths[lengths == 0] = 1.0
    return np.stack([x / lengths, y / lengths, z / lengths], axis=1).astype(np.float32)

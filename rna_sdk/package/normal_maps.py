"""Normal maps of a part: textures from and to their entries, and records with them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import MAX_TEXTURE_SIDE
from rna_sdk.package.manifest import NormalMapRecord, Part
from rna_sdk.package.mesh import Mesh
from rna_sdk.package.tensor_file import (
    TensorCodes,
    TensorForm,
    tensors_from_bytes,
    tensors_to_bytes,
)
from rna_sdk.package.texture_ranges import check_last_range

Texels = NDArray[np.uint8]
"""(H, W, 2) uint8: 127 + 127 times x and y of the normal; row 0 is v = 0."""

TENSOR = "normals"
_SIDE = range(1, MAX_TEXTURE_SIDE + 1)
_FORMS = {TENSOR: TensorForm("uint8", (_SIDE, _SIDE, range(2, 3)))}
_CODES = TensorCodes(*[Code.NORMAL_MAP_TEXTURE] * 6)


@dataclass(frozen=True, eq=False)
class NormalMap:
    """The relief of a range of a mesh's triangles (spec/RNA.md, 4.5).

    Attributes:
        first, count: the triangles.
        texture: (H, W, 2) uint8, read-only.
    """

    first: int
    count: int
    texture: Texels


def normals_to_bytes(texture: NDArray[Any], name: str) -> bytes:
    """The tensor file of a map.

    Raises:
        PackageError: NORMAL_MAP_TEXTURE, where it is no (H, W, 2) uint8 array.
    """
    form = _FORMS[TENSOR]
    if texture.dtype != np.uint8 or not form.fits(list(texture.shape)):
        found = f"{texture.dtype} {list(texture.shape)}"
        refuse(Code.NORMAL_MAP_TEXTURE, name, found, f"uint8 {form}")
    return tensors_to_bytes({TENSOR: texture})


def normals_from_bytes(data: memoryview, name: str) -> Texels:
    """The map in the entry `data`, as a read-only view.

    Raises:
        PackageError: NORMAL_MAP_TEXTURE, or a JSON_* issue.
    """
    texture: Texels = tensors_from_bytes(data, name, _FORMS, _CODES)[TENSOR]
    return texture


def check_normal_maps(
    part: Part, mesh: Mesh, texture_of: Callable[[NormalMapRecord], Texels | None], where: str
) -> None:
    """Compare the records of a part with its mesh.

    texture_of: the record's texture, or None where it is not as it must be.
    where: JSON pointer of the part's `normalMaps`.

    Raises:
        PackageError: NORMAL_MAP_RANGE or NORMAL_MAP_UV.
    """
    ranges = [record.triangles for record in part.normal_maps]
    check_last_range(ranges, mesh, Code.NORMAL_MAP_RANGE, where)
    if ranges and mesh.uvs is None:
        refuse(Code.NORMAL_MAP_UV, part.geometry, "no TEXCOORD_0", "texture coordinates")
    for record in part.normal_maps:
        texture_of(record)

"""Holes and thin glass of a part: textures from and to their entries, and records with them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import MAX_TEXTURE_SIDE
from rna_sdk.package.manifest import Part, TransmittanceRecord
from rna_sdk.package.mesh import Mesh
from rna_sdk.package.tensor_file import (
    TensorCodes,
    TensorForm,
    tensors_from_bytes,
    tensors_to_bytes,
)
from rna_sdk.package.texture_ranges import check_last_range

Texture = NDArray[np.uint8]
"""(H, W, C) uint8, C of 1 or 3: 255 times the transmittance, linear; row 0 is v = 0."""

TENSOR = "transmittance"
_SIDE = range(1, MAX_TEXTURE_SIDE + 1)
_FORMS = {TENSOR: TensorForm("uint8", (_SIDE, _SIDE, range(1, 4, 2)))}
_CODE = Code.TRANSMITTANCE_TEXTURE
_CODES = TensorCodes(*[_CODE] * 6)


@dataclass(frozen=True, eq=False)
class Transmittance:
    """What lets light through in a range of a mesh's triangles (spec/RNA.md, 4.4).

    Attributes:
        first, count: the triangles.
        texture: (H, W, C) uint8, read-only.
        cutoff: a hole where the texture is greater than this; None: partly transparent.
        ior: relative indices of refraction from the front and from the back; None: no Fresnel.
    """

    first: int
    count: int
    texture: Texture
    cutoff: float | None
    ior: tuple[float, float] | None


def texture_to_bytes(texture: NDArray[Any], name: str) -> bytes:
    """The tensor file of a texture.

    Raises:
        PackageError: TRANSMITTANCE_TEXTURE, where it is no (H, W, 1 or 3) uint8 array.
    """
    form = _FORMS[TENSOR]
    if texture.dtype != np.uint8 or not form.fits(list(texture.shape)):
        refuse(_CODE, name, f"{texture.dtype} {list(texture.shape)}", f"uint8 {form}")
    return tensors_to_bytes({TENSOR: texture})


def texture_from_bytes(data: memoryview, record: TransmittanceRecord) -> Texture:
    """The texture in the record's entry `data`, as a read-only view.

    Raises:
        PackageError: TRANSMITTANCE_TEXTURE, or a JSON_* issue.
    """
    texture: Texture = tensors_from_bytes(data, record.texture, _FORMS, _CODES)[TENSOR]
    if record.cutoff is not None and texture.shape[2] != 1:
        where = f"{record.texture}#/{TENSOR}/shape"
        refuse(_CODE, where, f"{texture.shape[2]} channels", "1, for a record with a cutoff")
    return texture


def check_records(
    part: Part, mesh: Mesh, texture_of: Callable[[TransmittanceRecord], Texture | None], where: str
) -> None:
    """Compare the records of a part with its mesh.

    texture_of: the record's texture, or None where it is not as it must be.
    where: JSON pointer of the part's `transmittance`.

    Raises:
        PackageError: TRANSMITTANCE_RANGE or TRANSMITTANCE_UV.
    """
    ranges = [record.triangles for record in part.transmittance]
    check_last_range(ranges, mesh, Code.TRANSMITTANCE_RANGE, where)
    for record in part.transmittance:
        texture = texture_of(record)
        if texture is not None and texture.shape[:2] != (1, 1) and mesh.uvs is None:
            found, expected = f"no TEXCOORD_0 beside {record.texture}", "texture coordinates"
            refuse(Code.TRANSMITTANCE_UV, part.geometry, found, expected)

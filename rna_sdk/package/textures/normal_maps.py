"""Normal maps of a part: the form of their textures, and records with them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.manifest.manifest_model import NormalMapRecord, Part
from rna_sdk.package.textures.texture_form import Texture, TextureForm, check_last_range

NORMALS = TextureForm("normals", range(2, 3), Code.NORMAL_MAP_TEXTURE)
"""Texels are 127 + 127 times x and y of the normal."""


@dataclass(frozen=True, eq=False)
class NormalMap:
    """Normal map of a range of a mesh's triangles (spec/RNA.md, 4.5).

    Attributes:
        first, count: the range of triangles.
        texture: (H, W, 2) uint8, read-only.
    """

    first: int
    count: int
    texture: Texture


def check_normal_maps(
    part: Part, mesh: Mesh, texture_of: Callable[[NormalMapRecord], Texture | None], where: str
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

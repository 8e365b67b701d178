"""Normal maps of a part: the form of their textures, and records with them."""

from dataclasses import dataclass

from rna_sdk.package.issues import Code
from rna_sdk.package.textures.texture_form import Texture, TextureForm

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

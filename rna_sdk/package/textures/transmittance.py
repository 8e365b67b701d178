"""Holes and thin glass of a part: the form of their textures, and records with them."""

from dataclasses import dataclass

from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.manifest.manifest_model import TransmittanceRecord
from rna_sdk.package.textures.texture_form import Texture, TextureForm

TRANSMITTANCE = TextureForm("transmittance", range(1, 4, 2), Code.TRANSMITTANCE_TEXTURE)
"""Texels are 255 times the transmittance, linear."""


@dataclass(frozen=True, eq=False)
class Transmittance:
    """Transmittance of a range of a mesh's triangles (spec/RNA.md, 4.4).

    Attributes:
        first, count: the range of triangles.
        texture: (H, W, C) uint8, read-only.
        cutoff: a hole where the texture is greater than this; None: partly transparent.
        ior: relative indices of refraction from the front and from the back; None: no Fresnel.
    """

    first: int
    count: int
    texture: Texture
    cutoff: float | None
    ior: tuple[float, float] | None


def texture_from_bytes(data: memoryview, record: TransmittanceRecord) -> Texture:
    """The texture in the record's entry `data`, as a read-only view.

    Raises:
        PackageError: TRANSMITTANCE_TEXTURE, or a JSON_* issue.
    """
    texture = TRANSMITTANCE.from_bytes(data, record.texture)
    if record.cutoff is not None and texture.shape[2] != 1:
        where, found = f"{record.texture}#/{TRANSMITTANCE.tensor}/shape", texture.shape[2]
        refuse(TRANSMITTANCE.code, where, f"{found} channels", "1, for a record with a cutoff")
    return texture

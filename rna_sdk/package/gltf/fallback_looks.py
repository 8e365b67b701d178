"""The materials of a fallback: a stand-in with holes, normal maps and images of base colour."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.gltf.fallback_file import IMAGES, REPEAT, FallbackFile
from rna_sdk.package.manifest.extensions import StandinMaterial
from rna_sdk.package.manifest.manifest_model import BaseColorRecord, Wrap
from rna_sdk.package.textures.base_color import IDENTITY, WHITE
from rna_sdk.package.textures.normal_maps import NormalMap
from rna_sdk.package.textures.transmittance import Transmittance


@dataclass(frozen=True)
class Print:
    """An image of base colour on a range of triangles, as a texture of glTF can have it."""

    first: int
    count: int
    image: str
    factor: tuple[float, float, float]
    wrap: tuple[Wrap, Wrap]


_Range = Transmittance | NormalMap | Print
"""Ranges of triangles with textures of their own."""


def prints_of(records: Sequence[BaseColorRecord], holes: Sequence[Transmittance]) -> list[Print]:
    """The images of base colour that viewers know, where no hole needs their alpha."""
    result = []
    for record in records:
        first, count = record.triangles
        is_known = record.color_space in (None, "srgb") and record.transform in (None, IDENTITY)
        is_solid = all(
            hole.first + hole.count <= first or first + count <= hole.first for hole in holes
        )
        if record.image and PurePosixPath(record.image).suffix in IMAGES and is_known and is_solid:
            wrap = record.wrap or REPEAT
            result.append(Print(first, count, record.image, record.factor or WHITE, wrap))
    return result


class Looks:
    """The materials of a part, one for each set of textures that a triangle may have.

    textures: entries by member of RNA_standin_textures; empty for none. glow: the members of a
    material that sends out light.
    """

    def __init__(
        self,
        file: FallbackFile,
        name: str,
        base: StandinMaterial,
        holes: list[Transmittance],
        reliefs: list[NormalMap],
        prints: list[Print],
        textures: Mapping[str, str],
        glow: Mapping[str, Any],
    ) -> None:
        self._common = {"name": name, "doubleSided": True, **glow}
        self._file, self._base, self._textures = file, base, textures
        self._records: tuple[Sequence[_Range], ...] = (holes, reliefs, prints)
        self._holes, self._reliefs, self._prints = holes, reliefs, prints
        self._made: dict[tuple[int | None, ...], int] = {}

    def borders(self) -> list[int]:
        """The triangles at which another material may begin or end."""
        every = (record for records in self._records for record in records)
        return [end for r in every for end in (r.first, r.first + r.count)]

    def material_at(self, triangle: int) -> int:
        """Index of the material of a triangle."""
        key = tuple(_of(records, triangle) for records in self._records)
        if key not in self._made:
            self._made[key] = self._file.add("materials", self._material(*key))
        return self._made[key]

    def _textured(self) -> dict[str, Any]:
        """A part with textures has neither holes nor reliefs."""
        images = {name: self._file.texture_of(entry) for name, entry in self._textures.items()}
        surface = {
            "baseColorTexture": images["base_color"],
            "metallicRoughnessTexture": images["metallic_roughness"],
        }
        return {"pbrMetallicRoughness": surface, "normalTexture": images["normal"]}

    def _material(self, hole: int | None, relief: int | None, print_: int | None) -> dict[str, Any]:
        if self._textures:
            return {**self._common, **self._textured()}
        base = self._base
        surface: dict[str, Any] = {
            "baseColorFactor": [*base.base_color, 1.0],
            "metallicFactor": base.metallic,
            "roughnessFactor": base.roughness,
        }
        material = {**self._common, "pbrMetallicRoughness": surface}
        if print_ is not None:
            of = self._prints[print_]
            surface["baseColorFactor"][:3] = of.factor
            surface["baseColorTexture"] = self._file.texture_of(of.image, of.wrap)
        if hole is not None:
            record = self._holes[hole]
            alpha = 255 - record.texture.mean(axis=2).round().astype(np.uint8)
            if alpha.size == 1:
                surface["baseColorFactor"][3] = float(alpha.item()) / 255.0
            else:
                white = np.full((*alpha.shape, 3), 255, np.uint8)
                surface["baseColorTexture"] = self._file.texture(np.dstack([white, alpha]))
            material["alphaMode"] = "BLEND" if record.cutoff is None else "MASK"
            if record.cutoff is not None:
                material["alphaCutoff"] = 1.0 - record.cutoff
        if relief is not None:
            pixels = _gltf_normals(self._reliefs[relief].texture)
            material["normalTexture"] = self._file.texture(pixels)
        return material


def _of(records: Sequence[_Range], triangle: int) -> int | None:
    """Number of the record whose range has the triangle."""
    for i, record in enumerate(records):
        if record.first <= triangle < record.first + record.count:
            return i
    return None


def _gltf_normals(texels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A map (h, w, 2) of the package, 127 + 127 x, as glTF has it: (h, w, 3), 127.5 (1 + x)."""
    xy = (texels.astype(np.float64) - 127.0) / 127.0
    z = np.sqrt(np.maximum(0.0, 1.0 - (xy**2).sum(axis=2)))
    scaled = np.round(127.5 * (1.0 + np.dstack([xy, z])))
    pixels: NDArray[np.uint8] = np.clip(scaled, 0, 255).astype(np.uint8)
    return pixels

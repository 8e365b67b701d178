"""Materials of glTF 2.0 files: section 3.9 of the specification, and some extensions.

Read: base colour, metallic, roughness and emission with their textures; KHR_texture_transform,
KHR_materials_emissive_strength, KHR_materials_ior, EXT_texture_webp. Materials are shown from both
sides, and occlusion textures have no place in a path tracer; all else that changes the look is
listed as left out.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from rna_render.bilinear import CLAMP, MIRROR, REPEAT
from rna_render.limits import MAX_NUMBER
from rna_render.materials.gltf_container import GltfContainer
from rna_render.materials.material import Material, reflectance_of_ior
from rna_render.materials.textures import IDENTITY, LINEAR, SRGB, Texture, read_texels

# Section 3.8.4.4, from OpenGL.
WRAPS = {10497: REPEAT, 33071: CLAMP, 33648: MIRROR}
NEAREST = 9728

READ_EXTENSIONS = {"KHR_materials_emissive_strength", "KHR_materials_ior"}


class GltfMaterials:
    """Reads the materials of one file, each image once. left_out: what of their look is not
    read, as a phrase each."""

    def __init__(self, container: GltfContainer) -> None:
        self._container = container
        self._texels: dict[int, np.ndarray] = {}
        self.left_out: set[str] = set()

    def read(self, used: Iterable[int | None]) -> dict[int | None, Material]:
        """The given materials by number; None is the default one of section 3.9.6.

        SceneError if an image cannot be read; whatever Python raises if the JSON is wrong.
        """
        return {number: self._material(number) for number in used}

    def _material(self, number: int | None) -> Material:
        data = {} if number is None else self._container.json["materials"][number]
        metal_rough, extensions = data.get("pbrMetallicRoughness", {}), data.get("extensions", {})
        self._note_left_out(data, extensions)
        strength = extensions.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1)
        ior = extensions.get("KHR_materials_ior", {}).get("ior", 1.5)
        red, green, blue, _ = metal_rough.get("baseColorFactor", (1, 1, 1, 1))
        emission = strength * np.array(data.get("emissiveFactor", (0, 0, 0)), np.float64)
        factors = Material(
            base_color=(float(red), float(green), float(blue)),
            metallic=float(metal_rough.get("metallicFactor", 1)),
            roughness=float(metal_rough.get("roughnessFactor", 1)),
            # An ior of 0 is the extension's word for a reflectance of 1.
            coat_f0=min(reflectance_of_ior(ior), 0.999),
            emission=tuple(emission.tolist()),
            base_color_texture=self._texture(metal_rough.get("baseColorTexture"), SRGB),
            metallic_roughness_texture=self._texture(
                metal_rough.get("metallicRoughnessTexture"), LINEAR
            ),
            emission_texture=self._texture(data.get("emissiveTexture"), SRGB),
        )
        _check(factors)
        return factors

    def _note_left_out(self, data: dict[str, Any], extensions: dict[str, Any]) -> None:
        if "normalTexture" in data:
            self.left_out.add("normal textures")
        if data.get("alphaMode", "OPAQUE") != "OPAQUE":
            self.left_out.add("transparency (alphaMode)")
        self.left_out |= set(extensions) - READ_EXTENSIONS

    def _texture(self, info: dict[str, Any] | None, decode: np.ndarray) -> Texture | None:
        if info is None:
            return None
        texture = self._container.json["textures"][info["index"]]
        sampler = {}
        if "sampler" in texture:
            sampler = self._container.json["samplers"][texture["sampler"]]
        if sampler.get("magFilter") == NEAREST:
            self.left_out.add("textures without interpolation")
        transform = info.get("extensions", {}).get("KHR_texture_transform", {})
        if transform.get("texCoord", info.get("texCoord", 0)) != 0:
            self.left_out.add("texture coordinates other than the first")
        webp = texture.get("extensions", {}).get("EXT_texture_webp", {})
        image = webp.get("source", texture.get("source"))
        if image is None:
            raise ValueError("a texture has no image that could be read")
        if image not in self._texels:
            self._texels[image] = read_texels(*self._container.image(image))
        wrap = tuple(WRAPS[sampler.get(name, 10497)] for name in ("wrapS", "wrapT"))
        return Texture(self._texels[image], decode, wrap, _uv_transform(transform))


def _uv_transform(data: dict[str, Any]) -> np.ndarray:
    """KHR_texture_transform: translation * rotation * scale, (2, 3) float64."""
    if not data:
        return IDENTITY
    (x, y), (sx, sy) = data.get("offset", (0, 0)), data.get("scale", (1, 1))
    cosine, sine = np.cos(data.get("rotation", 0)), np.sin(data.get("rotation", 0))
    return np.array([[cosine * sx, sine * sy, x], [-sine * sx, cosine * sy, y]], np.float64)


def _check(material: Material) -> None:
    shares = np.array([*material.base_color, material.metallic, material.roughness])
    if not (np.all(shares >= 0) and np.all(shares <= 1)):
        raise ValueError("a material has a factor outside [0, 1]")
    emission = np.array(material.emission)
    if not (np.all(emission >= 0) and np.all(emission <= MAX_NUMBER)):
        raise ValueError(f"a material has an emission outside [0, {MAX_NUMBER:g}]")

"""Materials of glTF 2.0 files: section 3.9 of the specification, and some extensions.

Read: base colour, metallic, roughness, emission and normals with their textures, alphaMode, two
sets of texture coordinates; KHR_texture_transform, EXT_texture_webp; KHR_materials_clearcoat, _ior,
_emissive_strength, _specular, _transmission and _volume. Materials are shown from both sides, and
occlusion textures have no place in a path tracer; all else that changes the look is listed as left
out.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from rna_render.materials.material import Inside, Material, reflectance_of_ior
from rna_render.materials.textures import IDENTITY, LINEAR, SRGB, Texture, read_alpha, read_texels
from rna_render.materials.transmission import transmitted_by
from rna_render.scene.gltf_container import GltfContainer
from rna_render.scene.limits import MAX_NUMBER
from rna_render.scene.model_base import Vector
from rna_trace.bilinear import CLAMP, MIRROR, REPEAT

# Section 3.8.4.4, from OpenGL.
WRAPS = {10497: REPEAT, 33071: CLAMP, 33648: MIRROR}
NEAREST = 9728

READ_EXTENSIONS = {
    "KHR_materials_clearcoat",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_volume",
}

# Transmission is for smooth walls; up to this roughness a wall counts as smooth.
SMOOTH = 0.1

Json = dict[str, Any]


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
        self.left_out |= set(extensions) - READ_EXTENSIONS
        strength = extensions.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1)
        ior = extensions.get("KHR_materials_ior", {}).get("ior", 1.5)
        red, green, blue, _ = metal_rough.get("baseColorFactor", (1, 1, 1, 1))
        emission = [strength * float(factor) for factor in data.get("emissiveFactor", (0, 0, 0))]
        normals = data.get("normalTexture")
        material = Material(
            base_color=(float(red), float(green), float(blue)),
            metallic=float(metal_rough.get("metallicFactor", 1)),
            roughness=float(metal_rough.get("roughnessFactor", 1)),
            # An ior of 0 is the extension's word for a reflectance of 1.
            coat_f0=min(reflectance_of_ior(ior), 0.999),
            emission=_three(emission),
            base_color_texture=self._texture(metal_rough.get("baseColorTexture"), SRGB),
            metallic_roughness_texture=self._texture(
                metal_rough.get("metallicRoughnessTexture"), LINEAR
            ),
            emission_texture=self._texture(data.get("emissiveTexture"), SRGB),
            normal_texture=self._texture(normals, LINEAR),
            normal_scale=float((normals or {}).get("scale", 1)),
            **self._opacity(data, metal_rough),
            **self._coats(extensions),
        )
        transmission = extensions.get("KHR_materials_transmission", {})
        if transmission.get("transmissionFactor", 0) > 0:
            volume = extensions.get("KHR_materials_volume", {})
            material = self._glass(material, transmission, volume, ior)
        _check(material)
        return material

    def _opacity(self, data: Json, metal_rough: Json) -> Json:
        """Section 3.9.4: the effect of alphaMode on the base colour's alpha."""
        mode = data.get("alphaMode", "OPAQUE")
        if mode == "OPAQUE":
            return {}
        if mode not in ("MASK", "BLEND"):
            raise ValueError(f"a material has an alphaMode of {mode!r}")
        return {
            "opacity": float(metal_rough.get("baseColorFactor", (1, 1, 1, 1))[3]),
            "cutoff": float(data.get("alphaCutoff", 0.5)) if mode == "MASK" else None,
            "opacity_texture": self._alpha_texture(metal_rough.get("baseColorTexture")),
        }

    def _coats(self, extensions: Json) -> Json:
        """KHR_materials_specular and KHR_materials_clearcoat."""
        specular = extensions.get("KHR_materials_specular", {})
        clear = extensions.get("KHR_materials_clearcoat", {})
        white = np.all(np.array(specular.get("specularColorFactor", 1)) == 1)
        if not white or "specularColorTexture" in specular:
            self.left_out.add("the colour of KHR_materials_specular")
        if "clearcoatNormalTexture" in clear:
            self.left_out.add("normal textures of clear coats")
        return {
            "coat_weight": float(specular.get("specularFactor", 1)),
            "coat_weight_texture": self._alpha_texture(specular.get("specularTexture")),
            "clear_coat": float(clear.get("clearcoatFactor", 0)),
            "clear_coat_roughness": float(clear.get("clearcoatRoughnessFactor", 0)),
            "clear_coat_texture": self._texture(clear.get("clearcoatTexture"), LINEAR),
            "clear_coat_roughness_texture": self._texture(
                clear.get("clearcoatRoughnessTexture"), LINEAR
            ),
        }

    def _glass(self, material: Material, data: Json, volume: Json, ior: float) -> Material:
        """Adds KHR_materials_transmission and _volume, as far as smooth glass shows them."""
        if any(material.emission):
            self.left_out.add("transmission of emissive materials")
            return material
        texture = self._texture(data.get("transmissionTexture"), LINEAR)
        placed = [material.base_color_texture, material.metallic_roughness_texture, texture]
        if len({image.uv_set for image in placed if image is not None}) > 1:
            self.left_out.add("transmission by textures of different coordinates")
            return material
        rough = material.metallic_roughness_texture
        most = 1.0 if rough is None else rough.texels[..., 1].max() / 255
        if material.roughness * most > SMOOTH:
            self.left_out.add("roughness of transmission")
        if transmitted_by(material) is not None:
            self.left_out.add("alphaMode of transmissive materials")
        if material.clear_coat > 0:
            self.left_out.add("clear coats of transmissive materials")
        share = float(data["transmissionFactor"])
        opaque = replace(material, opacity=1.0, cutoff=None, opacity_texture=None, clear_coat=0.0)
        glass = replace(opaque, transmission=share, transmission_texture=texture)
        if not volume.get("thicknessFactor", 0) > 0:
            return glass
        if share < 1.0 or material.metallic > 0 or any(t is not None for t in placed) or ior < 1.0:
            self.left_out.add("refraction of partly transmissive materials")
            return glass
        return replace(glass, inside=Inside(float(ior), _absorption(volume)))

    def _alpha_texture(self, info: Json | None) -> Texture | None:
        """The alpha of an image, in all channels; None if it has none."""
        texture = self._texture(info, LINEAR)
        if info is None or texture is None:
            return None
        alpha = read_alpha(*self._container.image(self._image(info)))
        return None if alpha is None else replace(texture, texels=alpha)

    def _image(self, info: Json) -> int:
        texture = self._container.json["textures"][info["index"]]
        webp = texture.get("extensions", {}).get("EXT_texture_webp", {})
        image: int | None = webp.get("source", texture.get("source"))
        if image is None:
            raise ValueError("a texture has no image that could be read")
        return image

    def _texture(self, info: Json | None, decode: np.ndarray) -> Texture | None:
        if info is None:
            return None
        texture = self._container.json["textures"][info["index"]]
        sampler = {}
        if "sampler" in texture:
            sampler = self._container.json["samplers"][texture["sampler"]]
        if sampler.get("magFilter") == NEAREST:
            self.left_out.add("textures without interpolation")
        transform = info.get("extensions", {}).get("KHR_texture_transform", {})
        uv_set = transform.get("texCoord", info.get("texCoord", 0))
        if uv_set not in (0, 1):
            self.left_out.add("texture coordinates other than the first two")
            uv_set = 0
        image = self._image(info)
        if image not in self._texels:
            self._texels[image] = read_texels(*self._container.image(image))
        wrap = WRAPS[sampler.get("wrapS", 10497)], WRAPS[sampler.get("wrapT", 10497)]
        return Texture(self._texels[image], decode, wrap, _uv_transform(transform), uv_set)


def _uv_transform(data: Json) -> np.ndarray:
    """KHR_texture_transform: translation * rotation * scale, (2, 3) float64."""
    if not data:
        return IDENTITY
    (x, y), (sx, sy) = data.get("offset", (0, 0)), data.get("scale", (1, 1))
    numbers = np.array([x, y, sx, sy, data.get("rotation", 0)], np.float64)
    if not (np.abs(numbers) <= MAX_NUMBER).all():
        raise ValueError(f"a texture transform has numbers that are not at most {MAX_NUMBER:g}")
    cosine, sine = np.cos(numbers[4]), np.sin(numbers[4])
    return np.array([[cosine * sx, sine * sy, x], [-sine * sx, cosine * sy, y]], np.float64)


def _absorption(volume: Json) -> Vector:
    """KHR_materials_volume: of a medium that leaves the attenuation colour after its distance."""
    distance = float(volume.get("attenuationDistance", np.inf))
    colour = np.array(volume.get("attenuationColor", (1, 1, 1)), np.float64)
    if not (distance > 0 and np.all(colour >= 0) and np.all(colour <= 1)):
        raise ValueError("a volume has a distance that is not positive, or a colour not in [0, 1]")
    return _three((-np.log(np.maximum(colour, 1e-6)) / distance).tolist())


def _three(values: list[float]) -> Vector:
    red, green, blue = values
    return red, green, blue


def _check(material: Material) -> None:
    coats = material.coat_weight, material.clear_coat, material.clear_coat_roughness
    more = material.metallic, material.roughness, material.opacity, material.transmission
    shares = np.array([*material.base_color, *coats, *more, material.coat_f0])
    if not (np.all(shares >= 0) and np.all(shares <= 1)):
        raise ValueError("a material has a factor outside [0, 1]")
    emission = np.array(material.emission)
    if not (np.all(emission >= 0) and np.all(emission <= MAX_NUMBER)):
        raise ValueError(f"a material has an emission outside [0, {MAX_NUMBER:g}]")
    if not (abs(material.normal_scale) <= MAX_NUMBER and (material.cutoff or 0) >= 0):
        raise ValueError("a material has a normal scale that is not finite, or a cutoff below 0")

"""Transmission of materials: cut-outs, partial coverage, thin glass, as textures for rays.

Glass is KHR_materials_transmission without a volume: a smooth wall without thickness. Of what its
coat does not reflect (Schlick), a share goes straight on, tinted by the base colour. So

    L = L_rest + tau L_behind,    tau = transmission (1 - metallic) base (1 - F),

while a ray that ends at a hit brings (1 - tau) times the light of the hit: L_rest / (1 - tau).
With a volume it is solid glass: see `rna_render/paths/solid_glass.py`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rna_render.materials.material import Material
from rna_render.materials.textures import Texture
from rna_trace.bilinear import REPEAT
from rna_trace.transmittance import Transmittance, TransmittanceTexture

if TYPE_CHECKING:
    from rna_render.materials.mesh_object import MeshObject


def object_transmittance(mesh: MeshObject) -> Transmittance | None:
    """Transmittance of all triangles of an object; None if all are opaque."""
    used = [k for k in np.unique(mesh.material_numbers) if mesh.materials[k].inside is None]
    if mesh.catches_shadows or all(transmitted_by(mesh.materials[k]) is None for k in used):
        return None
    # Each corner by itself, as triangles that share it may have textures of their own.
    corners = mesh.triangles.ravel()
    uvs = np.zeros((len(corners), 2), np.float32)
    number = np.full(len(mesh.triangles), -1, np.int32)
    textures: list[TransmittanceTexture] = []
    for place in used:
        material = mesh.materials[place]
        if (texture := transmitted_by(material)) is None:
            continue
        number[mesh.material_numbers == place] = len(textures)
        textures.append(texture)
        if (image := main_texture(material)) is not None:
            row = np.flatnonzero(np.repeat(mesh.material_numbers == place, 3))
            uv = mesh.uv_set(image.uv_set)[corners[row]].astype(np.float64)
            uvs[row] = uv @ image.transform[:, :2].T + image.transform[:, 2]
    apart = np.arange(len(corners), dtype=np.uint32).reshape(-1, 3)
    return Transmittance(apart, uvs, mesh.normals[corners], number, textures)


def transmitted_by(material: Material) -> TransmittanceTexture | None:
    """Transmittance of a material over its texture coordinates; None if it is opaque."""
    if material.transmission > 0:
        return _glass(material)
    return _coverage(material)


def main_texture(material: Material) -> Texture | None:
    """The texture whose coordinates are used."""
    if material.transmission > 0:
        return next(iter(_glass_textures(material)), None)
    return material.opacity_texture


def _coverage(material: Material) -> TransmittanceTexture | None:
    texture, opacity, cutoff = material.opacity_texture, material.opacity, material.cutoff
    alpha = np.full((1, 1, 1), 255, np.uint8) if texture is None else texture.texels[..., :1]
    wrap = (REPEAT, REPEAT) if texture is None else texture.wrap
    if opacity * (alpha.min() / 255) >= (1.0 if cutoff is None else cutoff):
        return None
    if cutoff is None:
        texels = np.rint(255 - opacity * alpha.astype(np.float64)).astype(np.uint8)
        return TransmittanceTexture(texels, wrap=wrap)
    # Light passes where opacity alpha < cutoff; an opacity of 0 lets all through.
    limit = 1.0 - cutoff / opacity if opacity > 0 else -1.0
    return TransmittanceTexture(255 - alpha, limit, wrap)


def _glass_textures(material: Material) -> list[Texture]:
    of_metal = material.metallic_roughness_texture if material.metallic > 0 else None
    textures = material.base_color_texture, material.transmission_texture, of_metal
    return [texture for texture in textures if texture is not None]


def _glass(material: Material) -> TransmittanceTexture:
    textures = _glass_textures(material)
    height, width = np.max([texture.texels.shape[:2] for texture in textures] or [(1, 1)], axis=0)
    wrap = textures[0].wrap if textures else (REPEAT, REPEAT)
    t, s = ((np.arange(size) + 0.5) / size for size in (height, width))
    st = np.stack(np.meshgrid(s, t), axis=-1).reshape(-1, 2)
    transform = textures[0].transform if textures else np.eye(2, 3)
    uv = ((st - transform[:, 2]) @ np.linalg.pinv(transform[:, :2]).T).astype(np.float32)
    ones = np.ones((len(uv), 3), np.float32)
    base, share, metal = (
        ones if texture is None else texture.lookup(uv)
        for texture in (
            material.base_color_texture,
            material.transmission_texture,
            material.metallic_roughness_texture,
        )
    )
    tau = material.transmission * share[:, :1] * (1 - material.metallic * metal[:, 2:])
    tau = tau * base * np.asarray(material.base_color)
    texels = np.rint(255 * tau).astype(np.uint8).reshape(height, width, 3)
    if (texels == texels[..., :1]).all():
        texels = texels[..., :1]
    coated = material.coat_f0 > 0 and material.coat_weight > 0
    return TransmittanceTexture(texels, wrap=wrap, f0=material.coat_f0 if coated else None)

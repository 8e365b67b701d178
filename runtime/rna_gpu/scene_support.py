"""What of a scene the GPU renderer does not know: refused in one line, never left out."""

from __future__ import annotations

from dataclasses import fields

import numpy as np

from rna_gpu.errors import GpuError
from rna_render.bilinear import REPEAT
from rna_render.materials.material import Material
from rna_render.materials.textures import IDENTITY, Texture
from rna_render.scene_file import SceneFile
from rna_render.world import World

_TEXTURES = ("base_color_texture", "metallic_roughness_texture")
_WHERE = "is not supported with --device gpu; render it without"


def check_scene(scene_file: SceneFile, world: World) -> None:
    """Raises GpuError for settings and assets that the shaders do not know."""
    quality = scene_file.scene.quality
    if quality is not None and quality.seconds is not None:
        raise GpuError(f"quality.seconds {_WHERE}")
    models = scene_file.scene.assets
    for k, (model, asset) in enumerate(zip(models, world.things, strict=False)):
        where = f"assets[{k}], {model.path.name}"
        for part in asset.parts:
            if part.kind == "surface" and part.transmittance_records:
                raise GpuError(f"{where}: holes and thin glass: this {_WHERE}")


def check_material(material: Material) -> Material:
    """The material. Raises GpuError for what the shaders do not know of it."""
    for item in fields(material):
        texture = getattr(material, item.name)
        if not isinstance(texture, Texture):
            continue
        if item.name not in _TEXTURES:
            raise GpuError(f"a material with a texture ({item.name}) {_WHERE}")
        moved = texture.uv_set != 0 or not np.array_equal(texture.transform, IDENTITY)
        if moved or texture.wrap != (REPEAT, REPEAT):
            raise GpuError(f"a texture that is transformed or does not repeat {_WHERE}")
    for name in ("clear_coat", "transmission"):
        if getattr(material, name) > 0.0:
            raise GpuError(f"a material with {name} {_WHERE}")
    if material.opacity < 1.0:
        raise GpuError(f"a material with an opacity below 1 {_WHERE}")
    if any(material.emission):
        raise GpuError(f"a material that emits light {_WHERE}")
    return material

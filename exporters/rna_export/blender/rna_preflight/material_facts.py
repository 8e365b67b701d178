"""Facts about each shown material, read from its nodes: a capture's pre-flight judges them."""

from collections.abc import Iterable, Iterator
from typing import Any

import bpy
from rna_materials import emission
from rna_materials.material_uses import named, shown_materials
from rna_materials.node_sources import origin
from rna_materials.uv_render import surface_output, surface_sources
from rna_preflight.shader_values import (
    Shader,
    constant,
    is_on,
    surface_shaders,
    textures_of,
    volume_shaders,
)
from rna_preflight.smooth_glass import is_left, is_smooth_glass, refracts
from rna_preflight.texture_sizes import Extent, detail, extents

_MIRRORS = ("BSDF_GLOSSY", "BSDF_METALLIC", "BSDF_GLASS", "BSDF_REFRACTION")
_GLOSS = (
    *("Roughness", "Metallic", "Specular IOR Level", "Anisotropic", "Anisotropic Rotation"),
    *("Anisotropy", "Rotation", "Coat Weight", "Coat Roughness", "Sheen Weight", "Tangent"),
)
_COLOURS = ("Base Color", "Color", "Subsurface Radius")
_RELIEF = ("Normal", "Coat Normal")
_GLOW = ("Emission Color", "Emission Strength")


def facts() -> list[dict[str, Any]]:
    """Facts of each shown material except glass left to hosts; within `as_rendered`.

    name, fullName; kinds: what it is, of `Kind` in `preflight/material_record.py`; roughness: of
    its sharpest highlight, None where it has none or a texture gives it; details: of relief, gloss,
    colour and emission the finest texture's node, and metres from one detail to the next.
    """
    on_surfaces, on_hair = shown_materials()
    sizes = extents()
    return [
        _facts(material, sizes.get(name, Extent()), name in on_hair)
        for material in named(on_surfaces | on_hair)
        if not is_left(name := material.name_full)
    ]


def volumes_alone() -> list[str]:
    """Names of shown materials that are a volume without a surface; within `as_rendered`."""
    every = named(set().union(*shown_materials()))
    return [m.name for m in every if not surface_output(m) and volume_shaders(m)]


def _facts(material: bpy.types.Material, extent: Extent, on_hair: bool) -> dict[str, Any]:
    shaders = surface_shaders(material)
    kinds = dict.fromkeys(kind for shader in shaders for kind in _kinds(shader))
    if on_hair:
        kinds = {"hair": None, **kinds}
        if _is_varied(material):
            kinds["varied"] = None
    if volume_shaders(material):
        kinds["volume"] = None
    if not kinds:
        kinds["opaque"] = None
    rough = [value[0] for s in shaders for value in _roughnesses(s) if value is not None]
    return {
        "name": material.name,
        "fullName": material.name_full,
        "kinds": list(kinds),
        "roughness": min(rough, default=None),
        "details": [] if on_hair else list(_details(material, shaders, extent)),
    }


def _is_varied(material: bpy.types.Material) -> bool:
    """Whether a random number a strand, or what Principled Hair makes of it, shows."""
    for node, socket, inside in surface_sources(material):
        if node.type == "HAIR_INFO" and socket.name == "Random":
            return True
        if any(is_on((node, inside), name) for name in ("Random Color", "Random Roughness")):
            return True
    return False


def _kinds(shader: Shader) -> Iterator[str]:
    node = shader[0]
    if refracts(shader):
        yield "glass" if is_smooth_glass(shader) else "refracting"
    if node.type == "BSDF_TRANSPARENT" or _constant_alpha(shader) != 1.0:
        yield "see-through"
    if node.type == "BSDF_TRANSLUCENT":
        yield "thin"
    if node.type == "SUBSURFACE_SCATTERING" or is_on(shader, "Subsurface Weight"):
        yield "scattering"
    if node.type == "BSDF_METALLIC" or is_on(shader, "Metallic"):
        yield "metal"
    if node.type == "BSDF_GLOSSY":
        yield "glossy"
    if is_on(shader, "Coat Weight"):
        yield "coat"
    if node.type == "BSDF_SHEEN" or is_on(shader, "Sheen Weight"):
        yield "velvet"
    if is_on(shader, "Anisotropic") or is_on(shader, "Anisotropy"):
        yield "brushed"
    if emission.emits(node):
        yield "emissive"


def _constant_alpha(shader: Shader) -> float | None:
    """Alpha of a Principled BSDF; None if nodes give it; 1 for other shaders."""
    if shader[0].type != "BSDF_PRINCIPLED":
        return 1.0
    value = constant(shader, "Alpha")
    return None if value is None else value[0]


def _roughnesses(shader: Shader) -> Iterator[tuple[float, ...] | None]:
    """Roughness of each of a shader's highlights."""
    node = shader[0]
    shows = ("Metallic", "Specular IOR Level", "Transmission Weight")
    if node.type in _MIRRORS or (
        node.type == "BSDF_PRINCIPLED" and any(is_on(shader, name) for name in shows)
    ):
        yield constant(shader, "Roughness")
    if node.type == "BSDF_PRINCIPLED" and is_on(shader, "Coat Weight"):
        yield constant(shader, "Coat Roughness")


def _details(
    material: bpy.types.Material, shaders: list[Shader], extent: Extent
) -> Iterator[dict[str, Any]]:
    """The finest texture of each sort."""
    glowing = [shader for shader in shaders if shader[0].type == "EMISSION"]
    others = [shader for shader in shaders if shader[0].type != "EMISSION"]
    sorts = {
        "relief": [*_of_inputs(others, _RELIEF), *_of_displacement(material)],
        "gloss": [*_of_inputs(others, _GLOSS), *_of_mixes(material)],
        "colour": list(_of_inputs(others, _COLOURS)),
        "emission": [*_of_inputs(others, _GLOW), *_of_inputs(glowing, ("Color", "Strength"))],
    }
    for sort, textures in sorts.items():
        sizes = ((detail(t, extent, sort == "relief"), t) for t in textures)
        sized = [(size, t) for size, t in sizes if size is not None]
        if sized:
            size, (node, _) = min(sized, key=lambda pair: pair[0])
            yield {"of": sort, "node": _called(node), "size": size}
        elif textures:
            yield {"of": sort, "node": _called(textures[0][0]), "size": None}


def _of_displacement(material: bpy.types.Material) -> Iterator[Shader]:
    output = surface_output(material)
    if output is not None:
        yield from textures_of(output.inputs["Displacement"], ())


def _of_mixes(material: bpy.types.Material) -> Iterator[Shader]:
    """Textures that choose between shaders, except textures of holes."""
    for node, _, inside in surface_sources(material):
        if node.type == "MIX_SHADER":
            mixed = [origin(socket, inside) for socket in node.inputs[1:3]]
            if not any(s is not None and s[0].type == "BSDF_TRANSPARENT" for s in mixed):
                yield from textures_of(node.inputs[0], inside)


def _of_inputs(shaders: Iterable[Shader], names: Iterable[str]) -> Iterator[Shader]:
    for node, inside in shaders:
        for name in names:
            if name in node.inputs:
                yield from textures_of(node.inputs[name], inside)


def _called(node: bpy.types.Node) -> str:
    """The node's name in the node editor."""
    return str(node.label or node.bl_label)

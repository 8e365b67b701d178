"""Smooth refracting materials, which hosts show as ordinary meshes: no part of the asset has them.

A ray through smooth glass shows what is behind it, which no asset can know.
"""

from typing import TypedDict

import bpy
from rna_geometry import shown_objects
from rna_materials.node_sources import linked
from rna_materials.object_materials import materials_of
from rna_materials.uv_render import surface_output
from rna_preflight.shader_values import Shader, constant, surface_shaders, volume_shaders

SMOOTH = 0.05
"""Roughness up to which glass counts as smooth."""
_LEAST_WEIGHT = 0.9  # of transmission, from which the rest of a material does not count


class Glass(TypedDict):
    """A smooth refracting material, as hosts show it.

    ior: index of refraction. tint: of light that passes one interface, linear. roughness: as in
    glTF. absorption: of the inside, 1/m.
    """

    name: str
    fullName: str
    ior: float
    tint: tuple[float, ...]
    roughness: float
    absorption: tuple[float, ...]


_left: set[str] = set()  # full names of the materials that are left to hosts


def is_left(name: str | None) -> bool:
    """Whether a material, by its full name, is left to hosts."""
    return name in _left


def leave_to_hosts(how: str) -> list[Glass]:
    """Hide smooth glass from cameras; returns its materials.

    how: "keep": it refracts and shadows the light of the rest. "leave": it does nothing.
    """
    _left.clear()
    found = []
    for material in _shown():
        if (glass := glass_of(material)) is not None:
            found.append(glass)
            _left.add(material.name_full)
            _make_clear(material, to_camera_alone=how == "keep")
    return found


def _shown() -> list[bpy.types.Material]:
    """The materials that cameras see, each once."""
    shown = shown_objects.as_rendered(
        lambda: {
            material.name_full
            for instance in shown_objects.seen()
            if hasattr(instance.object.data, "materials")
            for material in materials_of(instance.object)
            if material is not None
        }
    )
    return [m for m in bpy.data.materials if m.name_full in shown]


def glass_of(material: bpy.types.Material) -> Glass | None:
    """Glass parameters of a material; None if it has other shaders as well."""
    shaders = [s for s in surface_shaders(material) if s[0].type != "BSDF_TRANSPARENT"]
    if not shaders or not all(map(is_smooth_glass, shaders)):
        return None
    first = next((s for s in shaders if s[0].type != "BSDF_GLOSSY"), shaders[0])
    node = first[0]
    name = "Base Color" if node.type == "BSDF_PRINCIPLED" else "Color"
    colour = constant(first, name) or (1.0, 1.0, 1.0)
    # Cycles' Principled BSDF takes the root at each interface, so that a wall has the colour once.
    power = 0.5 if node.type == "BSDF_PRINCIPLED" else 1.0
    tint = tuple(min(max(c, 0.0), 1.0) ** power for c in colour[:3])
    return Glass(
        name=material.name,
        fullName=material.name_full,
        ior=(constant(first, "IOR") or (1.5,))[0],
        tint=tint,
        roughness=(constant(first, "Roughness") or (0.0,))[0],
        absorption=_absorption(material),
    )


def refracts(shader: Shader) -> bool:
    """Whether a shader may let light through and bend it."""
    node = shader[0]
    if node.type == "BSDF_PRINCIPLED":
        return bool(constant(shader, "Transmission Weight") != (0.0,))
    return bool(node.type in ("BSDF_GLASS", "BSDF_REFRACTION"))


def is_smooth_glass(shader: Shader) -> bool:
    """Whether a shader refracts, as smooth glass does and nothing else."""
    roughness = constant(shader, "Roughness") if "Roughness" in shader[0].inputs else None
    if not refracts(shader) or roughness is None or roughness[0] > SMOOTH:
        return False
    if shader[0].type != "BSDF_PRINCIPLED":
        return True
    weight, metallic = (constant(shader, n) for n in ("Transmission Weight", "Metallic"))
    return metallic == (0.0,) and weight is not None and weight[0] >= _LEAST_WEIGHT


def _absorption(material: bpy.types.Material) -> tuple[float, ...]:
    """Absorption of the volume, 1/m; scattered light is counted as absorbed."""
    total = [0.0, 0.0, 0.0]
    for shader in volume_shaders(material):
        density = (constant(shader, "Density") or (0.0,))[0]
        colour = (constant(shader, "Color") or (1.0, 1.0, 1.0))[:3]
        if shader[0].type == "VOLUME_ABSORPTION":
            total = [a + density * (1.0 - c) for a, c in zip(total, colour, strict=True)]
        elif shader[0].type == "PRINCIPLED_VOLUME":
            total = [a + density for a in total]
    return tuple(total)


def _make_clear(material: bpy.types.Material, to_camera_alone: bool) -> None:
    """Let rays pass: all rays, or only camera rays."""
    tree, output = material.node_tree, surface_output(material)
    assert output is not None  # it has shaders
    clear = tree.nodes.new("ShaderNodeBsdfTransparent").outputs[0]
    for name, shown in (("Surface", clear), ("Volume", None)):
        before = linked(output.inputs[name])
        for link in list(output.inputs[name].links):
            tree.links.remove(link)
        if to_camera_alone and before is not None:
            path, mix = tree.nodes.new("ShaderNodeLightPath"), tree.nodes.new("ShaderNodeMixShader")
            tree.links.new(path.outputs["Is Camera Ray"], mix.inputs[0])
            tree.links.new(before, mix.inputs[1])
            if shown is not None:
                tree.links.new(shown, mix.inputs[2])
            shown = mix.outputs[0]
        if shown is not None:
            tree.links.new(shown, output.inputs[name])

"""Hair in Blender's scene: curves objects and the Chiang material. Needs `bpy`."""

import bpy
import numpy as np

from .axes import y_up_to_z_up
from .strands import Strands


def add_curves(strands: Strands, name: str, material: bpy.types.Material) -> bpy.types.Object:
    """A hair curves object in the scene, its +Y-up strands turned to Blender's +Z up.

    Sets the scene's curves to round, straight segments, which is what a package holds.
    """
    curves = bpy.data.hair_curves.new(name)
    curves.add_curves(strands.counts.tolist())
    curves.position_data.foreach_set("vector", y_up_to_z_up(strands.points).reshape(-1))
    radius = curves.attributes.new("radius", "FLOAT", "POINT")
    radius.data.foreach_set("value", np.ascontiguousarray(strands.radii, np.float32))
    curves.set_types(type="POLY")
    curves.materials.append(material)
    item = bpy.data.objects.new(name, curves)
    bpy.context.scene.collection.objects.link(item)
    show_strands()
    return item


def show_strands() -> None:
    """Set the scene such that strands are round, their segments straight, and light gets out."""
    bpy.context.scene.cycles_curves.shape = "THICK_LINEAR"
    cycles = bpy.context.scene.cycles
    # With the usual 12 bounces, 4 of them glossy, blonde hair loses 2% of its red.
    cycles.max_bounces = cycles.glossy_bounces = cycles.transmission_bounces = 32


def chiang_material(
    name: str = "hair",
    *,
    melanin: float | None = None,
    redness: float = 0.5,
    colour: tuple[float, float, float] | None = None,
    roughness: float = 0.25,
    radial_roughness: float = 0.3,
    coat: float = 0.0,
    ior: float = 1.55,
    offset_deg: float = 2.0,
) -> bpy.types.Material:
    """Principled Hair in the Chiang model, without randomness from strand to strand.

    Give either `melanin` (0 white, 0.2 blonde, 0.6 brown, 1 black) with its `redness`, or `colour`,
    linear RGB of thick hair. Roughnesses, `coat` and `redness` are 0 to 1.
    """
    if (melanin is None) == (colour is None):
        raise ValueError(f"found melanin {melanin} and colour {colour}, expected one of the two")
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new("ShaderNodeBsdfHairPrincipled")
    shader.model = "CHIANG"
    values = {
        "Roughness": roughness,
        "Radial Roughness": radial_roughness,
        "Coat": coat,
        "IOR": ior,
        "Offset": np.radians(offset_deg),
        "Random Roughness": 0.0,
    }
    if colour is not None:
        shader.parametrization = "COLOR"
        values["Color"] = (*colour, 1.0)
    else:
        shader.parametrization = "MELANIN"
        values |= {"Melanin": melanin, "Melanin Redness": redness, "Random Color": 0.0}
    for socket, value in values.items():
        shader.inputs[socket].default_value = value
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs["BSDF"], output.inputs["Surface"])
    return material

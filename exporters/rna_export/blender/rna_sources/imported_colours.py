"""Colours by point, face or strand of imported files, for objects without a material."""

import argparse

import bpy
from rna_sources.groom_source import hair_material

_USD = "displayColor"
_COLOURS = ("FLOAT_COLOR", "BYTE_COLOR", "FLOAT_VECTOR")  # data types of attributes


def show_on_meshes() -> None:
    """Give meshes without a material one that shows their colours."""
    made: dict[str, bpy.types.Material] = {}
    for item in bpy.data.objects:
        if item.type != "MESH" or any(item.data.materials):
            continue
        name = _colours_of(item.data)
        if name is not None:
            material = made.get(name) or made.setdefault(name, _material(name))
            item.data.materials.clear()
            item.data.materials.append(material)


def strand_material(
    item: bpy.types.Object, args: argparse.Namespace, usual: bpy.types.Material
) -> bpy.types.Material:
    """The hair that shows the colours of the strands; `usual` without any, or with --colour."""
    if args.colour or not has_colours(item):
        return usual
    made = bpy.data.materials.get("hair of its colours")
    return made or _strands_of_colours(args)


def has_colours(item: bpy.types.Object) -> bool:
    """Whether strands have colours of their own."""
    attribute = item.data.attributes.get(_USD)
    return attribute is not None and attribute.data_type in _COLOURS


def _strands_of_colours(args: argparse.Namespace) -> bpy.types.Material:
    shaded = argparse.Namespace(**{**vars(args), "colour": (1.0, 1.0, 1.0)})
    material = hair_material(shaded)
    material.name = "hair of its colours"
    tree = material.node_tree
    shader = next(node for node in tree.nodes if node.type == "BSDF_HAIR_PRINCIPLED")
    tree.links.new(_attribute(tree, _USD), shader.inputs["Color"])
    return material


def _colours_of(mesh: bpy.types.Mesh) -> str | None:
    if _USD in mesh.attributes and mesh.attributes[_USD].data_type in _COLOURS:
        return _USD
    name = mesh.attributes.default_color_name
    return name if name in mesh.attributes else next(iter(mesh.color_attributes.keys()), None)


def _material(name: str) -> bpy.types.Material:
    material = bpy.data.materials.new("colours of the file")
    material.use_nodes = True
    tree = material.node_tree
    shader = tree.nodes["Principled BSDF"]
    tree.links.new(_attribute(tree, name), shader.inputs["Base Color"])
    return material


def _attribute(tree: bpy.types.NodeTree, name: str) -> bpy.types.NodeSocket:
    node = tree.nodes.new("ShaderNodeAttribute")
    node.attribute_type, node.attribute_name = "GEOMETRY", name
    return node.outputs["Color"]

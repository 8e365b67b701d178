"""A world of radiance 1 in all directions, or in some cones."""

import bpy
from rna_materials.node_sources import combined


def new() -> bpy.types.World:
    """A world for `shine_from`."""
    world = bpy.data.worlds.new("rna white")
    world.use_nodes = True
    return world


def shine_from(world: bpy.types.World, cones: list[list[float]]) -> None:
    """Let the world shine from cones, [x, y, z, least cosine] each; from everywhere for none."""
    tree = world.node_tree
    tree.nodes.clear()
    background = tree.nodes.new("ShaderNodeBackground")
    background.inputs["Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    output = tree.nodes.new("ShaderNodeOutputWorld")
    tree.links.new(background.outputs[0], output.inputs["Surface"])
    if cones:
        tree.links.new(_is_within(tree, cones), background.inputs["Strength"])


def _is_within(tree: bpy.types.NodeTree, cones: list[list[float]]) -> bpy.types.NodeSocket:
    """1 in directions that lie in any of the cones, else 0."""
    direction = tree.nodes.new("ShaderNodeTexCoord").outputs["Generated"]
    found = None
    for *axis, cosine in cones:
        along = tree.nodes.new("ShaderNodeVectorMath")
        along.operation = "DOT_PRODUCT"
        along.inputs[1].default_value = axis
        tree.links.new(direction, along.inputs[0])
        within = combined(tree, "GREATER_THAN", along.outputs["Value"], cosine)
        found = within if found is None else combined(tree, "MAXIMUM", within, found)
    return found

"""Sets up the Lee Perry-Smith head scan (CC-BY 3.0, Infinite-Realities) as translucent skin.

    rna-capture examples/recipes/head.py --out head.rays/ -- FOLDER

FOLDER holds `head.obj`, `color.jpg` and `normal.jpg`. Runs inside Blender.
"""

import argparse
from pathlib import Path

import bpy


def image_node(tree, path, colour_space):
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = bpy.data.images.load(str(path))
    node.image.colorspace_settings.name = colour_space
    return node


def skin(folder):
    """Random-walk subsurface with skin's mean free paths under an oily coat."""
    material = bpy.data.materials.new("skin")
    material.use_nodes = True
    tree = material.node_tree
    shader = tree.nodes["Principled BSDF"]
    colour = image_node(tree, folder / "color.jpg", "sRGB")
    tree.links.new(colour.outputs["Color"], shader.inputs["Base Color"])
    bumps = tree.nodes.new("ShaderNodeNormalMap")
    bumps.inputs["Strength"].default_value = 0.6
    detail = image_node(tree, folder / "normal.jpg", "Non-Color")
    tree.links.new(detail.outputs["Color"], bumps.inputs["Color"])
    tree.links.new(bumps.outputs["Normal"], shader.inputs["Normal"])
    shader.inputs["Subsurface Weight"].default_value = 1.0
    shader.inputs["Subsurface Radius"].default_value = (1.0, 0.35, 0.2)
    shader.inputs["Subsurface Scale"].default_value = 0.006
    shader.inputs["Roughness"].default_value = 0.42
    shader.inputs["IOR"].default_value = 1.4
    return material


def build(folder):
    """The head, an object in the scene."""
    bpy.ops.wm.obj_import(filepath=str(folder / "head.obj"))
    head = bpy.context.selected_objects[0]
    head.data.shade_smooth()
    head.data.materials.clear()
    head.data.materials.append(skin(folder))
    return head


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, help="folder of head.obj and its two images")
    build(parser.parse_args().folder)

"""Builds a thing whose relief is a height over its UV map: a leaf, bark, knit or leather.

    rna-make examples/recipes/relief.py --out knit.rna --minutes 5 -- knit

The heights of leaf and knit are images, those of bark and leather procedural; bark's is
displacement as bump, the others' are Bump nodes. Runs inside Blender.
"""

import argparse
import math

import bpy
import numpy as np
import shading
import shapes

LEAF = (0.06, 0.12)  # metres: width, length
TRUNK = (0.045, 0.22)  # radius, height
CUFF = (0.04, 0.11)
STITCH = 0.0052  # width of a stitch
WALLET = (0.11, 0.024, 0.085)


def image(nodes, pixels, at):
    """The node of an image at some coordinates."""
    texture = shading.add_image(nodes.material, pixels)
    nodes.link(at, texture.inputs["Vector"])
    return texture


def grey(values):
    """An image of heights (h, w) in [0, 1]."""
    return shading.image("height", np.repeat(values[..., None], 3, axis=2), "Non-Color")


def veins(x, y):
    """Height of a leaf's veins at places across and along, (h, w) in [0, 1]."""

    def ridge(distance, width):
        return np.exp(-((distance / width) ** 2))

    middle = ridge(x, 0.0012)
    slanted = (y - 0.9 * np.abs(x)) % 0.011 - 0.0055
    side = ridge(0.75 * slanted, 0.0006)
    across = (np.abs(x) + 0.25 * y) % 0.0035 - 0.00175
    fine = np.maximum(ridge(across, 0.0003), ridge((y + 0.4 * np.abs(x)) % 0.0028 - 0.0014, 0.0003))
    blisters = (slanted / 0.0055) ** 2
    return np.clip(np.maximum.reduce([middle, 0.8 * side, 0.35 * fine]) + 0.1 * blisters, 0.0, 1.0)


def leaf():
    """A thin leaf of 12 cm; veins are ridges of its underside, grooves of its upper side."""
    size = 1024
    y, x = np.mgrid[0:size, 0:size] / size
    x, y = (x - 0.5) * LEAF[0], y * LEAF[1]
    height = veins(x, y)
    wide = 0.5 * LEAF[0] * np.sin(np.pi * np.clip(y / LEAF[1], 0.0, 1.0) ** 0.8) ** 0.8
    green = np.array([0.035, 0.12, 0.015]) + height[..., None] * np.array([0.12, 0.15, 0.05])
    colour = np.concatenate([shading.encoded(green), (np.abs(x) < wide)[..., None]], axis=2)

    nodes = shading.Nodes("leaf", Roughness=0.38)
    at = nodes.coordinates("UV")
    texture = image(nodes, shading.image("leaf", colour), at)
    nodes.link(texture.outputs["Color"], "Base Color")
    bump = nodes.bump(image(nodes, grey(height), at).outputs["Color"], Distance=0.0006)
    bump.invert = True
    thin = shading.add_shader(nodes.material, "Translucent", (0.16, 0.36, 0.03))
    body = shading.mix(nodes.material, 0.4, nodes.shader.outputs[0], thin)
    clear = shading.add_shader(nodes.material, "Transparent")
    shading.finish(
        nodes.material, shading.mix(nodes.material, texture.outputs["Alpha"], clear, body)
    )
    v, u = np.meshgrid(np.linspace(0.0, 1.0, 49), np.linspace(0.0, 1.0, 33), indexing="ij")
    bend = 0.03 * np.sin(2.2 * v) - 0.012 * np.abs(2.0 * u - 1.0) ** 1.5
    points = np.stack([LEAF[0] * (u - 0.5), -bend, LEAF[1] * v], axis=-1)
    shapes.add(shapes.grid(points), "leaf", nodes.material, smooth_deg=180.0)


def bark():
    """A piece of trunk: furrows and plates by noise and cells, as displacement as bump."""
    nodes = shading.Nodes("bark", Roughness=0.85)
    around = 2.0 * math.pi * TRUNK[0]
    at = nodes.coordinates("UV", (around, TRUNK[1], 1.0))  # metres
    stretch = nodes.add("Mapping", Scale=(1.0, 0.3, 1.0))
    nodes.link(at, stretch.inputs["Vector"])
    warp = nodes.add("TexNoise", Scale=60.0, Detail=2.0)
    nodes.link(stretch.outputs["Vector"], warp.inputs["Vector"])
    bent = nodes.add("MixRGB", Fac=0.012)
    nodes.link(stretch.outputs["Vector"], bent.inputs["Color1"])
    nodes.link(warp.outputs["Color"], bent.inputs["Color2"])
    plates = nodes.add("TexVoronoi", Scale=75.0)
    plates.feature = "DISTANCE_TO_EDGE"
    nodes.link(bent.outputs["Color"], plates.inputs["Vector"])
    furrows = nodes.ramp(plates.outputs["Distance"], (0.0, (0,) * 3), (0.3, (1,) * 3))
    rough = nodes.add("TexNoise", Scale=350.0, Detail=3.0)
    nodes.link(stretch.outputs["Vector"], rough.inputs["Vector"])
    height = nodes.add("MixRGB", Fac=0.25)
    nodes.link(furrows, height.inputs["Color1"])
    nodes.link(rough.outputs[0], height.inputs["Color2"])
    colour = nodes.ramp(
        height.outputs["Color"], (0.1, (0.025, 0.015, 0.01)), (0.9, (0.24, 0.17, 0.12))
    )
    nodes.link(colour, "Base Color")
    displacement = nodes.add("Displacement", Scale=0.003)
    nodes.link(height.outputs["Color"], displacement.inputs["Height"])
    nodes.link(displacement.outputs[0], nodes.tree.nodes["Material Output"].inputs["Displacement"])
    nodes.material.displacement_method = "BUMP"
    profile = [(TRUNK[0], TRUNK[1] * t) for t in np.linspace(0.0, 1.0, 12)]
    shapes.add(shapes.lathe(profile, 64), "trunk", nodes.material, smooth_deg=180.0)
    wood = shading.principled("wood", (0.5, 0.33, 0.18), Roughness=0.7)
    for name, z, sign in (("top", TRUNK[1], 1.0), ("bottom", 0.0, -1.0)):
        disk = [(TRUNK[0], z), (0.0, z)] if sign > 0.0 else [(0.0, z), (TRUNK[0], z)]
        shapes.add(shapes.lathe(disk, 64), name, wood)


def stitch(size=64):
    """Height of one knit stitch, a V of two legs, (h, w); repeats."""
    y, x = np.mgrid[0:size, 0:size] / size
    side = np.abs(x - 0.5)  # 0 in the middle, where the legs of a stitch meet
    along = (y - 1.1 * side) % 1.0
    across = (side - 0.25) / 0.25
    yarn = np.sqrt(np.clip(1.0 - across**2, 0.0, 1.0))
    return (
        yarn
        * (0.7 + 0.3 * np.cos(2.0 * np.pi * along))
        * (0.94 + 0.06 * np.cos(2.0 * np.pi * (5.0 * along + 2.0 * across)))
    )


def knit():
    """A cuff of wool, stitches of 5 mm, one image of a stitch repeated."""
    nodes = shading.Nodes("knit", Roughness=0.9, Sheen_Weight=0.4, Sheen_Roughness=0.5)
    around = round(2.0 * math.pi * CUFF[0] / STITCH)
    at = nodes.coordinates("UV", (around, round(CUFF[1] / STITCH), 1.0))
    height = image(nodes, grey(stitch()), at).outputs["Color"]
    colour = nodes.ramp(height, (0.0, (0.10, 0.012, 0.02)), (1.0, (0.55, 0.11, 0.10)))
    nodes.link(colour, "Base Color")
    nodes.bump(height, Distance=0.0016)
    bulge = [(CUFF[0] + 0.003 * math.sin(9.0 * t), CUFF[1] * t) for t in np.linspace(0, 1, 40)]
    item = shapes.add(shapes.lathe(bulge, 96), "cuff", nodes.material, smooth_deg=180.0)
    item.modifiers.new("thickness", "SOLIDIFY").thickness = 0.003


def leather():
    """A wallet: grain of 1.5 mm by a Voronoi texture over projected UVs."""
    bpy.ops.mesh.primitive_cube_add(size=1.0)
    item = bpy.context.object
    item.scale = WALLET
    bpy.ops.object.transform_apply(scale=True)
    edges = item.modifiers.new("edges", "BEVEL")
    edges.width, edges.segments = 0.009, 6
    bpy.ops.object.modifier_apply(modifier="edges")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.smart_project(island_margin=0.01)
    bpy.ops.object.mode_set(mode="OBJECT")
    item.data.shade_smooth()
    item.name = "wallet"
    item.location = (0.0, 0.0, 0.5 * WALLET[2])
    nodes = shading.Nodes("leather", (0.16, 0.055, 0.02), Roughness=0.42, Coat_Weight=0.15)
    cells = nodes.add("TexVoronoi", Scale=110.0, Randomness=1.0)
    cells.feature = "DISTANCE_TO_EDGE"
    nodes.placed(cells, "UV")
    height = nodes.ramp(cells.outputs["Distance"], (0.0, (0,) * 3), (0.25, (1,) * 3))
    nodes.bump(height, Distance=0.0003)
    item.data.materials.clear()
    item.data.materials.append(nodes.material)


THINGS = {"leaf": leaf, "bark": bark, "knit": knit, "leather": leather}


def main():
    parser = argparse.ArgumentParser(prog="rna-capture relief.py --")
    parser.add_argument("thing", choices=[*THINGS], help="which one")
    THINGS[parser.parse_args().thing]()


main()

"""Geometry finer than a texel, for the case `thin`: a leaf, a wire or packed strands.

    rna-capture thin.py --out leaf.rays/ -- leaf

Runs inside Blender, where `rna_hair` is at hand.
"""

import argparse

import bpy
import numpy as np

LEAF = 0.02  # metres: thickness of the leaf in its middle; at the rim it has none
WIRE, TURNS = (6e-4, 6e-3), 24  # radii that a coil's wire grows between, and its turns
STRAND, ROOTS, TIPS = 3e-4, 7e-4, 7e-3  # radius of a strand, and from one axis to the next


def checks(name, first, second, scale):
    """A checked material, so that the two sides of a leaf differ from place to place."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    tree = made.node_tree
    texture = tree.nodes.new("ShaderNodeTexChecker")
    place = tree.nodes.new("ShaderNodeTexCoord")
    texture.inputs["Scale"].default_value = scale
    texture.inputs["Color1"].default_value = (*first, 1.0)
    texture.inputs["Color2"].default_value = (*second, 1.0)
    tree.links.new(place.outputs["Object"], texture.inputs["Vector"])
    shader = tree.nodes["Principled BSDF"]
    shader.inputs["Roughness"].default_value = 0.4
    tree.links.new(texture.outputs["Color"], shader.inputs["Base Color"])
    return made


def leaf():
    """A waved disc between two checked sheets that meet at its rim."""
    rings, around = 24, 64
    r, phi = np.meshgrid(
        np.linspace(0.0, 1.0, rings + 1), 2.0 * np.pi * np.arange(around) / around, indexing="ij"
    )
    x, y = 0.5 * r * np.cos(phi), 0.5 * r * np.sin(phi)
    middle, half = 0.1 * np.sin(4.0 * x) * np.cos(3.0 * y), 0.5 * LEAF * (1.0 - r**2) ** 3
    i, j = np.meshgrid(np.arange(rings), np.arange(around), indexing="ij")
    a, b = i * around + j, i * around + (j + 1) % around
    faces = np.stack([a, a + around, b + around, b], axis=-1).reshape(-1, 4)
    colours = {
        "front": ((0.7, 0.1, 0.05), (0.8, 0.6, 0.1), 7.0),
        "back": ((0.05, 0.15, 0.6), (0.1, 0.5, 0.15), 11.0),
    }
    for side, name in ((1.0, "front"), (-1.0, "back")):
        points = np.stack([x, y, middle + side * half], axis=-1).reshape(-1, 3)
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(points.tolist(), [], faces[:, :: int(side)].tolist())
        mesh.shade_smooth()
        mesh.materials.append(checks(name, *colours[name]))
        bpy.context.scene.collection.objects.link(bpy.data.objects.new(name, mesh))


def wire():
    """Two coils, wound into one another, a red and a white one; their wires grow upwards."""
    for turn, colour in ((0.0, (0.7, 0.08, 0.05)), (np.pi, (0.8, 0.8, 0.8))):
        t = np.linspace(0.0, 1.0, 32 * TURNS + 1)
        angle = 2.0 * np.pi * TURNS * t + turn
        points = np.stack([0.3 * np.cos(angle), 0.3 * np.sin(angle), 0.7 * t], axis=1)
        curve = bpy.data.curves.new("coil", "CURVE")
        curve.dimensions, curve.bevel_depth, curve.bevel_resolution = "3D", WIRE[1], 2
        spline = curve.splines.new("POLY")
        spline.points.add(len(points) - 1)
        spline.points.foreach_set("co", np.c_[points, np.ones(len(points))].reshape(-1))
        spline.points.foreach_set("radius", np.linspace(WIRE[0] / WIRE[1], 1.0, len(points)))
        curve.materials.append(checks("coil", colour, tuple(0.3 * c for c in colour), 5.0))
        bpy.context.scene.collection.objects.link(bpy.data.objects.new("coil", curve))


def strands():
    """A brush of straight strands, packed at the roots, apart at the tips."""
    from rna_hair import of_equal_length
    from rna_hair.objects import add_curves, chiang_material

    side, points = 24, 12
    place = np.stack(np.meshgrid(*[np.arange(side) - side / 2] * 2, indexing="ij"), axis=-1)
    place = place.reshape(-1, 1, 2) + np.random.default_rng(3).uniform(-0.1, 0.1, (side**2, 1, 2))
    t = np.linspace(0.0, 1.0, points)[None, :, None]
    aside = place * (ROOTS + (TIPS - ROOTS) * t)
    path = np.concatenate([aside[..., :1], 0.15 * t + 0.0 * aside[..., :1], aside[..., 1:]], -1)
    material = chiang_material(melanin=0.2, redness=0.4)
    add_curves(of_equal_length(path, STRAND), "brush", material)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("shape", choices=("leaf", "wire", "strands"))
{"leaf": leaf, "wire": wire, "strands": strands}[parser.parse_args().shape]()

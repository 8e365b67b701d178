"""Builds a fox that sleeps curled up, carved of honey-coloured and white jade.

    rna-make examples/recipes/fox.py --out fox.rna --minutes 30

Light goes deep into the stone, comes out of its ears and fills what would be shadows. Its colours
are in the stone and have soft edges. Runs inside Blender.
"""

import argparse

import bpy
import numpy as np
import shading
import shapes

VOXEL = 0.0035
HONEY, WHITE, DARK = np.array([[0.83, 0.36, 0.075], [0.86, 0.84, 0.76], [0.20, 0.065, 0.028]])
HEAD = np.array([0.042, -0.094, 0.098])  # between the ears
LOOKS = shapes.rotation((0, 0, 1), 28.0) @ shapes.rotation((0, 1, 0), 4.0)  # from its own axes


def smoothstep(low, high, x):
    t = np.clip((x - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def ring(angles_deg, radii, heights, thick, count=40):
    """A tube that lies around the z axis; each argument is spread evenly along it."""
    at = np.linspace(0.0, 1.0, count)
    turn, radius, height, thick = (
        np.interp(at, np.linspace(0.0, 1.0, len(v)), v)
        for v in (np.radians(angles_deg), radii, heights, thick)
    )
    path = np.stack([radius * np.cos(turn), radius * np.sin(turn), height], axis=1)
    return shapes.tube(path, thick, 28)


def head():
    """The head in its own axes: it looks along -x, its ears point along +z."""
    skull = shapes.ball((0.045, 0.042, 0.036), 40)
    cheeks = shapes.ball((0.030, 0.050, 0.024), 40).placed((-0.008, 0.0, -0.012))
    snout = shapes.tube(
        np.array(
            [[-0.02, 0, -0.006], [-0.055, 0, -0.014], [-0.080, 0, -0.017], [-0.086, 0, -0.018]]
        ),
        np.array([0.028, 0.0175, 0.0105, 0.006]),
        24,
    )
    ears = []
    for side in (-1.0, 1.0):
        root, tip = np.array([[0.008, side * 0.026, 0.020], [0.018, side * 0.038, 0.070]])
        along = np.linspace(0.0, 1.0, 14)
        path = root + along[:, None] * (tip - root)
        ears.append(shapes.tube(path, 0.022 * (1.0 - 0.9 * along**1.4), 24))
    return shapes.joined([skull, cheeks, snout, *ears])


def fox():
    body = ring(
        (-58.0, -25.0, 20.0, 75.0, 125.0, 165.0, 200.0),
        (0.080, 0.068, 0.060, 0.058, 0.060, 0.064, 0.066),
        (0.050, 0.055, 0.060, 0.064, 0.066, 0.062, 0.054),
        (0.044, 0.054, 0.061, 0.064, 0.068, 0.066, 0.054),
    )
    haunch = shapes.ball((0.058, 0.046, 0.055), 40).placed((-0.068, -0.022, 0.054))
    middle = shapes.ball((0.06, 0.06, 0.05), 40).placed((0.0, 0.0, 0.05))
    tail = ring(
        (175.0, 200.0, 225.0, 250.0, 272.0, 292.0, 308.0, 318.0),
        (0.105, 0.124, 0.132, 0.134, 0.134, 0.136, 0.142, 0.147),
        (0.034, 0.035, 0.036, 0.036, 0.034, 0.028, 0.020, 0.016),
        (0.020, 0.030, 0.036, 0.038, 0.035, 0.025, 0.012, 0.004),
    )
    face = head().placed(HEAD, LOOKS)
    return shapes.joined([body, haunch, middle, tail, face])


def melted(shape, material):
    """The shape remeshed as one smooth surface with triangles of uniform size."""
    item = shapes.add(shape, "rough", material, smooth_deg=180.0)
    item.modifiers.new("skin", "REMESH").voxel_size = VOXEL
    smooth = item.modifiers.new("smooth", "SMOOTH")
    smooth.iterations = 9
    evaluated = item.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = bpy.data.meshes.new_from_object(evaluated)
    bpy.data.objects.remove(item)
    mesh.shade_smooth()
    made = bpy.data.objects.new("fox", mesh)
    bpy.context.scene.collection.objects.link(made)
    return made


def stone(points, rng):
    """Linear RGB of the stone at points (n, 3)."""
    head_points = (points - HEAD) @ LOOKS  # of the head
    turn = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360.0
    out = np.hypot(points[:, 0], points[:, 1])
    tail = smoothstep(272.0, 288.0, turn + 9.0 * np.sin(300.0 * points[:, 2]))
    tail *= smoothstep(0.096, 0.106, out) * (1.0 - smoothstep(318.0, 330.0, turn))
    near = 1.0 - smoothstep(0.088, 0.098, np.linalg.norm(head_points, axis=1))
    tail *= 1.0 - smoothstep(-0.035, -0.028, head_points[:, 2]) * near  # the chin's end is as clear
    muzzle = near * (1.0 - smoothstep(-0.022, -0.010, head_points[:, 2] + 0.08 * head_points[:, 0]))
    white = np.maximum(tail, muzzle)[:, None]
    ear = smoothstep(0.046, 0.068, head_points[:, 2]) * near
    nose = 1.0 - smoothstep(0.006, 0.010, np.linalg.norm(head_points - [-0.090, 0, -0.015], axis=1))
    dark = np.maximum(ear, nose)[:, None]
    clouds = np.zeros(len(points))
    for k in range(4):
        wave = rng.normal(size=3) * 22.0 * 1.6**k
        clouds += np.sin(points @ wave + 6.0 * rng.random() + 1.5 * clouds) / 1.5**k
    colour = HONEY * (1.0 + 0.10 * clouds[:, None]) + (WHITE - HONEY) * white
    return np.clip(colour + (DARK - colour) * dark, 0.0, 1.0)


def add_closed_eyes(material):
    for side in (-1.0, 1.0):
        s = np.linspace(-1.0, 1.0, 14)
        path = np.stack(
            [-0.029 + 0.012 * s, side * (0.0315 + 0.008 * s), 0.008 - 0.006 * (1 - s**2)], axis=1
        )
        path = HEAD + path @ LOOKS.T
        shapes.add(shapes.tube(path, 0.0016 * np.sqrt(1.02 - s**2), 10), "eye", material)


def build(depth):
    radius = tuple(depth * np.array([0.030, 0.018, 0.009]))
    jade = shading.principled(
        "jade",
        Roughness=0.3,
        IOR=1.5,
        Subsurface_Weight=1.0,
        Subsurface_Radius=radius,
        Subsurface_Scale=1.0,
    )
    nodes = jade.node_tree.nodes
    colour = nodes.new("ShaderNodeVertexColor")
    colour.layer_name = "stone"
    jade.node_tree.links.new(colour.outputs["Color"], nodes["Principled BSDF"].inputs["Base Color"])
    made = melted(fox(), jade)
    points = np.empty((len(made.data.vertices), 3), np.float32)
    made.data.vertices.foreach_get("co", points.reshape(-1))
    layer = made.data.color_attributes.new("stone", "FLOAT_COLOR", "POINT")
    result = np.ones((len(points), 4), np.float32)
    result[:, :3] = stone(points, np.random.default_rng(3))
    layer.data.foreach_set("color", result.reshape(-1))
    eyes = shading.principled("eyes", (0.09, 0.03, 0.015), Roughness=0.4)
    add_closed_eyes(eyes)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--depth", type=float, default=1.0, help="scale factor of the mean free path")
build(parser.parse_args().depth)

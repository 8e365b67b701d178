"""A figure of translucent plastic whose one arm turns about its shoulder, for `posed`.

    rna-capture posed.py --out posed.rays/ --parts objects -- --angle 30

The arm is red and hangs close to the white body. Runs inside Blender.
"""

import argparse
import math

import bpy
from mathutils import Matrix, Vector

SHOULDER = Vector((0.15, 0.0, 0.42))  # in cases/posed.py, too, +Y up

# middle and half of the width, depth and height of ellipsoids
BODY = [
    ((0.0, 0.0, 0.28), (0.125, 0.09, 0.2)),
    ((0.0, 0.0, 0.57), (0.085, 0.08, 0.095)),
    ((0.0, 0.0, 0.08), (0.15, 0.13, 0.08)),
]
ARM = [((0.165, 0.0, 0.3), (0.036, 0.036, 0.145)), ((0.17, 0.0, 0.15), (0.046, 0.04, 0.05))]


def plastic(name, colour):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    inputs = made.node_tree.nodes["Principled BSDF"].inputs
    inputs["Base Color"].default_value = (*colour, 1.0)
    inputs["Roughness"].default_value = 0.35
    inputs["Subsurface Weight"].default_value = 1.0
    inputs["Subsurface Radius"].default_value = (1.0, 0.7, 0.5)
    inputs["Subsurface Scale"].default_value = 0.02
    return made


def figure(name, ellipsoids, material):
    """One object of several closed surfaces."""
    bpy.ops.object.select_all(action="DESELECT")
    made = []
    for place, radii in ellipsoids:
        bpy.ops.mesh.primitive_uv_sphere_add(segments=40, ring_count=24, location=place)
        bpy.context.object.scale = radii
        made.append(bpy.context.object)
    for item in made:
        item.select_set(True)
    bpy.context.view_layer.objects.active = made[0]
    bpy.ops.object.transform_apply(location=True, scale=True)
    bpy.ops.object.join()
    item = bpy.context.object
    item.name = name
    item.data.shade_smooth()
    item.data.materials.append(material)
    return item


def build(angle_deg):
    figure("body", BODY, plastic("white", (0.85, 0.85, 0.82)))
    arm = figure("arm", ARM, plastic("red", (0.75, 0.08, 0.05)))
    turn = Matrix.Rotation(-math.radians(angle_deg), 4, "Y")  # outwards and up
    arm.matrix_world = Matrix.Translation(SHOULDER) @ turn @ Matrix.Translation(-SHOULDER)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--angle", type=float, default=0.0, help="of the arm from rest, degrees")
build(parser.parse_args().angle)

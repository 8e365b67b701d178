"""A translucent slab that stands and bends, for `motion`.

    rna-capture slab.py --out slab.rays/

Frame 1 is the rest pose. In frame f the slab is bent by f - 1 degrees from end to end, evenly.
Two colours in bands. Runs inside Blender.
"""

import math

import bpy
import numpy as np

LAST = 121  # frame
SIZE = (0.20, 0.03, 0.40)  # metres
EDGE = 0.008  # metres: radius of its edges
COLOURS = np.array([[0.80, 0.76, 0.64], [0.16, 0.55, 0.34]])


def wax():
    made = bpy.data.materials.new("wax")
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Roughness"].default_value = 0.35
    shader.inputs["Subsurface Weight"].default_value = 1.0
    shader.inputs["Subsurface Radius"].default_value = (1.0, 0.8, 0.5)
    shader.inputs["Subsurface Scale"].default_value = 0.02
    colour = made.node_tree.nodes.new("ShaderNodeVertexColor")
    colour.layer_name = "bands"
    made.node_tree.links.new(colour.outputs["Color"], shader.inputs["Base Color"])
    return made


def slab(material):
    bpy.ops.mesh.primitive_cube_add(size=1.0)
    rough = bpy.context.object
    rough.scale = SIZE
    bpy.ops.object.transform_apply(scale=True)
    edges = rough.modifiers.new("edges", "BEVEL")
    edges.width, edges.segments = EDGE, 4
    rough.modifiers.new("fine", "REMESH").voxel_size = 0.004
    rough.modifiers.new("smooth", "SMOOTH").iterations = 6
    evaluated = rough.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = bpy.data.meshes.new_from_object(evaluated)
    bpy.data.objects.remove(rough)
    mesh.shade_smooth()
    mesh.materials.clear()
    mesh.materials.append(material)
    made = bpy.data.objects.new("slab", mesh)
    bpy.context.scene.collection.objects.link(made)
    return made


def paint(mesh):
    """Bands with soft borders, tilted."""
    points = np.empty((len(mesh.vertices), 3), np.float32)
    mesh.vertices.foreach_get("co", points.reshape(-1))
    wave = np.sin((points[:, 2] + 0.4 * points[:, 0]) * 2.0 * math.pi / 0.13)
    share = np.clip(0.5 + 2.0 * wave, 0.0, 1.0)[:, None]
    found = np.ones((len(points), 4), np.float32)
    found[:, :3] = COLOURS[0] + share * (COLOURS[1] - COLOURS[0])
    layer = mesh.color_attributes.new("bands", "FLOAT_COLOR", "POINT")
    layer.data.foreach_set("color", found.reshape(-1))


def move(item):
    bend = item.modifiers.new("bend", "SIMPLE_DEFORM")
    bend.deform_method, bend.deform_axis = "BEND", "X"
    for frame in range(1, LAST + 1):
        bend.angle = math.radians(frame - 1)
        bend.keyframe_insert("angle", frame=frame)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, LAST
    scene.frame_set(1)


made = slab(wax())
paint(made.data)
move(made)

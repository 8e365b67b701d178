"""A flag of thin cloth, for `motion`: flat at rest, in waves later.

    rna-capture flag.py --out flag.rays/

Frame 1 is the rest pose. In frame f its steepest places have turned by f - 1 degrees. Rows keep
their length, as threads do; across them the cloth is sheared. Runs inside Blender.
"""

import math

import bpy
import numpy as np

LAST = 121  # frame
SIZE = (0.42, 0.28)  # metres
CELLS = (168, 112)
WAVES = 1.75  # along it
KEYS = 10  # degrees between shape keys: what lies between them is interpolated


def shape(angle_deg):
    """Points (r, c, 3) of the flag; its left edge stays."""
    u, v = (np.linspace(0.0, 1.0, n + 1) for n in CELLS)
    along, up = np.meshgrid(u, v)
    grown = 1.0 - (1.0 - np.minimum(along / 0.45, 1.0)) ** 2  # none at the pole
    turn = math.radians(angle_deg) * grown * np.cos(2.0 * math.pi * (WAVES * along + 0.35 * up))
    step = SIZE[0] / CELLS[0]
    middle = 0.5 * (turn[:, 1:] + turn[:, :-1])
    x, y = (np.cumsum(step * f(middle), axis=1) for f in (np.cos, np.sin))
    x, y = (np.pad(a, ((0, 0), (1, 0))) for a in (x, y))
    return np.stack([x - 0.5 * SIZE[0], -y, (up - 0.5) * SIZE[1]], axis=2)


def cloth(colour, name):
    """Diffuse, and as much light goes through it."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    tree = made.node_tree
    tree.nodes.clear()
    through = tree.nodes.new("ShaderNodeBsdfTranslucent")
    front = tree.nodes.new("ShaderNodeBsdfDiffuse")
    both = tree.nodes.new("ShaderNodeMixShader")
    both.inputs[0].default_value = 0.35
    for node in (through, front):
        node.inputs["Color"].default_value = (*colour, 1.0)
    tree.links.new(front.outputs[0], both.inputs[1])
    tree.links.new(through.outputs[0], both.inputs[2])
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(both.outputs[0], output.inputs["Surface"])
    return made


def flag():
    rows, columns = CELLS[1] + 1, CELLS[0] + 1
    number = np.arange(rows * columns).reshape(rows, columns)
    corners = number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]
    faces = np.stack([c.reshape(-1) for c in corners], axis=1)
    mesh = bpy.data.meshes.new("flag")
    mesh.from_pydata(shape(0.0).reshape(-1, 3).tolist(), [], faces.tolist())
    mesh.materials.append(cloth((0.70, 0.08, 0.06), "red"))
    mesh.materials.append(cloth((0.80, 0.76, 0.66), "white"))
    stripe = (np.arange(CELLS[1]) // 16 % 2).repeat(CELLS[0])
    mesh.polygons.foreach_set("material_index", stripe.astype(np.int32))
    mesh.shade_smooth()
    item = bpy.data.objects.new("flag", mesh)
    bpy.context.scene.collection.objects.link(item)
    return item


def move(item):
    """Shape keys, one after the other."""
    for angle in range(0, LAST, KEYS):
        key = item.shape_key_add(name=f"{angle} degrees", from_mix=False)
        key.data.foreach_set("co", shape(float(angle)).astype(np.float32).reshape(-1))
    keys = item.data.shape_keys
    keys.use_relative = False
    blocks = keys.key_blocks
    for frame in range(1, LAST + 1):
        share = (frame - 1) / (LAST - 1)
        keys.eval_time = blocks[0].frame + share * (blocks[-1].frame - blocks[0].frame)
        keys.keyframe_insert("eval_time", frame=frame)
    for block in blocks:
        block.interpolation = "KEY_LINEAR"
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, LAST
    scene.frame_set(1)


move(flag())

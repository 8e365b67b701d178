"""A figure of translucent plastic with a skeleton, for `motion`: a joint a limb turns.

    rna-capture figure.py --out figure.rays/

Frame 1 is the rest pose. In frame f a shoulder, an elbow, a knee and the neck have turned by f - 1
degrees. One skin, whose weights go over from bone to bone at the joints. Runs inside Blender.
"""

import math

import bpy
import numpy as np

LAST = 91  # frame
VOXEL = 0.007
SOFT = 0.012  # metres: how far from a joint weights go over

# Parent, (x, z) of head and tail, radii there, and the axis about which it turns.
BONES = {
    "body": (None, (0.0, 0.20), (0.0, 0.44), (0.080, 0.085), None),
    "neck": ("body", (0.0, 0.50), (0.0, 0.64), (0.036, 0.080), (0, -1, 0)),
    "upper arm.L": ("body", (0.10, 0.46), (0.22, 0.36), (0.038, 0.034), None),
    "forearm.L": ("upper arm.L", (0.22, 0.36), (0.33, 0.26), (0.034, 0.030), (-1, 0, 0)),
    "upper arm.R": ("body", (-0.10, 0.46), (-0.22, 0.36), (0.038, 0.034), (0, 1, 0)),
    "forearm.R": ("upper arm.R", (-0.22, 0.36), (-0.33, 0.26), (0.034, 0.030), None),
    "thigh.L": ("body", (0.060, 0.18), (0.085, -0.03), (0.052, 0.042), None),
    "shin.L": ("thigh.L", (0.085, -0.03), (0.10, -0.25), (0.042, 0.036), (1, 0, 0)),
    "thigh.R": ("body", (-0.060, 0.18), (-0.085, -0.03), (0.052, 0.042), None),
    "shin.R": ("thigh.R", (-0.085, -0.03), (-0.10, -0.25), (0.042, 0.036), None),
}


def at(place):
    """(3,) of (x, z)."""
    return np.array([place[0], 0.0, place[1]])


def skin(material):
    """One closed surface around all bones, melted together."""
    for _, head, tail, radii, _ in BONES.values():
        for t in np.linspace(0.0, 1.0, 10):
            place, radius = at(head) + t * (at(tail) - at(head)), np.interp(t, (0, 1), radii)
            bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=3, radius=radius, location=place)
    for item in bpy.context.scene.objects:
        item.select_set(True)
    bpy.ops.object.join()
    rough = bpy.context.object
    rough.modifiers.new("melted", "REMESH").voxel_size = VOXEL
    rough.modifiers.new("smooth", "SMOOTH").iterations = 8
    evaluated = rough.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = bpy.data.meshes.new_from_object(evaluated)
    mesh.transform(rough.matrix_world)
    bpy.data.objects.remove(rough)
    mesh.shade_smooth()
    mesh.materials.clear()
    mesh.materials.append(material)
    made = bpy.data.objects.new("figure", mesh)
    bpy.context.scene.collection.objects.link(made)
    return made


def skeleton():
    data = bpy.data.armatures.new("skeleton")
    rig = bpy.data.objects.new("skeleton", data)
    bpy.context.scene.collection.objects.link(rig)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode="EDIT")
    for name, (parent, head, tail, _, _) in BONES.items():
        bone = data.edit_bones.new(name)
        bone.head, bone.tail = at(head), at(tail)
        bone.parent = data.edit_bones[parent] if parent else None
    bpy.ops.object.mode_set(mode="OBJECT")
    return rig


def bind(item, rig):
    """Weights by the distance to each bone's surface."""
    points = np.empty((len(item.data.vertices), 3), np.float32)
    item.data.vertices.foreach_get("co", points.reshape(-1))
    away = []
    for _, head, tail, radii, _ in BONES.values():
        along = at(tail) - at(head)
        t = np.clip((points - at(head)) @ along / (along @ along), 0.0, 1.0)
        distance = np.linalg.norm(points - at(head) - t[:, None] * along, axis=1)
        away.append(distance - np.interp(t, (0, 1), radii))
    nearest = np.min(away, axis=0)
    weights = np.exp(-(np.stack(away) - nearest) / SOFT)
    weights = np.where(weights < 0.02, 0.0, weights)
    weights /= weights.sum(axis=0)
    for name, row in zip(BONES, weights, strict=True):
        group = item.vertex_groups.new(name=name)
        for k in np.flatnonzero(row).tolist():
            group.add([k], float(row[k]), "REPLACE")
    item.parent = rig
    item.modifiers.new("skin", "ARMATURE").object = rig


def turn(rig, name, axis, angle_deg, frame):
    """Key a bone that has turned about an axis of the figure."""
    bone = rig.pose.bones[name]
    own = np.array(rig.data.bones[name].matrix_local.to_3x3()).T @ axis
    bone.rotation_mode = "AXIS_ANGLE"
    bone.rotation_axis_angle = math.radians(angle_deg), *own
    bone.keyframe_insert("rotation_axis_angle", frame=frame)


def move(rig):
    """A degree a frame."""
    for frame in range(1, LAST + 1):
        for name, (*_, axis) in BONES.items():
            if axis is not None:
                turn(rig, name, axis, frame - 1, frame)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, LAST
    scene.frame_set(1)


def plastic():
    made = bpy.data.materials.new("plastic")
    made.use_nodes = True
    inputs = made.node_tree.nodes["Principled BSDF"].inputs
    inputs["Base Color"].default_value = (0.8, 0.52, 0.38, 1.0)
    inputs["Roughness"].default_value = 0.35
    inputs["Subsurface Weight"].default_value = 1.0
    inputs["Subsurface Radius"].default_value = (1.0, 0.45, 0.25)
    inputs["Subsurface Scale"].default_value = 0.03
    return made


bpy.ops.object.select_all(action="DESELECT")
figure, bones = skin(plastic()), skeleton()
bind(figure, bones)
move(bones)

"""Builds a lamb of soft plastic with wool, that walks.

    rna-make examples/recipes/lamb.py --out lamb.rna --minutes 40
    rna-motion examples/recipes/lamb.py lamb.rna --out lamb.rnam

It stands in frame 0, as it is captured; frames 1 to 24 are a walk on the spot, in a loop. A
skeleton moves one skin and what grows on it. Runs inside Blender, where `rna_hair` is at hand.
"""

import argparse
import math

import bpy
import numpy as np
import rna_hair
import shading
import shapes
from mathutils import Matrix
from rna_hair.objects import add_curves, chiang_material

FRAMES = 24
VOXEL = 0.0042
SOFT = 0.010  # metres: how far from a joint weights go over
BODY, BODY_RADII = np.array([0.0, 0.012, 0.142]), np.array([0.056, 0.086, 0.054])
HEAD, HEAD_RADII = np.array([0.0, -0.112, 0.205]), np.array([0.033, 0.040, 0.034])
RADIUS, POINTS = 0.0006, 9  # of a strand
STANCE, STRIDE, LIFT = 0.6, 0.036, 0.010  # of a step: the share on the ground; metres

# Bones: parent, head, tail, and the radii of the skin there.
BONES = {
    "body": (None, (0.0, 0.075, 0.142), (0.0, -0.055, 0.142), (0.048, 0.048)),
    "head": ("body", (0.0, -0.065, 0.172), (0.0, -0.112, 0.205), (0.026, 0.034)),
    "tail": ("body", (0.0, 0.092, 0.152), (0.0, 0.118, 0.138), (0.010, 0.011)),
}
HIP, KNEE, FOOT = 0.118, 0.062, 0.010  # heights
LEGS = {  # x, y, and the phase of its step
    "fore.L": (0.026, -0.046, 0.0),
    "fore.R": (-0.026, -0.046, 0.5),
    "hind.L": (0.028, 0.062, 0.25),
    "hind.R": (-0.028, 0.062, 0.75),
}
for leg, (x, y, _) in LEGS.items():
    BONES[f"thigh {leg}"] = ("body", (x, y, HIP), (x, y, KNEE), (0.018, 0.012))
    BONES[f"shin {leg}"] = (f"thigh {leg}", (x, y, KNEE), (x, y, FOOT), (0.012, 0.011))


def on_head(*offset):
    """A place by its offset from the head's middle."""
    return HEAD + np.array(offset)


def plastic(name, colour, roughness=0.4):
    return shading.principled(
        name,
        colour,
        Roughness=roughness,
        Subsurface_Weight=1.0,
        Subsurface_Radius=(1.0, 0.5, 0.35),
        Subsurface_Scale=0.008,
    )


def skin():
    """One smooth surface: body, head with ears and muzzle, legs, tail."""
    balls = [shapes.ball(BODY_RADII, 40).placed(BODY), shapes.ball(HEAD_RADII, 36).placed(HEAD)]
    balls.append(shapes.ball((0.022, 0.026, 0.019), 32).placed(on_head(0.0, -0.034, -0.012)))
    for side in (-1.0, 1.0):
        turn = shapes.rotation((0, 1, 0), side * 22.0)
        ear = shapes.ball((0.026, 0.007, 0.012), 28)
        balls.append(ear.placed(on_head(side * 0.046, 0.006, 0.004), turn))
    tubes = []
    for name, (_, head, tail, radii) in BONES.items():
        if name != "body":
            path = np.linspace(head, tail, 10)
            tubes.append(shapes.tube(path, np.linspace(*radii, 10), 20))
            balls += [
                shapes.ball((r, r, r), 20).placed(place)
                for place, r in zip((head, tail), radii, strict=True)
            ]
    item = shapes.add(shapes.joined([*balls, *tubes]), "rough", plastic("skin", (0.72, 0.48, 0.38)))
    item.modifiers.new("melted", "REMESH").voxel_size = VOXEL
    item.modifiers.new("smooth", "SMOOTH").iterations = 7
    evaluated = item.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = bpy.data.meshes.new_from_object(evaluated)
    bpy.data.objects.remove(item)
    mesh.shade_smooth()
    made = bpy.data.objects.new("lamb", mesh)
    bpy.context.scene.collection.objects.link(made)
    return made


def skeleton():
    data = bpy.data.armatures.new("skeleton")
    rig = bpy.data.objects.new("skeleton", data)
    bpy.context.scene.collection.objects.link(rig)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode="EDIT")
    for name, (parent, head, tail, _) in BONES.items():
        bone = data.edit_bones.new(name)
        bone.head, bone.tail = head, tail
        bone.parent = data.edit_bones[parent] if parent else None
    bpy.ops.object.mode_set(mode="OBJECT")
    return rig


def bind(item, rig):
    """Weights of the skin by the distance to each bone's surface."""
    points = np.empty((len(item.data.vertices), 3), np.float32)
    item.data.vertices.foreach_get("co", points.reshape(-1))
    away = []
    for _, head, tail, radii in BONES.values():
        along = np.subtract(tail, head)
        t = np.clip((points - head) @ along / (along @ along), 0.0, 1.0)
        distance = np.linalg.norm(points - head - t[:, None] * along, axis=1)
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


def hang(item, rig, bone):
    """Let an object go where a bone goes."""
    item.parent, item.parent_type, item.parent_bone = rig, "BONE", bone
    bpy.context.view_layer.update()
    item.matrix_world = Matrix()


def wool(rng, centre, radii, count, length, keep):
    """Curly guides (s, POINTS, 3), Blender's axes, on an ellipsoid: `keep` of `count` places."""
    k = np.arange(count)
    up, around = 1.0 - (2.0 * k + 1.0) / count, math.pi * (3.0 - math.sqrt(5.0)) * k
    flat = np.sqrt(1.0 - up**2)
    unit = np.stack([flat * np.cos(around), flat * np.sin(around), up], axis=1)
    unit = unit[keep(unit)]
    out = unit / radii
    out /= np.linalg.norm(out, axis=1, keepdims=True)
    side = np.cross(out, rng.normal(size=out.shape))
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    other = np.cross(out, side)
    t = np.linspace(0.0, 1.0, POINTS)[:, None, None]
    turn = 2.0 * math.pi * (1.1 * t + rng.random((1, len(out), 1)))
    curl = 0.0045 * t * (np.cos(turn) * side + np.sin(turn) * other)
    grown = centre + 0.97 * radii * unit + length * t * out + curl
    return np.moveaxis(grown + [0.0, 0.0, -0.25 * length] * t**2, 0, 1)


def fur(name, guides, strands, seed):
    roots = guides[..., [0, 2, 1]] * [1.0, 1.0, -1.0]  # +Y up, as rna_hair has it
    grown = rna_hair.interpolate(
        rna_hair.of_equal_length(roots, RADIUS),
        strands,
        points=POINTS,
        seed=seed,
        clump=0.45,
        noise=0.05,
        shorten=0.2,
    )
    grown = rna_hair.taper(grown, RADIUS, tip=0.4, start=0.6)
    hair = chiang_material(name, melanin=0.03, redness=0.4, roughness=0.4, radial_roughness=0.6)
    return add_curves(grown, name, hair)


def add_eyes_and_hooves(rig):
    black = shading.principled("eyes", (0.012, 0.01, 0.01), Roughness=0.08)
    for side in (-1.0, 1.0):
        eye = shapes.ball((0.0062, 0.0062, 0.0075), 24)
        placed = eye.placed(on_head(side * 0.0245, -0.026, 0.008))
        hang(shapes.add(placed, "eye", black), rig, "head")
    nose = shapes.ball((0.0085, 0.005, 0.0055), 24).placed(on_head(0.0, -0.059, -0.009))
    hang(shapes.add(nose, "nose", shading.principled("nose", (0.10, 0.035, 0.03))), rig, "head")
    horn = shading.principled("horn", (0.05, 0.035, 0.03))
    for leg, (x, y, _) in LEGS.items():
        hoof = shapes.ball((0.0130, 0.0145, 0.0115), 28).placed((x, y - 0.002, FOOT + 0.001))
        hang(shapes.add(hoof, "hoof", horn), rig, f"shin {leg}")


def foot_path(step):
    """How far a foot is behind its place and above the ground, by the part of its step."""
    if step < STANCE:
        return STRIDE * (step / STANCE - 0.5), 0.0
    swing = (step - STANCE) / (1.0 - STANCE)
    return 0.5 * STRIDE * math.cos(math.pi * swing), LIFT * math.sin(math.pi * swing)


def bent_leg(hip, foot, side):
    """Turns of thigh and shin about +x, radians, that bring a foot (y, z) to its place."""
    thigh, shin = HIP - KNEE, KNEE - FOOT
    y, z = np.subtract(foot, hip)
    reach = min(math.hypot(y, z), 0.9999 * (thigh + shin))
    knee = math.acos((thigh**2 + shin**2 - reach**2) / (2.0 * thigh * shin))
    ahead = math.acos((thigh**2 + reach**2 - shin**2) / (2.0 * thigh * reach))
    return math.atan2(y, -z) - side * ahead, side * (math.pi - knee)


def pose(rig, frame):
    """Key all bones: at rest in frame 0, then a walk."""
    walked, amount = (frame - 1) / FRAMES, float(frame > 0)
    turn = 4.0 * math.pi * walked
    pitch, rise = math.radians(0.6) * math.sin(turn), 0.0015 * math.cos(turn) - 0.0045
    bend = {
        "body": (pitch, (0.0, 0.0, rise)),
        "head": (math.radians(4.0) * math.sin(turn - 0.8), None),
        "tail": (math.radians(14.0) * math.sin(turn), None),
    }
    pivot = np.array(BONES["body"][1][1:])
    for leg, (_, y, phase) in LEGS.items():
        y_hip, z_hip = np.subtract((y, HIP), pivot)
        hip = np.add(pivot, (y_hip - pitch * z_hip, z_hip + pitch * y_hip + rise))
        back, up = foot_path((walked + phase) % 1.0)
        side = 1.0 if y < 0 else -1.0  # forelegs bend back, hind legs forward
        thigh, shin = bent_leg(hip, (y + back, FOOT + up), side)
        bend |= {f"thigh {leg}": (thigh - pitch, None), f"shin {leg}": (shin, None)}
    for name, (angle, shift) in bend.items():
        bone = rig.pose.bones[name]
        rest = rig.data.bones[name].matrix_local.to_3x3().transposed()
        axis = rest @ Matrix.Identity(3).col[0]  # of the bone, towards +x
        bone.rotation_mode = "AXIS_ANGLE"
        bone.rotation_axis_angle = amount * angle, *axis
        bone.keyframe_insert("rotation_axis_angle", frame=frame)
        if shift is not None:
            bone.location = amount * (rest @ Matrix.Translation(shift).to_translation())
            bone.keyframe_insert("location", frame=frame)


def grow(rig, strands):
    """Wool of the body, a cap on the head, breeches around the thighs."""
    rng = np.random.default_rng(9)
    back = wool(rng, BODY, BODY_RADII, 1400, 0.024, lambda u: u[:, 2] > -0.75)
    hang(fur("wool", back, strands * 6 // 8, 1), rig, "body")
    cap = wool(rng, HEAD, HEAD_RADII, 700, 0.014, lambda u: (u[:, 2] > 0.5) & (u[:, 1] > -0.5))
    hang(fur("cap", cap, strands // 8, 2), rig, "head")
    for seed, (leg, (x, y, _)) in enumerate(LEGS.items(), 3):
        middle, radii = np.array([x, y, HIP - 0.014]), np.array([0.018, 0.019, 0.034])
        breeches = wool(rng, middle, radii, 110, 0.015, lambda u: u[:, 2] < 0.9)
        hang(fur(f"breeches {leg}", breeches, strands // 32, seed), rig, f"thigh {leg}")


def build(strands):
    rig, lamb = skeleton(), skin()
    bind(lamb, rig)
    add_eyes_and_hooves(rig)
    grow(rig, strands)
    for frame in range(FRAMES + 1):
        pose(rig, frame)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, FRAMES
    scene.frame_set(0)


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--strands", type=int, default=12000)
build(parser.parse_args().strands)

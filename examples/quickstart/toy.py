"""Builds the quickstart asset in Blender: a toy truck of translucent plastic bricks.

    rna-capture examples/quickstart/toy.py --out toy.rays/

The script runs inside Blender (`import bpy`); whatever stands in the scene at its end is captured.
"""

import math

import bpy

PITCH = 0.08  # metres from stud to stud, ten times a real brick's
PLATE = 0.032  # height of a plate; a brick is three plates
GAP = 0.0008  # between bricks, so that no two surfaces coincide
STUD_RADIUS, STUD_HEIGHT = 0.0245, 0.017
BEVEL = 0.0035

COLOURS = {
    "red": (0.70, 0.035, 0.025),
    "yellow": (0.85, 0.50, 0.03),
    "blue": (0.03, 0.16, 0.65),
    "green": (0.06, 0.45, 0.09),
    "white": (0.82, 0.80, 0.74),
    "ice": (0.45, 0.70, 0.80),
    "grey": (0.10, 0.10, 0.11),
}

# colour, first stud (x, y), first plate z, size in studs (x, y), height in plates
BRICKS = [
    ("grey", (0, 0), 3, (10, 4), 1),
    ("red", (0, 0), 4, (2, 4), 3),
    ("red", (2, 0), 4, (2, 2), 3),
    ("red", (2, 2), 4, (2, 2), 3),
    ("white", (0, 0), 7, (1, 4), 1),
    ("ice", (1, 0), 7, (1, 4), 4),
    ("red", (2, 0), 7, (2, 1), 4),
    ("red", (2, 3), 7, (2, 1), 4),
    ("red", (3, 1), 7, (1, 2), 4),
    ("red", (1, 0), 11, (3, 4), 1),
    ("blue", (2, 1), 12, (1, 2), 1),
    ("yellow", (4, 0), 4, (6, 1), 3),
    ("yellow", (4, 3), 4, (6, 1), 3),
    ("yellow", (9, 1), 4, (1, 2), 3),
    ("yellow", (4, 1), 4, (1, 2), 5),
    ("green", (5, 1), 4, (2, 2), 3),
    ("blue", (7, 1), 4, (2, 2), 3),
    ("white", (6, 1), 7, (2, 2), 3),
    ("red", (8, 2), 7, (1, 1), 3),
    ("green", (6, 2), 10, (2, 1), 1),
    ("yellow", (7, 1), 10, (1, 1), 3),
]

WHEELS = [(1.5, -0.32), (1.5, 4.32), (7.5, -0.32), (7.5, 4.32)]  # stud units
WHEEL_RADIUS, WHEEL_WIDTH = 0.115, 0.075


def plastic(name, colour):
    """Translucent coloured plastic: random-walk subsurface under a glossy dielectric."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Roughness"].default_value = 0.28
    shader.inputs["IOR"].default_value = 1.5
    shader.inputs["Subsurface Weight"].default_value = 1.0
    shader.inputs["Subsurface Radius"].default_value = tuple(0.3 + 0.7 * c for c in colour)
    shader.inputs["Subsurface Scale"].default_value = 0.04
    return material


def occupied_cells():
    """Grid cells (x, y, plate) filled by bricks: a stud under one of them is left out."""
    return {
        (x0 + i, y0 + j, z0 + k)
        for _, (x0, y0), z0, (nx, ny), height in BRICKS
        for i in range(nx)
        for j in range(ny)
        for k in range(height)
    }


def add_brick(colour, first, z, size, height, filled, material):
    """One closed mesh: a box united with its visible studs, edges rounded."""
    low = [first[0] * PITCH + GAP, first[1] * PITCH + GAP, z * PLATE + GAP]
    high = [
        (first[0] + size[0]) * PITCH - GAP,
        (first[1] + size[1]) * PITCH - GAP,
        (z + height) * PLATE - GAP,
    ]
    bpy.ops.mesh.primitive_cube_add(
        size=1, calc_uvs=False, location=[(a + b) / 2 for a, b in zip(low, high, strict=True)]
    )
    brick = bpy.context.object
    brick.scale = [b - a for a, b in zip(low, high, strict=True)]
    bpy.ops.object.transform_apply(scale=True)
    studs = []
    for i in range(first[0], first[0] + size[0]):
        for j in range(first[1], first[1] + size[1]):
            if (i, j, z + height) not in filled:
                studs.append(add_stud(i, j, high[2]))
    if studs:
        unite(brick, studs)
    finish(brick, material, BEVEL, 2)


def add_stud(i, j, top):
    bpy.ops.mesh.primitive_cylinder_add(
        vertices=20,
        radius=STUD_RADIUS,
        depth=2 * STUD_HEIGHT,
        calc_uvs=False,
        location=((i + 0.5) * PITCH, (j + 0.5) * PITCH, top),
    )
    return bpy.context.object


def unite(brick, studs):
    for stud in studs:
        stud.select_set(True)
    bpy.context.view_layer.objects.active = studs[0]
    brick.select_set(False)
    bpy.ops.object.join()
    joined = bpy.context.object
    modifier = brick.modifiers.new("studs", "BOOLEAN")
    modifier.operation, modifier.object, modifier.solver = "UNION", joined, "EXACT"
    bpy.context.view_layer.objects.active = brick
    bpy.ops.object.modifier_apply(modifier="studs")
    bpy.data.objects.remove(joined, do_unlink=True)


def add_wheel(x, y, tyre, hub):
    for radius, width, material, bevel in (
        (WHEEL_RADIUS, WHEEL_WIDTH, tyre, 0.02),
        (0.5 * WHEEL_RADIUS, WHEEL_WIDTH + 0.016, hub, 0.008),
    ):
        bpy.ops.mesh.primitive_cylinder_add(
            vertices=40,
            radius=radius,
            depth=width,
            calc_uvs=False,
            location=(x * PITCH, y * PITCH, WHEEL_RADIUS),
            rotation=(math.pi / 2, 0, 0),
        )
        finish(bpy.context.object, material, bevel, 3)


def finish(item, material, bevel, segments):
    modifier = item.modifiers.new("edges", "BEVEL")
    modifier.width, modifier.segments = bevel, segments
    modifier.limit_method, modifier.angle_limit = "ANGLE", math.radians(40)
    modifier.harden_normals = True
    item.data.shade_smooth()
    item.data.materials.clear()
    item.data.materials.append(material)
    bpy.ops.object.select_all(action="DESELECT")


def build():
    materials = {name: plastic(name, colour) for name, colour in COLOURS.items()}
    filled = occupied_cells()
    for colour, first, z, size, height in BRICKS:
        add_brick(colour, first, z, size, height, filled, materials[colour])
    for x, y in WHEELS:
        add_wheel(x, y, materials["grey"], materials["yellow"])


build()

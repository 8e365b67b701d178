"""A ball in a ring of a translucent material that takes no light away, for `energy` and `noise`.

    rna-capture white.py --out white.rays/

Runs inside Blender.
"""

import bpy

BOUNCES = 64  # what they cut off a white asset is below 0.1%


def material():
    made = bpy.data.materials.new("white")
    made.use_nodes = True
    inputs = made.node_tree.nodes["Principled BSDF"].inputs
    inputs["Base Color"].default_value = (1.0, 1.0, 1.0, 1.0)
    inputs["Specular IOR Level"].default_value = 0.0
    inputs["Subsurface Weight"].default_value = 1.0
    inputs["Subsurface Radius"].default_value = (1.0, 0.6, 0.3)
    inputs["Subsurface Scale"].default_value = 0.05
    return made


def finish(item, white):
    item.data.shade_smooth()
    item.data.materials.append(white)


def build():
    white = material()
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4, radius=0.3, calc_uvs=False)
    finish(bpy.context.object, white)
    bpy.ops.mesh.primitive_torus_add(
        major_radius=0.42, minor_radius=0.08, major_segments=64, minor_segments=20
    )
    finish(bpy.context.object, white)
    cycles = bpy.context.scene.cycles
    cycles.max_bounces = cycles.diffuse_bounces = BOUNCES


build()

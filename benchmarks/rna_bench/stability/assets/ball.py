"""A ball of one glossy material, for the case `sharp`.

    rna-capture ball.py --out ball.rays/ -- --roughness 0.1 --coat 1.0

Runs inside Blender.
"""

import argparse

import bpy


def material(args):
    made = bpy.data.materials.new("gloss")
    made.use_nodes = True
    inputs = made.node_tree.nodes["Principled BSDF"].inputs
    inputs["Base Color"].default_value = (0.35, 0.16, 0.08, 1.0)
    inputs["Metallic"].default_value = args.metallic
    inputs["Roughness"].default_value = args.roughness
    inputs["Anisotropic"].default_value = args.anisotropic
    inputs["Coat Weight"].default_value = args.coat
    inputs["Coat Roughness"].default_value = args.coat_roughness
    return made


def build(args):
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=5, radius=0.5, calc_uvs=False)
    ball = bpy.context.object
    ball.data.shade_smooth()
    ball.data.materials.append(material(args))


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("--roughness", type=float, default=0.5)
parser.add_argument("--metallic", type=float, default=0.0)
parser.add_argument("--anisotropic", type=float, default=0.0)
parser.add_argument("--coat", type=float, default=0.0)
parser.add_argument("--coat-roughness", type=float, default=0.05)
build(parser.parse_args())

"""The Lambertian sphere of `rna-bench peers sphere` as an asset, for methods that know geometry.

    rna-make benchmarks/rna_bench/peers/sphere/sphere_asset.py --out sphere.rna --minutes 3

Its place and colour are those of `lambert_sphere.py`, which has +Y up. Runs inside Blender.
"""

import bpy

X, Y, Z = 0.1, 0.05, -0.1
RADIUS = 0.7
ALBEDO = (0.45, 0.3, 0.2)

bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=6, radius=RADIUS, location=(X, -Z, Y))
sphere = bpy.context.object
sphere.data.shade_smooth()
matt = bpy.data.materials.new("matt")
matt.use_nodes = True
nodes, links = matt.node_tree.nodes, matt.node_tree.links
diffuse = nodes.new("ShaderNodeBsdfDiffuse")
diffuse.inputs["Color"].default_value = (*ALBEDO, 1.0)
links.new(diffuse.outputs["BSDF"], nodes["Material Output"].inputs["Surface"])
sphere.data.materials.append(matt)

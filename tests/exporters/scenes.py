"""Small scenes for Blender, as text: each ends with the captured objects in the scene.

Vertices and faces are spelled out, without Blender's operators: those number their vertices
differently from process to process.
"""

from pathlib import Path

import numpy as np
import trimesh

PRELUDE = """
import bpy
from mathutils import Matrix

def diffuse(colour):
    material = bpy.data.materials.new("diffuse")
    material.use_nodes = True
    tree = material.node_tree
    shader = tree.nodes.new("ShaderNodeBsdfDiffuse")
    shader.inputs["Color"].default_value = (*colour, 1.0)
    tree.links.new(shader.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    return material

def principled(**inputs):
    material = bpy.data.materials.new("principled")
    material.use_nodes = True
    for name, value in inputs.items():
        socket = material.node_tree.nodes["Principled BSDF"].inputs[name.replace("_", " ")]
        socket.default_value = value
    return material

def add(vertices, faces, material=None, smooth=False, matrix=None):
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(vertices, [], faces)
    mesh.polygons.foreach_set("use_smooth", [smooth] * len(mesh.polygons))
    if material is not None:
        mesh.materials.append(material)
    item = bpy.data.objects.new("object", mesh)
    if matrix is not None:
        item.matrix_world = Matrix(matrix)
    bpy.context.scene.collection.objects.link(item)
    return item

CUBE = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]

def square(half, x=0.0, y=0.0, z=0.0):
    return ([(x - half, y - half, z), (x + half, y - half, z), (x + half, y + half, z),
             (x - half, y + half, z)], [(0, 1, 2, 3)])
"""


def ball(subdivisions: int = 2) -> str:
    """`BALL`, vertices and faces of a unit icosphere, as Python text."""
    mesh = trimesh.creation.icosphere(subdivisions=subdivisions)
    vertices = np.asarray(mesh.vertices)
    vertices /= np.linalg.norm(vertices, axis=1, keepdims=True)
    return f"BALL = {vertices.tolist()!r}, {np.asarray(mesh.faces).tolist()!r}\n"


def fur(strands: int, bend: float, root: float, tip: float, melanin: float) -> str:
    """Bent strands of six points all over a ball, radius 0.4 to 1.2; `root`, `tip`: their radii."""
    return f"""
import numpy as np, rna_hair
from rna_hair.objects import add_curves, chiang_material
rng = np.random.default_rng(3)
out = rng.normal(size=({strands}, 1, 3))
out /= np.linalg.norm(out, axis=2, keepdims=True)
bend = {bend} * rng.normal(size=({strands}, 1, 3)) * np.linspace(0, 1, 6)[:, None] ** 2
points = out * np.linspace(0.4, 1.2, 6)[:, None] + bend
strands = rna_hair.of_equal_length(points, np.linspace({root}, {tip}, 6))
add_curves(strands, "fur", chiang_material(melanin={melanin}))
"""


def write_scene(folder: Path, name: str, body: str) -> Path:
    """`<folder>/<name>.py`, ready for rna-capture."""
    path = folder / f"{name}.py"
    path.write_text(PRELUDE + ball() + body)
    return path

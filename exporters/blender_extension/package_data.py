"""Meshes, hair and viewport materials of a package."""

import json
import tempfile
from pathlib import Path

import bpy
import numpy as np

from . import sdk_command
from .axes import to_blender

_COLOURS = "rna_color"


def load_package(path):
    """Data-blocks of all parts of a package, in order, and its poster as PNG bytes or None.

    path: the file, absolute. Raises SdkError where the package is broken.
    """
    with tempfile.TemporaryDirectory(prefix="rna-import-") as folder:
        out = Path(folder) / "package.npz"
        sdk_command.run([sdk_command.SIDE / "unpack.py", path, out], Path(folder) / "log")
        with np.load(out) as arrays:
            result = dict(arrays)
    info = json.loads(str(result["info"]))
    data = []
    for number, part in enumerate(info["parts"]):
        part_arrays = {
            n.partition("/")[2]: a for n, a in result.items() if n.startswith(f"{number}/")
        }
        alone = len(info["parts"]) == 1
        name = info["name"] if alone else f"{info['name']} {part['name']}"
        block = _mesh(name, part_arrays) if part["kind"] == "surface" else _hair(name, part_arrays)
        block.materials.append(_material(name, (info["standin"] or {number: {}})[number]))
        block.rna_package.path = _stored(path)
        block.rna_package.part = number
        block.rna_package.info = json.dumps(info)
        block.rna_package.stamp = str(path.stat().st_mtime_ns)
        data.append(block)
    return data, result.get("poster")


def _stored(path):
    """Relative to the .blend file, if there is one on the same drive."""
    if not bpy.data.filepath:
        return str(path)
    try:
        return bpy.path.relpath(str(path))
    except ValueError:
        return str(path)


def _mesh(name, arrays):
    mesh = bpy.data.meshes.new(name)
    triangles = arrays["triangles"].astype(np.int32)
    corners = triangles.reshape(-1)
    mesh.vertices.add(len(arrays["positions"]))
    mesh.vertices.foreach_set("co", to_blender(arrays["positions"]).reshape(-1))
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(len(triangles))
    mesh.polygons.foreach_set("loop_start", np.arange(0, len(corners), 3, dtype=np.int32))
    if "uvs" in arrays:
        uvs = arrays["uvs"][corners] * np.float32([1, -1]) + np.float32([0, 1])
        mesh.uv_layers.new(name="UVMap").uv.foreach_set("vector", uvs.reshape(-1))
    _add_colours(mesh, arrays["colors"])
    mesh.update(calc_edges=True)
    mesh.normals_split_custom_set_from_vertices(to_blender(arrays["normals"]).tolist())
    return mesh


def _hair(name, arrays):
    curves = bpy.data.hair_curves.new(name)
    curves.add_curves(np.diff(arrays["offsets"].astype(np.int64)).tolist())
    curves.position_data.foreach_set("vector", to_blender(arrays["points"]).reshape(-1))
    radius = curves.attributes.new("radius", "FLOAT", "POINT")
    radius.data.foreach_set("value", np.ascontiguousarray(arrays["radii"]))
    curves.set_types(type="POLY")
    _add_colours(curves, arrays["colors"])
    return curves


def _add_colours(data, rgb):
    colours = data.attributes.new(_COLOURS, "FLOAT_COLOR", "POINT")
    rgba = np.concatenate([rgb, np.ones((len(rgb), 1), np.float32)], axis=1)
    colours.data.foreach_set("color", rgba.reshape(-1))


def _material(name, standin):
    """Stand-in material for viewports, other engines: vertex colours, the package's roughness."""
    material = bpy.data.materials.new(f"{name} stand-in")
    if material.node_tree is None:  # before Blender 5
        material.use_nodes = True
    tree = material.node_tree
    shader = tree.nodes["Principled BSDF"]
    shader.inputs["Roughness"].default_value = standin.get("roughness", 0.5)
    shader.inputs["Metallic"].default_value = standin.get("metallic", 0.0)
    colour = tree.nodes.new("ShaderNodeAttribute")
    colour.attribute_name = _COLOURS
    colour.location = shader.location.x - 250.0, shader.location.y
    tree.links.new(colour.outputs["Color"], shader.inputs["Base Color"])
    material.diffuse_color = (*standin.get("baseColor", (0.5, 0.5, 0.5)), 1.0)
    return material

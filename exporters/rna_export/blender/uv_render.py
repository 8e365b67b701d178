"""A socket of a material's nodes as a texture over the UV coordinates.

The nodes, wired to an emission shader, are rendered on a unit square, one sample at each texel
centre.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import bpy
import numpy as np

_PROCEDURAL = 1024  # texels a side where no image says how fine the pattern is
_SMALLEST, _LARGEST = 4, 4096  # Blender renders no fewer than 4 pixels a side
_OUTSIDE_UV = {  # nodes whose values are no function of the UV coordinates, by the socket used
    "TEX_COORD": ("Generated", "Normal", "Object", "Camera", "Window", "Reflection"),
    "NEW_GEOMETRY": None,
    "OBJECT_INFO": None,
    "PARTICLE_INFO": None,
    "HAIR_INFO": None,
    "ATTRIBUTE": None,
    "VERTEX_COLOR": None,
    "CAMERA": None,
    "LIGHT_PATH": None,
    "LAYER_WEIGHT": None,
    "FRESNEL": None,
    "VOLUME_INFO": None,
    "POINT_INFO": None,
    "TANGENT": None,
    "AMBIENT_OCCLUSION": None,
    "BEVEL": None,
    "WIREFRAME": None,
}


def upstream(socket: bpy.types.NodeSocket) -> Iterator[tuple[bpy.types.Node, bpy.types.NodeSocket]]:
    """Every (node, output socket) that a socket's value comes from, within its tree."""
    seen, todo = set(), [socket]
    while todo:
        output = todo.pop()
        node = output.node
        if (node.name, output.identifier) in seen:
            continue
        seen.add((node.name, output.identifier))
        yield node, output
        todo += [link.from_socket for s in node.inputs for link in s.links]


def _nodes_of(
    socket: bpy.types.NodeSocket,
) -> Iterator[tuple[bpy.types.Node, bpy.types.NodeSocket]]:
    """Nodes upstream of a socket, including those inside groups."""
    for node, output in upstream(socket):
        yield node, output
        if node.type == "GROUP" and node.node_tree is not None:
            yield from ((n, o) for n in node.node_tree.nodes for o in n.outputs if o.is_linked)


def not_of_uv(colour: bpy.types.NodeSocket) -> list[str]:
    """Names of the nodes that make the colour depend on more than the UV coordinates."""
    return [
        f"the node {node.bl_label!r}"
        for node, output in _nodes_of(colour)
        if node.type in _OUTSIDE_UV and output.name in (_OUTSIDE_UV[node.type] or (output.name,))
    ]


def _texture_size(colour: bpy.types.NodeSocket) -> tuple[int, int]:
    """(width, height) of the largest image that the colour depends on."""
    nodes = {node.name: node for node, _ in _nodes_of(colour)}.values()
    images = [n.image for n in nodes if n.type == "TEX_IMAGE" and n.image is not None]
    if images:
        size = max((tuple(image.size) for image in images), key=lambda s: s[0] * s[1])
        return tuple(min(max(side, _SMALLEST), _LARGEST) for side in size)
    patterns = any(n.type.startswith("TEX_") and n.type != "TEX_COORD" for n in nodes)
    return (_PROCEDURAL if patterns else _SMALLEST,) * 2


def _uv_names(colour: bpy.types.NodeSocket) -> set[str]:
    nodes = [node for node, _ in _nodes_of(colour)]
    names = {n.uv_map for n in nodes if n.type in ("UVMAP", "NORMAL_MAP") and n.uv_map}
    return names or {"UVMap"}


def rendered(
    material: bpy.types.Material,
    tree: bpy.types.NodeTree,
    output: bpy.types.Node,
    colour: bpy.types.NodeSocket,
    folder: Path,
) -> np.ndarray:
    """(h, w, 3) float32: a colour socket of the tree at texel centres, row 0 at the top.

    folder: for a temporary file.
    """
    size = _texture_size(colour)
    names = _uv_names(colour)
    glow = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(colour, glow.inputs["Color"])
    tree.links.new(glow.outputs[0], output.inputs["Surface"])
    scene = bpy.data.scenes.new("rna texture")
    square = _square(scene, material, names, size)
    try:
        _set_up(scene, size, folder / "texture.exr")
        bpy.ops.render.render(write_still=True, scene=scene.name)
        image = bpy.data.images.load(scene.render.filepath)
        pixels = np.empty(4 * size[0] * size[1], np.float32)
        image.pixels.foreach_get(pixels)
        bpy.data.images.remove(image)
    finally:
        Path(scene.render.filepath).unlink(missing_ok=True)
        mesh = square.data
        bpy.data.objects.remove(square)
        bpy.data.meshes.remove(mesh)
        bpy.data.scenes.remove(scene)
    return pixels.reshape(size[1], size[0], 4)[::-1, :, :3]


def _square(
    scene: bpy.types.Scene, material: bpy.types.Material, names: set[str], size: tuple[int, int]
) -> bpy.types.Object:
    """A rectangle of the texture's shape in the plane z = 0, its UV coordinates from 0 to 1."""
    width = size[0] / size[1]
    corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    mesh = bpy.data.meshes.new("rna texture")
    vertices = [((u - 0.5) * width, v - 0.5, 0.0) for u, v in corners]
    mesh.from_pydata(vertices, [], [(0, 1, 2, 3)])
    for name in names:
        layer = mesh.uv_layers.new(name=name)
        layer.uv.foreach_set("vector", np.array(corners, np.float32).ravel())
    mesh.materials.append(material)
    square = bpy.data.objects.new("rna texture", mesh)
    scene.collection.objects.link(square)
    return square


def _set_up(scene: bpy.types.Scene, size: tuple[int, int], path: Path) -> None:
    camera = bpy.data.cameras.new("rna texture")
    camera.type, camera.ortho_scale = "ORTHO", max(1.0, size[0] / size[1])
    placed = bpy.data.objects.new("rna texture", camera)
    placed.location = (0.0, 0.0, 1.0)
    scene.collection.objects.link(placed)
    scene.camera = placed
    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = size
    render.resolution_percentage = 100
    render.filepath = str(path)
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = 1, False, False
    cycles.pixel_filter_type, cycles.filter_width = "GAUSSIAN", 0.01  # a box ignores its width
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0

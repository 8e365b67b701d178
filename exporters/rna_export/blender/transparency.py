"""What the materials let through without bending it, as a texture over the UV coordinates.

A material's transmittance is read from its nodes: transparent shaders, mixes of them, and the
Alpha of a Principled BSDF. The same nodes, wired to an emission shader, are rendered on a unit
square, one sample at each texel centre.
"""

from dataclasses import dataclass, field
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


@dataclass
class Transparency:
    """One material's.

    texture: (h, w, 1 or 3) uint8, row 0 at v = 0 of glTF, the top. cutoff: what a value has to
    exceed to be a hole, None if it may be between. ior: relative refractive index for rays from the
    front and from the back, None without Fresnel.
    """

    texture: np.ndarray
    cutoff: float | None = None
    ior: tuple[float, float] | None = None


@dataclass
class _Reading:
    """What was found on the way through the nodes of a material."""

    cutoff: float | None = None
    ior: tuple[float, float] | None = None
    problems: list[str] = field(default_factory=list)


def export_transparency(path):
    """Write an .npz with the textures of all materials that let light through, `0`, `1`, ...

    Returns what they are, and notes for the user of those that could not be told.
    """
    found, notes = [], []
    for material in list(bpy.data.materials):
        transparency, problems = transparency_of(material, Path(path).parent)
        notes += problems
        if transparency is not None:
            found.append((material.name, transparency))
    np.savez(path, **{str(k): each.texture for k, (_, each) in enumerate(found)})
    records = [{"material": n, "cutoff": each.cutoff, "ior": each.ior} for n, each in found]
    return {"materials": records, "notes": notes}


def transparency_of(material, folder):
    """The transparency of a material, or None if it is opaque, and notes for the user.

    folder: for a temporary file.
    """
    if not material.use_nodes:
        return None, []
    copy = material.copy()
    try:
        return _read(material.name, copy, Path(folder))
    finally:
        bpy.data.materials.remove(copy)


def _read(name, material, folder):
    tree = material.node_tree
    output = tree.get_output_node("CYCLES") or tree.get_output_node("ALL")
    if output is None or not output.inputs["Surface"].is_linked:
        return None, []
    reading = _Reading()
    shader = output.inputs["Surface"].links[0].from_socket
    colour = _transmittance(tree, shader, reading)
    if colour is None:
        return None, []
    problems = reading.problems + _not_of_uv(colour)
    if problems:
        return None, [
            f"material {name!r} is transparent by {problems[0]}, which is no function of its UV "
            "coordinates: what is seen through it is part of the captured light"
        ]
    texture = _rendered(material, tree, output, colour, folder)
    if texture.max() == 0:
        return None, []
    cutoff = reading.cutoff
    if cutoff is None and reading.ior is None and _is_binary(texture):
        cutoff = 0.5
    if cutoff is not None or (texture == texture[..., :1]).all():
        texture = texture[..., :1]
    if (texture == texture[:1, :1]).all():
        texture = texture[:1, :1]
    return Transparency(np.ascontiguousarray(texture), cutoff, reading.ior), []


def _is_binary(texture):
    return texture.size > 3 and np.isin(texture, (0, 255)).all()


def _transmittance(tree, shader, reading):
    """A colour socket of `tree` with the transmittance of a shader socket; None for an opaque one.

    Adds nodes to the tree.
    """
    node = shader.node
    if node.type == "BSDF_TRANSPARENT":
        return _value_of(tree, node.inputs["Color"])
    if node.type == "BSDF_PRINCIPLED":
        return _one_minus(tree, _of_threshold(tree, node.inputs["Alpha"], reading, negate=True))
    if node.type == "MIX_SHADER":
        return _of_mix(tree, node, reading)
    if node.type == "ADD_SHADER":
        parts = [_of_input(tree, socket, reading) for socket in node.inputs]
        parts = [part for part in parts if part is not None]
        return _math(tree, "ADD", *parts) if len(parts) == 2 else (parts or [None])[0]
    if node.type == "GROUP" and node.node_tree is not None:
        return _of_group(tree, node, shader, reading)
    if node.type == "REROUTE":
        return _of_input(tree, node.inputs[0], reading)
    return None


def _of_input(tree, socket, reading):
    return _transmittance(tree, socket.links[0].from_socket, reading) if socket.is_linked else None


def _of_mix(tree, node, reading):
    """(1 - factor) of the first shader's and factor of the second's."""
    factor = node.inputs[0]
    source = factor.links[0].from_node if factor.is_linked else None
    if source is not None and source.type == "FRESNEL":
        first, second = (_of_input(tree, s, reading) for s in node.inputs[1:3])
        if second is None and first is not None and not source.inputs["IOR"].is_linked:
            index = source.inputs["IOR"].default_value
            reading.ior = (index, 1.0 / index)
            return first
    first, second = (_of_input(tree, s, reading) for s in node.inputs[1:3])
    if first is None and second is None:
        return None
    if first is not None and second is not None:
        share = _value_of(tree, factor)
        ones = _math(tree, "MULTIPLY", first, _one_minus(tree, share))
        return _math(tree, "ADD", ones, _math(tree, "MULTIPLY", second, share))
    share = _of_threshold(tree, factor, reading, negate=second is None)
    if second is None:
        return _math(tree, "MULTIPLY", first, _one_minus(tree, share))
    return _math(tree, "MULTIPLY", second, share)


def _of_threshold(tree, socket, reading, negate):
    """A factor's value; behind a threshold, what it is compared with the threshold for.

    negate: whether the transmittance is 1 - factor. The cutoff is that of the transmittance.
    """
    value, above, threshold = _comparison(socket)
    if value is None:
        return _value_of(tree, socket)
    cutoff = threshold if above != negate else 1.0 - threshold
    reading.cutoff = float(np.clip(cutoff, 1.0 / 510.0, 1.0 - 1.0 / 510.0))
    colour = _value_of(tree, value)
    return colour if above else _one_minus(tree, colour)


def _comparison(socket):
    """(socket, whether 1 is above, threshold) if a socket's value is a comparison, or Nones."""
    above = True
    while socket.is_linked:
        node = socket.links[0].from_node
        if node.type == "REROUTE":
            socket = node.inputs[0]
            continue
        if node.type != "MATH":
            break
        a, b = node.inputs[0], node.inputs[1]
        if node.operation == "SUBTRACT" and not a.is_linked and a.default_value == 1.0:
            above, socket = not above, b
        elif node.operation == "ROUND":
            return a, above, 0.5
        elif node.operation in ("GREATER_THAN", "LESS_THAN") and a.is_linked and not b.is_linked:
            return a, above == (node.operation == "GREATER_THAN"), b.default_value
        elif node.operation in ("GREATER_THAN", "LESS_THAN") and b.is_linked and not a.is_linked:
            return b, above == (node.operation == "LESS_THAN"), a.default_value
        else:
            break
    return None, None, None


def _of_group(tree, node, shader, reading):
    """The group's transmittance as one more output of a copy of the group."""
    group = node.node_tree.copy()
    name = shader.name
    ends = [n for n in group.nodes if n.type == "GROUP_OUTPUT" and n.is_active_output]
    if not ends or not ends[0].inputs[name].is_linked:
        return None
    inside = _transmittance(group, ends[0].inputs[name].links[0].from_socket, reading)
    if inside is None:
        return None
    kind = {"in_out": "OUTPUT", "socket_type": "NodeSocketColor"}
    made = group.interface.new_socket("transmittance", **kind)
    group.links.new(inside, ends[0].inputs[made.identifier])
    node.node_tree = group
    return node.outputs[made.identifier]


def _value_of(tree, socket):
    """A socket with the value of an input."""
    if socket.is_linked:
        return socket.links[0].from_socket
    constant = tree.nodes.new("ShaderNodeRGB")
    value = socket.default_value
    rgb = list(value)[:3] if hasattr(value, "__len__") else [value] * 3
    constant.outputs[0].default_value = (*rgb, 1.0)
    return constant.outputs[0]


def _one_minus(tree, colour):
    white = tree.nodes.new("ShaderNodeRGB")
    white.outputs[0].default_value = (1.0, 1.0, 1.0, 1.0)
    return _math(tree, "SUBTRACT", white.outputs[0], colour)


def _math(tree, operation, a, b):
    node = tree.nodes.new("ShaderNodeVectorMath")
    node.operation = operation
    tree.links.new(a, node.inputs[0])
    tree.links.new(b, node.inputs[1])
    return node.outputs[0]


def _upstream(socket):
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


def _nodes_of(socket):
    """As `_upstream`, the insides of groups too."""
    for node, output in _upstream(socket):
        yield node, output
        if node.type == "GROUP" and node.node_tree is not None:
            yield from ((n, o) for n in node.node_tree.nodes for o in n.outputs if o.is_linked)


def _not_of_uv(colour):
    """What makes the colour depend on more than the UV coordinates, by name."""
    return [
        f"the node {node.bl_label!r}"
        for node, output in _nodes_of(colour)
        if node.type in _OUTSIDE_UV
        and (_OUTSIDE_UV[node.type] is None or output.name in _OUTSIDE_UV[node.type])
    ]


def _texture_size(colour):
    """(width, height) of the largest image that the colour depends on."""
    nodes = {node.name: node for node, _ in _nodes_of(colour)}.values()
    images = [n.image for n in nodes if n.type == "TEX_IMAGE" and n.image is not None]
    if images:
        size = max((tuple(image.size) for image in images), key=lambda s: s[0] * s[1])
        return tuple(min(max(side, _SMALLEST), _LARGEST) for side in size)
    patterns = any(n.type.startswith("TEX_") and n.type != "TEX_COORD" for n in nodes)
    return (_PROCEDURAL if patterns else _SMALLEST,) * 2


def _uv_names(colour):
    names = {n.uv_map for n, _ in _nodes_of(colour) if n.type == "UVMAP" and n.uv_map}
    return names or {"UVMap"}


def _rendered(material, tree, output, colour, folder):
    """(h, w, 3) uint8: the colour at texel centres, row 0 at the top."""
    size = _texture_size(colour)
    names = _uv_names(colour)
    glow = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(colour, glow.inputs["Color"])
    tree.links.new(glow.outputs[0], output.inputs["Surface"])
    scene = bpy.data.scenes.new("rna transparency")
    square = _square(scene, material, names, size)
    try:
        _set_up(scene, size, folder / "transparency.exr")
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
    rgb = pixels.reshape(size[1], size[0], 4)[::-1, :, :3]
    return np.round(255.0 * np.clip(rgb, 0.0, 1.0)).astype(np.uint8)


def _square(scene, material, names, size):
    """A rectangle of the texture's shape in the plane z = 0, its UV coordinates from 0 to 1."""
    width = size[0] / size[1]
    corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    mesh = bpy.data.meshes.new("rna transparency")
    vertices = [((u - 0.5) * width, v - 0.5, 0.0) for u, v in corners]
    mesh.from_pydata(vertices, [], [(0, 1, 2, 3)])
    for name in names:
        layer = mesh.uv_layers.new(name=name)
        layer.uv.foreach_set("vector", np.array(corners, np.float32).ravel())
    mesh.materials.append(material)
    square = bpy.data.objects.new("rna transparency", mesh)
    scene.collection.objects.link(square)
    return square


def _set_up(scene, size, path):
    camera = bpy.data.cameras.new("rna transparency")
    camera.type, camera.ortho_scale = "ORTHO", max(1.0, size[0] / size[1])
    placed = bpy.data.objects.new("rna transparency", camera)
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
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 0.01
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0

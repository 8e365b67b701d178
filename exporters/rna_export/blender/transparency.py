"""Unrefracted transmittance of the materials, as a texture over the UV coordinates.

A material's transmittance is read from its nodes: transparent shaders, mixes of them, and the
Alpha of a Principled BSDF. The same nodes, wired to an emission shader, are rendered on a unit
square, one sample at each texel centre.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from uv_render import not_of_uv, rendered


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
    """Findings while the nodes of a material are traversed."""

    cutoff: float | None = None
    ior: tuple[float, float] | None = None
    problems: list[str] = field(default_factory=list)


def export_transparency(path: str) -> dict[str, Any]:
    """Write an .npz with the textures of all materials that let light through, `0`, `1`, ...

    Returns what they are, and notes for the user of those that could not be told.
    """
    found, notes = [], []
    for material in list(bpy.data.materials):
        transparency, problems = transparency_of(material, Path(path).parent)
        notes += problems
        if transparency is not None:
            found.append((material.name, transparency))
    textures: dict[str, Any] = {str(k): each.texture for k, (_, each) in enumerate(found)}
    np.savez(path, **textures)
    records = [{"material": n, "cutoff": each.cutoff, "ior": each.ior} for n, each in found]
    return {"materials": records, "notes": notes}


def transparency_of(
    material: bpy.types.Material, folder: Path
) -> tuple[Transparency | None, list[str]]:
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


def _read(
    name: str, material: bpy.types.Material, folder: Path
) -> tuple[Transparency | None, list[str]]:
    tree = material.node_tree
    output = tree.get_output_node("CYCLES") or tree.get_output_node("ALL")
    if output is None or not output.inputs["Surface"].is_linked:
        return None, []
    reading = _Reading()
    shader = output.inputs["Surface"].links[0].from_socket
    colour = _transmittance(tree, shader, reading)
    if colour is None:
        return None, []
    problems = reading.problems + not_of_uv(colour)
    if problems:
        return None, [
            f"material {name!r} is transparent by {problems[0]}, which is no function of its UV "
            "coordinates: what is seen through it is part of the captured light"
        ]
    texture = _rounded(rendered(material, tree, output, colour, folder))
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


def _rounded(colour: np.ndarray) -> np.ndarray:
    return np.asarray(np.round(255.0 * np.clip(colour, 0.0, 1.0)), np.uint8)


def _is_binary(texture: np.ndarray) -> bool:
    return texture.size > 3 and bool(np.isin(texture, (0, 255)).all())


def _transmittance(
    tree: bpy.types.NodeTree, shader: bpy.types.NodeSocket, reading: _Reading
) -> bpy.types.NodeSocket | None:
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


def _of_input(
    tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket, reading: _Reading
) -> bpy.types.NodeSocket | None:
    return _transmittance(tree, socket.links[0].from_socket, reading) if socket.is_linked else None


def _of_mix(
    tree: bpy.types.NodeTree, node: bpy.types.Node, reading: _Reading
) -> bpy.types.NodeSocket | None:
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


def _of_threshold(
    tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket, reading: _Reading, negate: bool
) -> bpy.types.NodeSocket:
    """Value of a factor; for a threshold node, the value that is compared.

    negate: whether the transmittance is 1 - factor. The cutoff is that of the transmittance.
    """
    compared = _comparison(socket)
    if compared is None:
        return _value_of(tree, socket)
    value, above, threshold = compared
    cutoff = threshold if above != negate else 1.0 - threshold
    reading.cutoff = float(np.clip(cutoff, 1.0 / 510.0, 1.0 - 1.0 / 510.0))
    colour = _value_of(tree, value)
    return colour if above else _one_minus(tree, colour)


def _comparison(socket: bpy.types.NodeSocket) -> tuple[bpy.types.NodeSocket, bool, float] | None:
    """(socket, whether 1 is above, threshold) if a socket's value is a comparison, or None."""
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
    return None


def _of_group(
    tree: bpy.types.NodeTree, node: bpy.types.Node, shader: bpy.types.NodeSocket, reading: _Reading
) -> bpy.types.NodeSocket | None:
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


def _value_of(tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    """A socket with the value of an input."""
    if socket.is_linked:
        return socket.links[0].from_socket
    constant = tree.nodes.new("ShaderNodeRGB")
    value = socket.default_value
    rgb = list(value)[:3] if hasattr(value, "__len__") else [value] * 3
    constant.outputs[0].default_value = (*rgb, 1.0)
    return constant.outputs[0]


def _one_minus(tree: bpy.types.NodeTree, colour: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    white = tree.nodes.new("ShaderNodeRGB")
    white.outputs[0].default_value = (1.0, 1.0, 1.0, 1.0)
    return _math(tree, "SUBTRACT", white.outputs[0], colour)


def _math(
    tree: bpy.types.NodeTree, operation: str, a: bpy.types.NodeSocket, b: bpy.types.NodeSocket
) -> bpy.types.NodeSocket:
    node = tree.nodes.new("ShaderNodeVectorMath")
    node.operation = operation
    tree.links.new(a, node.inputs[0])
    tree.links.new(b, node.inputs[1])
    return node.outputs[0]

"""Unrefracted transmittance of the materials, read from their nodes.

It comes from transparent shaders, mixes of them, and the Alpha of a Principled BSDF.
"""

from dataclasses import dataclass
from functools import partial

import bpy
import numpy as np
from rna_materials.node_sources import as_output, combined, end_of, linked
from rna_materials.uv_render import surface_output

_math = partial(combined, kind="ShaderNodeVectorMath")

_LEAST_IOR = 0.01  # relative, that a package holds; the greatest is its inverse


@dataclass
class Transmittance:
    """colour: a socket of the material's tree with the transmittance, before Fresnel and cutoff.

    cutoff: what the colour has to exceed to be a hole, None if it may be between. ior: relative
    refractive index for rays from the front and from the back, None without Fresnel.
    """

    colour: bpy.types.NodeSocket
    cutoff: float | None = None
    ior: tuple[float, float] | None = None


@dataclass
class _Reading:
    """Findings while the nodes of a material are traversed."""

    thresholds: bool
    cutoff: float | None = None
    ior: tuple[float, float] | None = None


def transmittance_of(material: bpy.types.Material, thresholds: bool = True) -> Transmittance | None:
    """The transmittance of a material, whose nodes are added to; None if it is opaque.

    thresholds: whether the colour is what a threshold node compares; otherwise, what it gives.
    """
    output = surface_output(material)
    shader = None if output is None else linked(output.inputs["Surface"])
    if shader is None:
        return None
    reading = _Reading(thresholds)
    colour = _transmittance(material.node_tree, shader, reading)
    return None if colour is None else Transmittance(colour, reading.cutoff, reading.ior)


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
    return None


def _of_input(
    tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket, reading: _Reading
) -> bpy.types.NodeSocket | None:
    shader = linked(socket)
    return None if shader is None else _transmittance(tree, shader, reading)


def _of_mix(
    tree: bpy.types.NodeTree, node: bpy.types.Node, reading: _Reading
) -> bpy.types.NodeSocket | None:
    """(1 - factor) of the first shader's and factor of the second's."""
    factor = node.inputs[0]
    source = linked(factor)
    if source is not None and source.node.type == "FRESNEL":
        first, second = (_of_input(tree, s, reading) for s in node.inputs[1:3])
        facing = source.node.inputs["IOR"]
        is_thin = not facing.is_linked and _LEAST_IOR <= facing.default_value <= 1.0 / _LEAST_IOR
        if second is None and first is not None and is_thin:
            reading.ior = (facing.default_value, 1.0 / facing.default_value)
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

    negate: whether the transmittance is 1 - factor. The cutoff applies to the transmittance.
    """
    compared = _comparison(socket) if reading.thresholds else None
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
    while (output := linked(socket)) is not None and output.node.type == "MATH":
        node = output.node
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
    wanted, node.node_tree = shader.identifier, node.node_tree.copy()
    end = end_of(node.node_tree)
    inputs = () if end is None else end.inputs
    shown = next((each for each in inputs if each.identifier == wanted), None)
    inside = None if shown is None else _of_input(node.node_tree, shown, reading)
    return None if inside is None else as_output(node, inside)


def _value_of(tree: bpy.types.NodeTree, socket: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    """A socket with the value of an input."""
    link = next((each for each in socket.links if not each.is_muted), None)
    if link is not None:
        return link.from_socket
    constant = tree.nodes.new("ShaderNodeRGB")
    value = socket.default_value
    rgb = list(value)[:3] if hasattr(value, "__len__") else [value] * 3
    constant.outputs[0].default_value = (*rgb, 1.0)
    return constant.outputs[0]


def _one_minus(tree: bpy.types.NodeTree, colour: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    white = tree.nodes.new("ShaderNodeRGB")
    white.outputs[0].default_value = (1.0, 1.0, 1.0, 1.0)
    return _math(tree, "SUBTRACT", white.outputs[0], colour)

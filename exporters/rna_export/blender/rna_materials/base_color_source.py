"""Nodes of a material's base colour: a factor, times the value of one socket."""

from dataclasses import dataclass

import bpy
import numpy as np
from rna_materials.node_sources import Inside, Source, origin, own_value, sources
from rna_materials.uv_render import surface_output

COLOURS = {  # shaders whose light is multiplied by a colour -> the input that it has
    "BSDF_PRINCIPLED": "Base Color",
    "BSDF_METALLIC": "Base Color",
    "BSDF_DIFFUSE": "Color",
    "BSDF_GLASS": "Color",
    "BSDF_GLOSSY": "Color",
    "BSDF_REFRACTION": "Color",
    "BSDF_TOON": "Color",
    "BSDF_TRANSLUCENT": "Color",
    "SUBSURFACE_SCATTERING": "Color",
}

_MIXED = {"MIX": ("Factor_Float", "A_Color", "B_Color"), "MIX_RGB": ("Fac", "Color1", "Color2")}
"""Nodes that mix two colours -> identifiers of the share's input, and of the colours'."""


@dataclass
class BaseColour:
    """A material's base colour: the factor (3,), times the colour that `source` gives.

    source: None for a factor alone. Colours of vertices that multiply it are no part of it: the
    light that it is a factor of is learnt with them.
    """

    factor: np.ndarray
    source: Source | None


def base_colour_of(material: bpy.types.Material) -> BaseColour | None:
    """The one base colour of all shaders of a material's surface; None of several, or of none.

    Shaders of one colour beside those of an image, such as a white gloss, do not count.
    """
    output = surface_output(material)
    if output is None:
        return None
    constants: list[BaseColour] = []
    linked: dict[object, BaseColour] = {}
    for node, _, inside in sources(output.inputs["Surface"]):
        if node.type in COLOURS:
            found = _product(node.inputs[COLOURS[node.type]], inside)
            if found.source is None:
                constants.append(found)
            else:
                before, socket, groups = found.source
                linked.setdefault((before, socket.identifier, groups), found)
    if linked:
        return next(iter(linked.values())) if len(linked) == 1 else None
    same = constants and all(np.array_equal(c.factor, constants[0].factor) for c in constants)
    return constants[0] if same else None


def _product(socket: bpy.types.NodeSocket, inside: Inside) -> BaseColour:
    """An input's value, past multiplications by constants."""
    factor = np.ones(3)
    while True:
        value = own_value(socket, inside)
        if value is not None:
            return BaseColour(factor * value, None)
        source = origin(socket, inside)
        if source is None:
            return BaseColour(factor, None)
        step = _step(source)
        if step is None:
            return BaseColour(factor, source)
        times, following, inside = step
        factor = factor * times
        if following is None:
            return BaseColour(factor, None)
        socket = following


def _step(source: Source) -> tuple[np.ndarray, bpy.types.NodeSocket | None, Inside] | None:
    """Factor of a node, and the input that it multiplies; None for any other node."""
    node, _, inside = source
    if node.type == "RGB":
        return np.array(node.outputs[0].default_value[:3]), None, inside
    if node.type == "VECT_MATH" and node.operation in ("MULTIPLY", "SCALE"):
        other = node.inputs["Scale"] if node.operation == "SCALE" else node.inputs[1]
        value = own_value(other, inside)
        return None if value is None else (np.array(value), node.inputs[0], inside)
    if node.type in _MIXED and getattr(node, "data_type", "RGBA") == "RGBA":
        return _of_mix(node, inside)
    return None


def _of_mix(
    node: bpy.types.Node, inside: Inside
) -> tuple[np.ndarray, bpy.types.NodeSocket, Inside] | None:
    share, first, second = (
        next(s for s in node.inputs if s.identifier == name) for name in _MIXED[node.type]
    )
    weight = own_value(share, inside)
    if weight is None or node.blend_type not in ("MIX", "MULTIPLY"):
        return None
    w = weight[0]
    if node.blend_type == "MIX":
        shown = {0.0: first, 1.0: second}.get(w)
        return None if shown is None else (np.ones(3), shown, inside)
    if (value := own_value(second, inside)) is not None:
        return 1.0 - w + w * np.array(value), first, inside
    if w == 1.0 and (value := own_value(first, inside)) is not None:
        return np.array(value), second, inside
    of_vertices = [_is_of_vertices(each, inside) for each in (first, second)]
    if w == 1.0 and of_vertices in ([True, False], [False, True]):
        return np.ones(3), second if of_vertices[0] else first, inside
    return None


def _is_of_vertices(socket: bpy.types.NodeSocket, inside: Inside) -> bool:
    source = origin(socket, inside)
    return source is not None and source[0].type in ("VERTEX_COLOR", "ATTRIBUTE")

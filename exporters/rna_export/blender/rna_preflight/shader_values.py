"""Shaders that a material's output is made of, and constants of their inputs."""

from collections.abc import Iterator

import bpy
from rna_materials.node_sources import Inside, linked, origin, sources
from rna_materials.uv_render import surface_sources

Shader = tuple[bpy.types.Node, Inside]
"""A shader node, and the groups around it."""

_SHADERS = ("BSDF_", "EMISSION", "SUBSURFACE_SCATTERING", "EEVEE_SPECULAR", "HOLDOUT")


def surface_shaders(material: bpy.types.Material) -> list[Shader]:
    """Shaders of the surface of a material; none without a surface."""
    return [
        (node, inside)
        for node, _, inside in surface_sources(material)
        if node.type.startswith(_SHADERS)
    ]


def volume_shaders(material: bpy.types.Material) -> list[Shader]:
    """Shaders of the volume of a material."""
    output = None if material.node_tree is None else material.node_tree.get_output_node("CYCLES")
    if output is None:
        return []
    every = sources(output.inputs["Volume"])
    kinds = ("VOLUME_", "PRINCIPLED_VOLUME")
    return [(node, inside) for node, _, inside in every if node.type.startswith(kinds)]


def constant(shader: Shader, name: str) -> tuple[float, ...] | None:
    """The value of an input, one number or more; None where a texture or a node gives it."""
    node, inside = shader
    socket = node.inputs[name]
    while True:
        output = linked(socket)
        if output is None:
            value = socket.default_value
            return tuple(value) if hasattr(value, "__len__") else (float(value),)
        if output.node.type == "GROUP_INPUT" and inside:
            outer = (s for s in inside[-1].inputs if s.identifier == output.identifier)
            socket, inside = next(outer), inside[:-1]
        elif output.node.type in ("VALUE", "RGB"):
            value = output.default_value
            return tuple(value) if hasattr(value, "__len__") else (float(value),)
        else:
            return None


def is_on(shader: Shader, name: str) -> bool:
    """Whether the node has the input, and it may be above 0."""
    if name not in shader[0].inputs:
        return False
    value = constant(shader, name)
    return value is None or max(value[:3]) > 0.0


def textures_of(socket: bpy.types.NodeSocket, inside: Inside) -> Iterator[Shader]:
    """The texture nodes that an input depends on, and the groups around each."""
    if origin(socket, inside) is None:
        return
    for node, _, place in sources(socket, inside):
        if node.type.startswith("TEX_") and node.type != "TEX_COORD":
            yield node, place

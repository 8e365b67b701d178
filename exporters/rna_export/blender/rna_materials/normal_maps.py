"""The normal that a material's surface shader is given, in the tangent frame of its UVs."""

import bpy
import numpy as np
from rna_materials.node_sources import Source, lifted, linked, origin, sources
from rna_materials.uv_render import surface_sources

FLAT = 1.0 / 127.0  # x or y of a normal that a texel cannot tell from 0


def normal_source(material: bpy.types.Material) -> Source | None:
    """Where the first shader's linked normal input comes from; None if no shader has one."""
    for node, _, inside in surface_sources(material):
        socket = node.inputs.get("Normal")
        if node.type.startswith("BSDF_") and socket is not None and linked(socket) is not None:
            source = origin(socket, inside)
            if source is not None:
                return source
    return None


def problem_of(source: Source) -> str | None:
    """The obstacle that keeps a normal from being a map, or None."""
    node, _, inside = source
    before = [node, *(each for s in node.inputs for each, _, _ in sources(s, inside))]
    if any(each.type == "BUMP" for each in before):
        return "a Bump node before other nodes"
    if any(each.type == "NORMAL_MAP" and each.space != "TANGENT" for each in before):
        return "a Normal Map node that is not in tangent space"
    return None


def as_colour(material: bpy.types.Material, source: Source) -> bpy.types.NodeSocket:
    """A socket with (n + 1) / 2, for emission is not negative; the source's groups are copied."""
    tree = material.node_tree
    normal = lifted(tree, source)
    node = tree.nodes.new("ShaderNodeVectorMath")
    node.operation = "MULTIPLY_ADD"
    tree.links.new(normal, node.inputs[0])
    for socket in node.inputs[1:3]:
        socket.default_value = (0.5, 0.5, 0.5)
    return node.outputs[0]


def reduced(values: np.ndarray, side: int) -> np.ndarray:
    """Means over squares of texels, as large as it takes for `side` texels along a side."""
    step = -(-max(values.shape[:2]) // side)
    height, width = (-(-n // step) for n in values.shape[:2])
    grown = np.pad(
        values,
        ((0, height * step - values.shape[0]), (0, width * step - values.shape[1]), (0, 0)),
        mode="wrap",
    )
    return np.asarray(grown.reshape(height, step, width, step, -1).mean(axis=(1, 3)))

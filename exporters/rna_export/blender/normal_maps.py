"""Normal maps of materials, as textures over the UV coordinates.

The normal that a material's surface shader is given is rendered on a unit square, whose tangent is
along u, whose bitangent is up the texture.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
import numpy as np
from uv_render import not_of_uv, rendered, upstream

_FLAT = 1.0 / 127.0  # x or y of a normal that a texel cannot tell from 0


def export_normal_maps(path: str, side: int) -> dict[str, list[str]]:
    """Write an .npz with the maps of all materials that have one, `0`, `1`, ...: (h, w, 2) uint8.

    x and y of the normal are (value - 127) / 127. side: texels along a side, at most. Returns the
    names of the materials, and notes for the user of relief that could not be told.
    """
    found, notes = {}, []
    for material in list(bpy.data.materials):
        if not material.use_nodes:
            continue
        copy = material.copy()
        try:
            texture, note = _map_of(copy, Path(path).parent, side)
        finally:
            bpy.data.materials.remove(copy)
        if note:
            notes.append(
                f"material {material.name!r} has relief by {note}: it is learnt, not mapped"
            )
        if texture is not None:
            found[material.name] = texture
    textures: dict[str, Any] = {str(k): each for k, each in enumerate(found.values())}
    np.savez(path, **textures)
    return {"materials": list(found), "notes": notes}


def _map_of(
    material: bpy.types.Material, folder: Path, side: int
) -> tuple[np.ndarray | None, str | None]:
    """(texture or None, what keeps it from being one or None) of a material that may be changed."""
    tree = material.node_tree
    output = tree.get_output_node("CYCLES") or tree.get_output_node("ALL")
    if output is None or not output.inputs["Surface"].is_linked:
        return None, None
    normal = _normal_socket(output.inputs["Surface"].links[0].from_socket)
    if normal is None:
        return None, None
    nodes = [node for node, _ in upstream(normal)]
    if any(node.type == "BUMP" for node in nodes):
        return None, "a Bump node, whose height needs the size of the surface"
    if any(node.type == "NORMAL_MAP" and node.space != "TANGENT" for node in nodes):
        return None, "a Normal Map node that is not in tangent space"
    if problems := not_of_uv(normal):
        return None, f"{problems[0]}, which is no function of its UV coordinates"
    colour = 2.0 * rendered(material, tree, output, _as_colour(tree, normal), folder) - 1.0
    xy = _reduced(colour[..., :2], side)
    if np.abs(xy).max() < _FLAT:
        return None, None
    return np.round(127.0 + 127.0 * np.clip(xy, -1.0, 1.0)).astype(np.uint8), None


def _normal_socket(surface: bpy.types.NodeSocket) -> bpy.types.NodeSocket | None:
    """Source of the first shader's linked normal input; None if no shader has one."""
    for node, _ in upstream(surface):
        socket = node.inputs.get("Normal")
        if node.type.startswith("BSDF_") and socket is not None and socket.is_linked:
            return socket.links[0].from_socket
    return None


def _as_colour(tree: bpy.types.NodeTree, normal: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    """A socket with (n + 1) / 2: emission is not negative."""
    node = tree.nodes.new("ShaderNodeVectorMath")
    node.operation = "MULTIPLY_ADD"
    tree.links.new(normal, node.inputs[0])
    for socket in node.inputs[1:3]:
        socket.default_value = (0.5, 0.5, 0.5)
    return node.outputs[0]


def _reduced(values: np.ndarray, side: int) -> np.ndarray:
    """Means over squares of texels, as large as it takes for `side` texels along a side."""
    step = -(-max(values.shape[:2]) // side)
    height, width = (-(-n // step) for n in values.shape[:2])
    grown = np.pad(
        values,
        ((0, height * step - values.shape[0]), (0, width * step - values.shape[1]), (0, 0)),
        mode="wrap",
    )
    return np.asarray(grown.reshape(height, step, width, step, -1).mean(axis=(1, 3)))

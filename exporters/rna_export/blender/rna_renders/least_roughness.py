"""A floor for the roughness of materials: the least that Cycles in float32 can light with a sun.

Needs `bpy`.
"""

import bpy
from rna_materials.emission import nodes_of
from rna_materials.node_sources import combined

_ROUGHNESS = {
    "BSDF_PRINCIPLED": ("Roughness", "Coat Roughness"),
    "BSDF_GLOSSY": ("Roughness",),
    "BSDF_METALLIC": ("Roughness",),
}


def keep_above(least: float) -> None:
    """Raise the roughness of all reflecting lobes to `least`, where a texture gives it, too.

    Shaders that refract keep theirs: it blurs what is seen through them.
    """
    for material in bpy.data.materials:
        if least > 0.0 and material.use_nodes:
            for node in list(nodes_of(material.node_tree)):
                if not _refracts(node):
                    for name in _ROUGHNESS.get(node.type, ()):
                        _raise(node.inputs[name], least)


def _refracts(node: bpy.types.Node) -> bool:
    weight = node.inputs.get("Transmission Weight")
    return weight is not None and (weight.is_linked or weight.default_value > 0.0)


def _raise(socket: bpy.types.NodeSocket, least: float) -> None:
    if not socket.is_linked:
        socket.default_value = max(socket.default_value, least)
        return
    tree = socket.id_data
    tree.links.new(combined(tree, "MAXIMUM", socket.links[0].from_socket, least), socket)

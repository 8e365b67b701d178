"""Emissive materials: disabled for transport captures, the only light of emission captures."""

from collections.abc import Iterator

import bpy

_STRENGTH = {"EMISSION": "Strength", "BSDF_PRINCIPLED": "Emission Strength"}
_COLOUR = {"EMISSION": "Color", "BSDF_PRINCIPLED": "Emission Color"}


class Emission:
    """The emission of all materials of the file, which can be switched off and on.

    Attributes:
        materials: names of those that emit.
    """

    def __init__(self) -> None:
        self._sockets = []  # (tree, strength, what it is linked from, its value)
        self.materials = []
        for material in bpy.data.materials:
            if not material.use_nodes:
                continue
            emitters = [node for node in nodes_of(material.node_tree) if emits(node)]
            if emitters:
                self.materials.append(material.name)
            for node in emitters:
                socket = node.inputs[_STRENGTH[node.type]]
                source = socket.links[0].from_socket if socket.is_linked else None
                self._sockets.append((node.id_data, socket, source, socket.default_value))
        self._on = True

    def switch(self, on: bool) -> None:
        """Let the materials emit, or not."""
        if on == self._on:
            return
        self._on = on
        for tree, socket, source, value in self._sockets:
            if on and source is not None:
                tree.links.new(source, socket)
            elif on:
                socket.default_value = value
            else:
                for link in list(socket.links):
                    tree.links.remove(link)
                socket.default_value = 0.0


def nodes_of(tree: bpy.types.NodeTree | None) -> Iterator[bpy.types.Node]:
    """All nodes of a shader, those inside groups too; grease pencil materials have no tree."""
    for node in () if tree is None else tree.nodes:
        if node.type == "GROUP" and node.node_tree is not None:
            yield from nodes_of(node.node_tree)
        yield node


def emits(node: bpy.types.Node) -> bool:
    if node.type not in _STRENGTH:
        return False
    strength, colour = node.inputs[_STRENGTH[node.type]], node.inputs[_COLOUR[node.type]]
    black = not colour.is_linked and max(colour.default_value[:3]) <= 0.0
    return not black and (strength.is_linked or strength.default_value > 0.0)

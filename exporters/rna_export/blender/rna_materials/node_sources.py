"""Which nodes a socket's value comes from: through groups, reroutes and muted nodes."""

from collections.abc import Iterator

import bpy

Inside = tuple[bpy.types.Node, ...]
"""The group nodes around a socket, the outermost first; () in the material's own tree."""

Source = tuple[bpy.types.Node, bpy.types.NodeSocket, Inside]
"""A node, the output of it that is used, and where it lies."""


def linked(socket: bpy.types.NodeSocket) -> bpy.types.NodeSocket | None:
    """The output that an input is linked to within its tree, past reroutes and muted nodes."""
    while True:
        link = next((each for each in socket.links if not each.is_muted), None)
        if link is None:
            return None
        node, output = link.from_node, link.from_socket
        if node.type == "REROUTE":
            socket = node.inputs[0]
        elif node.mute:
            passed = [each.from_socket for each in node.internal_links if each.to_socket == output]
            if not passed:
                return None
            socket = passed[0]
        else:
            return output


def origin(socket: bpy.types.NodeSocket, inside: Inside = ()) -> Source | None:
    """Where an input's value comes from, past groups; None for a value of its own."""
    return _followed(socket, inside)[1]


def own_value(socket: bpy.types.NodeSocket, inside: Inside = ()) -> tuple[float, ...] | None:
    """(r, g, b) of an input without a node before it, past groups; None with one."""
    end, source = _followed(socket, inside)
    if source is not None or end.is_linked or not hasattr(end, "default_value"):
        return None
    value = end.default_value
    return tuple(value[:3]) if hasattr(value, "__len__") else (float(value),) * 3


def _followed(
    socket: bpy.types.NodeSocket, inside: Inside
) -> tuple[bpy.types.NodeSocket, Source | None]:
    """The last input on the way to where a value comes from, past groups, and the source."""
    while True:
        output = linked(socket)
        if output is None:
            return socket, None
        node = output.node
        if node.type == "GROUP" and node.node_tree is not None:
            end = end_of(node.node_tree)
            inputs = () if end is None else end.inputs
            inner = next((s for s in inputs if s.identifier == output.identifier), None)
            if inner is None:
                return socket, None
            socket, inside = inner, (*inside, node)
        elif node.type == "GROUP_INPUT" and inside:
            outer = (s for s in inside[-1].inputs if s.identifier == output.identifier)
            source = next(outer, None)
            if source is None:
                return socket, None
            socket, inside = source, inside[:-1]
        else:
            return socket, (node, output, inside)


def sources(socket: bpy.types.NodeSocket, inside: Inside = ()) -> Iterator[Source]:
    """Every node that an input depends on, once for each of its outputs that is used."""
    seen, todo = set(), [(socket, inside)]
    while todo:
        source = origin(*todo.pop())
        if source is None:
            continue
        node, output, inside = source
        key = (node, output.identifier, inside)
        if key in seen:
            continue
        seen.add(key)
        yield source
        todo += [(each, inside) for each in node.inputs]


def lifted(tree: bpy.types.NodeTree, source: Source) -> bpy.types.NodeSocket:
    """A socket of `tree` with the value of a source inside its groups, which become copies."""
    node, output, inside = source
    groups = []
    for each in inside:
        group = tree.nodes[each.name]
        tree = group.node_tree = group.node_tree.copy()
        groups.append(group)
    socket = next(s for s in tree.nodes[node.name].outputs if s.identifier == output.identifier)
    for group in reversed(groups):
        socket = as_output(group, socket)
    return socket


def as_output(group: bpy.types.Node, inner: bpy.types.NodeSocket) -> bpy.types.NodeSocket:
    """A socket inside a group node's own tree, as one more output of the node."""
    tree = group.node_tree
    kind = {"in_out": "OUTPUT", "socket_type": "NodeSocketColor"}
    made = tree.interface.new_socket("rna value", **kind)
    end = end_of(tree)
    assert end is not None  # what lies inside has reached it
    tree.links.new(inner, end.inputs[made.identifier])
    return group.outputs[made.identifier]


def end_of(tree: bpy.types.NodeTree) -> bpy.types.Node | None:
    """The node that a group's outputs come from."""
    ends = [node for node in tree.nodes if node.type == "GROUP_OUTPUT"]
    return next((node for node in ends if node.is_active_output), None)


def combined(
    tree: bpy.types.NodeTree,
    operation: str,
    a: bpy.types.NodeSocket,
    b: bpy.types.NodeSocket | float,
    kind: str = "ShaderNodeMath",
) -> bpy.types.NodeSocket:
    """Output of a new math node of a tree; kind: "ShaderNodeVectorMath" for colours."""
    node = tree.nodes.new(kind)
    node.operation = operation
    tree.links.new(a, node.inputs[0])
    if isinstance(b, float):
        node.inputs[1].default_value = b
    else:
        tree.links.new(b, node.inputs[1])
    return node.outputs[0]

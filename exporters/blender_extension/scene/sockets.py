"""Input of a shader's socket: a value, or a channel of an image."""

from dataclasses import dataclass

_CHANNELS = {"Red": 0, "Green": 1, "Blue": 2, "Color": None, "Alpha": 3}


@dataclass(frozen=True)
class Channel:
    """An image, or one channel of it (None: all colours)."""

    image: object
    index: int | None
    node: object


def follow(socket):
    """The `Channel` that feeds a socket, its constant value, or None for anything else."""
    if not socket.is_linked:
        value = socket.default_value
        return list(value) if hasattr(value, "__len__") else value
    link = socket.links[0]
    node = link.from_node
    if node.type == "REROUTE":
        return follow(node.inputs[0])
    if node.type in ("RGB", "VALUE"):
        value = node.outputs[0].default_value
        return list(value) if hasattr(value, "__len__") else value
    if node.type == "TEX_IMAGE" and node.image is not None:
        return Channel(node.image, _CHANNELS.get(link.from_socket.name), node)
    if node.type in ("SEPARATE_COLOR", "SEPRGB"):
        inside = follow(node.inputs[0])
        if isinstance(inside, Channel) and inside.index is None:
            return Channel(inside.image, _CHANNELS.get(link.from_socket.name), inside.node)
    return None


def cut_off(socket):
    """The channel and the threshold of a cut-out that feeds a socket; None for anything else.

    It is `alpha > t`, or `1 - (alpha < t)`, as Blender's importer of glTF makes it.
    """
    if not socket.is_linked:
        return None
    node = socket.links[0].from_node
    if node.type != "MATH":
        return None
    if node.operation == "SUBTRACT" and follow(node.inputs[0]) == 1.0:
        inner = node.inputs[1].links[0].from_node if node.inputs[1].is_linked else None
        return _threshold(inner, "LESS_THAN")
    return _threshold(node, "GREATER_THAN")


def _threshold(node, operation):
    if node is None or node.type != "MATH" or node.operation != operation:
        return None
    channel, limit = follow(node.inputs[0]), follow(node.inputs[1])
    return (channel, limit) if isinstance(channel, Channel) and isinstance(limit, float) else None

"""Inputs of a colour of a material's nodes: texture coordinates, attributes, images."""

from collections.abc import Iterable
from dataclasses import dataclass, field

import bpy
import mathutils
import numpy as np
from rna_materials.node_sources import Inside, Source, origin
from rna_materials.udim_tiles import is_tiled, size_of

IDENTITY = np.eye(2, 3)
"""A map of texture coordinates: (2, 3), of (u, v, 1)."""

_OUTSIDE_UV = {  # nodes whose values are no function of the UV coordinates, by the socket used
    "TEX_COORD": ("Generated", "Normal", "Object", "Camera", "Window", "Reflection"),
    "NEW_GEOMETRY": None,
    "OBJECT_INFO": None,
    "PARTICLE_INFO": None,
    "HAIR_INFO": None,
    "CAMERA": None,
    "LIGHT_PATH": None,
    "LAYER_WEIGHT": None,
    "FRESNEL": None,
    "VOLUME_INFO": None,
    "POINT_INFO": None,
    "TANGENT": None,
    "AMBIENT_OCCLUSION": None,
    "BEVEL": None,
    "WIREFRAME": None,
    "SCRIPT": None,
}
_COLOUR, _ALPHA = (0, 1, 2), (3,)  # components of an attribute


@dataclass
class ImageUse:
    """An image texture: the map from UV to its own coordinates, its texels and form."""

    mapping: np.ndarray
    size: tuple[int, int]
    extension: str  # as in Blender; "TILED" for UDIM


@dataclass
class Dependence:
    """Inputs that the value of sockets depends on.

    problems: nodes whose values no texture over UV coordinates has. layers: names of UV maps, ""
    for the one that renders use by default. attributes: their components, by name; "" for the
    default colour. patterns: whether there are textures without an image.
    """

    problems: list[str] = field(default_factory=list)
    layers: set[str] = field(default_factory=set)
    attributes: dict[str, set[int]] = field(default_factory=dict)
    images: list[ImageUse] = field(default_factory=list)
    patterns: bool = False


def dependence(sources: Iterable[Source]) -> Dependence:
    """Dependence of a value on all nodes before these sources."""
    result = Dependence()
    for node, output, inside in sources:
        if node.type in _OUTSIDE_UV and output.name in (_OUTSIDE_UV[node.type] or (output.name,)):
            result.problems.append(f"the node {node.bl_label!r}")
        elif getattr(node, "from_instancer", False):
            result.problems.append(f"the node {node.bl_label!r} of the instancer")
        elif node.type == "TEX_COORD":
            result.layers.add("")
        elif node.type in ("UVMAP", "NORMAL_MAP"):
            result.layers.add(node.uv_map)
        elif node.type == "VERTEX_COLOR":
            used = _ALPHA if output.name == "Alpha" else _COLOUR
            result.attributes.setdefault(node.layer_name, set()).update(used)
        elif node.type == "ATTRIBUTE":
            _add_attribute(result, node, output)
        elif node.type.startswith("TEX_"):
            _add_texture(result, node, inside)
    return result


def _add_attribute(result: Dependence, node: bpy.types.Node, output: bpy.types.NodeSocket) -> None:
    if node.attribute_type != "GEOMETRY":
        result.problems.append(f"the node {node.bl_label!r} ({node.attribute_type.lower()})")
    elif node.attribute_name:
        used = _ALPHA if output.name == "Alpha" else _COLOUR
        result.attributes.setdefault(node.attribute_name, set()).update(used)


def _add_texture(result: Dependence, node: bpy.types.Node, inside: Inside) -> None:
    vector = node.inputs.get("Vector")
    is_free = vector is not None and vector.enabled and origin(vector, inside) is None
    if node.type == "TEX_IMAGE":
        if node.projection == "BOX":
            result.problems.append(f"the box projection of the node {node.bl_label!r}")
        if is_free:
            result.layers.add("")
        if node.image is not None:
            extension = "TILED" if is_tiled(node) else node.extension
            image = ImageUse(_mapping(node, inside), size_of(node.image), extension)
            result.images.append(image)
        return
    result.patterns = True
    if is_free and node.type != "TEX_WHITE_NOISE":
        result.problems.append(f"the node {node.bl_label!r} without texture coordinates")


def _mapping(image: bpy.types.Node, inside: Inside) -> np.ndarray:
    """(2, 3) from UV coordinates to those of an image node, where simple nodes lie between.

    The identity where others do: then it is only a guess.
    """
    result = np.eye(3)
    socket = image.inputs["Vector"]
    while (source := origin(socket, inside)) is not None:
        node, _, inside = source
        step = _step(node, inside)
        if step is None:
            return result[:2] if node.type in ("UVMAP", "TEX_COORD", "ATTRIBUTE") else IDENTITY
        matrix, socket = step
        result = result @ matrix
    return result[:2]


def _step(node: bpy.types.Node, inside: Inside) -> tuple[np.ndarray, bpy.types.NodeSocket] | None:
    """The affine map (3, 3) of a node, and the input that it maps; None for any other node."""
    if node.type == "MAPPING":
        names = ("Rotation", "Scale", "Location")
        rotation, scale, location = (_constant(node.inputs.get(n), inside) for n in names)
        if node.vector_type in ("POINT", "TEXTURE", "VECTOR") and rotation is not None:
            matrix = _mapping_matrix(node.vector_type, rotation, scale, location)
            return None if matrix is None else (matrix, node.inputs["Vector"])
    if node.type == "VECT_MATH" and node.operation in ("ADD", "SUBTRACT", "MULTIPLY", "SCALE"):
        other = node.inputs["Scale"] if node.operation == "SCALE" else node.inputs[1]
        value = _constant(other, inside)
        if value is None:
            return None
        matrix = np.eye(3)
        if node.operation in ("ADD", "SUBTRACT"):
            matrix[:2, 2] = value[:2] if node.operation == "ADD" else -value[:2]
        else:
            matrix[0, 0], matrix[1, 1] = value[:2]
        return matrix, node.inputs[0]
    return None


def _mapping_matrix(
    kind: str, rotation: np.ndarray, scale: np.ndarray | None, location: np.ndarray | None
) -> np.ndarray | None:
    if kind == "VECTOR":
        location = np.zeros(3)
    if scale is None or location is None:
        return None
    turn = np.array(mathutils.Euler(rotation, "XYZ").to_matrix())
    matrix = np.eye(3)
    if kind == "TEXTURE":
        if np.any(scale[:2] == 0.0):
            return None
        inverse = np.diag(1.0 / np.where(scale == 0.0, 1.0, scale)) @ turn.T
        matrix[:2, :2], matrix[:2, 2] = inverse[:2, :2], -(inverse @ location)[:2]
        return matrix
    matrix[:2, :2], matrix[:2, 2] = (turn @ np.diag(scale))[:2, :2], location[:2]
    return matrix


def _constant(socket: bpy.types.NodeSocket | None, inside: Inside) -> np.ndarray | None:
    """(3,) the value of an input without a link; None of another."""
    if socket is None or origin(socket, inside) is not None or socket.is_linked:
        return None
    value = socket.default_value
    return np.array(value if hasattr(value, "__len__") else [value] * 3, np.float64)[:3]

"""Meshes of glTF 2.0 files, with the whole hierarchy of nodes baked into them."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from rna_render.materials.files.gltf_materials import GltfMaterials
from rna_render.materials.files.mesh_parts import MeshFile, Part, check_mesh_size
from rna_render.materials.material import Material
from rna_render.scene.gltf_container import GltfContainer, open_gltf
from rna_render.scene.gltf_nodes import PACKAGE, placed_nodes
from rna_sdk.commands.gltf_remedies import with_remedy

# Section 3.7.2.1: modes of primitives.
TRIANGLES, STRIP, FAN = 4, 5, 6

# Section 3.7.2.1: attributes of vertices that are read.
WIDTHS_OF_ATTRIBUTES = {"POSITION": 3, "NORMAL": 3, "TANGENT": 4, "TEXCOORD_0": 2, "TEXCOORD_1": 2}

# Extensions that a file may require of its reader. Those of materials may be left out of the look.
KNOWN_EXTENSIONS = {"KHR_mesh_quantization", "KHR_texture_transform", "EXT_texture_webp"}


def read_gltf(path: Path, with_materials: bool, fallbacks: bool = True) -> MeshFile:
    """The parts of a .gltf or .glb file, in the world of its scene.

    with_materials: whether to read its own; else all parts have material 0, which is a
    stand-in. fallbacks: whether those of packages are shown. Raises SceneError for files beside it
    that cannot be read, and whatever Python raises for a file that is not valid.
    """
    container = open_gltf(path)
    required = set(container.json.get("extensionsRequired", ())) - KNOWN_EXTENSIONS
    required = {name for name in required if not name.startswith("KHR_materials_")}
    if required:
        names = ", ".join(sorted(required))
        raise ValueError(with_remedy(f"it requires an extension that is not known: {names}"))
    left_out: set[str] = set()
    primitives = list(_primitives(container, left_out, fallbacks))
    _check_size(container, primitives)
    if not with_materials:
        parts = [replace(_part(container, *item, 0), colors=None) for item in primitives]
        return MeshFile(parts, [Material()], sorted(left_out))
    used = dict.fromkeys(data.get("material") for _, data in primitives)
    materials = GltfMaterials(container)
    read = materials.read(used)
    places = {number: place for place, number in enumerate(read)}
    parts = [_part(container, *item, places[item[1].get("material")]) for item in primitives]
    return MeshFile(parts, list(read.values()), sorted(left_out | materials.left_out))


def _primitives(
    container: GltfContainer, left_out: set[str], fallbacks: bool
) -> Iterator[tuple[np.ndarray, dict[str, Any]]]:
    """Primitives of triangles in the scene, each with a (4, 4) matrix to the world."""
    for placed in placed_nodes(container, fallbacks):
        node = placed.node
        if placed.has_package:
            if not fallbacks:
                continue
            left_out.add(PACKAGE)
        if "mesh" not in node:
            continue
        mesh = container.json["meshes"][node["mesh"]]
        if "skin" in node or any(node.get("weights", mesh.get("weights", ()))):
            left_out.add("skins and morph targets")
        for primitive in triangle_primitives(mesh, left_out):
            for matrix in placed.matrices:
                yield matrix, primitive


def triangle_primitives(mesh: dict[str, Any], left_out: set[str]) -> Iterator[dict[str, Any]]:
    """The primitives of a mesh that are triangles with positions."""
    for primitive in mesh["primitives"]:
        if primitive.get("mode", TRIANGLES) not in (TRIANGLES, STRIP, FAN):
            left_out.add("points and lines")
        elif "POSITION" not in primitive["attributes"]:
            left_out.add("primitives without POSITION")
        else:
            yield primitive


def _check_size(
    container: GltfContainer, primitives: list[tuple[np.ndarray, dict[str, Any]]]
) -> None:
    """Refuses a mesh that is too large once its nodes are baked, before any of it is."""
    vertices, corners = 0, 0
    for _, data in primitives:
        vertices += container.count(data["attributes"]["POSITION"])
        corners += corner_count(container, data)
    check_mesh_size(vertices, corners // 3)


def _part(
    container: GltfContainer, matrix: np.ndarray, data: dict[str, Any], material: int
) -> Part:
    """A primitive in the world."""
    attributes = data["attributes"]
    count = container.count(attributes["POSITION"])
    vectors = {
        name: vertex_values(container, attributes[name], (count, width))
        for name, width in WIDTHS_OF_ATTRIBUTES.items()
        if name in attributes
    }
    positions, normals, tangents = (
        vectors["POSITION"],
        vectors.get("NORMAL"),
        vectors.get("TANGENT"),
    )
    triangles = triangles_of(container, data, count)
    linear = matrix[:3, :3]
    mirrored = np.linalg.det(linear) < 0
    if mirrored:  # section 3.7.4: the winding turns with it
        triangles = triangles[:, ::-1]
    if normals is not None:
        normals = normals @ _cofactors(linear).T * (-1.0 if mirrored else 1.0)
    if tangents is not None:
        sign = tangents[:, 3:] * (-1.0 if mirrored else 1.0)
        tangents = np.column_stack([tangents[:, :3] @ linear.T, sign])
    positions = positions @ linear.T + matrix[:3, 3]
    uvs, second_uvs = vectors.get("TEXCOORD_0"), vectors.get("TEXCOORD_1")
    colors = None
    if "COLOR_0" in attributes:  # of the alpha that it may have, only 1 is usual
        colors = container.accessor(attributes["COLOR_0"])[:, :3]
    return Part(positions, normals, uvs, triangles, material, second_uvs, tangents, colors)


def _cofactors(matrix: np.ndarray) -> np.ndarray:
    """The inverse transpose times the determinant, which singular matrices have too."""
    x, y, z = matrix
    return np.array([np.cross(y, z), np.cross(z, x), np.cross(x, y)])


def vertex_values(container: GltfContainer, number: int, shape: tuple[int, int]) -> np.ndarray:
    """An attribute of vertices as float64; ValueError if it has not this shape."""
    values = container.accessor(number)
    if values.shape != shape:
        raise ValueError(f"an attribute has shape {values.shape}, not {shape}")
    return values.astype(np.float64)


def corner_count(container: GltfContainer, data: dict[str, Any]) -> int:
    """Corners of a primitive's triangles, as the file says."""
    return container.count(data.get("indices", data["attributes"]["POSITION"]))


def triangles_of(container: GltfContainer, data: dict[str, Any], count: int) -> np.ndarray:
    """The triangles of a primitive with so many vertices: (t, 3) int64."""
    corners, mode = np.arange(count), data.get("mode", TRIANGLES)
    if "indices" in data:
        numbers = container.accessor(data["indices"])[:, 0]
        if numbers.dtype.kind != "u":  # a float may be no number at all
            raise ValueError(f"indices are of type {numbers.dtype}, not unsigned integers")
        corners = numbers.astype(np.int64)
    if mode == TRIANGLES:
        return corners.reshape(-1, 3)
    first, second, third = corners[:-2], corners[1:-1], corners[2:]
    if mode == FAN:
        return np.stack([second, third, np.broadcast_to(corners[0], third.shape)], axis=1)
    odd = np.arange(len(third)) % 2 == 1
    return np.stack([first, np.where(odd, third, second), np.where(odd, second, third)], axis=1)

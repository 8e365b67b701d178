"""Nodes of a glTF 2.0 file: where the scene that it shows first has them."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from rna_render.scene.gltf_container import GltfContainer
from rna_render.scene.limits import MAX_INSTANCES, MAX_NUMBER
from rna_render.scene.transforms import quaternion_rotation

INSTANCING = "EXT_mesh_gpu_instancing"
PACKAGE = "RNA_relightable_asset"

_ROUNDING = 1e-6
_MEMBERS = {"TRANSLATION": "translation", "ROTATION": "rotation", "SCALE": "scale"}


class PlacedNode(NamedTuple):
    """A node, and (k, 4, 4) float64 matrices to the world: of its k instances, mostly one."""

    node: dict[str, Any]
    matrices: np.ndarray

    @property
    def has_package(self) -> bool:
        """Whether it carries a package: its mesh and all nodes below it are the fallback."""
        return PACKAGE in self.node.get("extensions", {})


def placed_nodes(container: GltfContainer, fallbacks: bool = True) -> Iterator[PlacedNode]:
    """The nodes of the default scene, each before its children.

    fallbacks: whether the nodes below a package are among them. Raises whatever Python raises
    for a document that is not valid.
    """
    seen = set()
    stack = [(np.eye(4), root) for root in reversed(roots(container))]
    while stack:
        world_from_parent, number = stack.pop()
        if number in seen:
            raise ValueError(f"node {number} is in its scene twice")
        seen.add(number)
        node = container.item("nodes", number)
        matrix = world_from_parent @ local_matrix(node)
        placed = PlacedNode(node, matrix @ _instances(container, node))
        if fallbacks or not placed.has_package:
            stack += [(matrix, child) for child in reversed(node.get("children", ()))]
        yield placed


def roots(container: GltfContainer) -> list[int]:
    """The root nodes of the default scene, or of the file if it has no scenes."""
    document = container.json
    if "scenes" in document:
        return list(container.item("scenes", document.get("scene", 0)).get("nodes", ()))
    nodes = document.get("nodes", [])
    children = {child for node in nodes for child in node.get("children", ())}
    return [number for number in range(len(nodes)) if number not in children]


def local_matrix(node: dict[str, Any]) -> np.ndarray:
    """Section 3.5.3: a column-major matrix, or translation * rotation * scale."""
    if "matrix" in node:
        matrix = np.array(node["matrix"], np.float64).reshape(4, 4).T
        if np.abs(matrix[3] - (0, 0, 0, 1)).max() > _ROUNDING:
            raise ValueError(f"a node's matrix ends with {matrix[3].tolist()}; expected 0, 0, 0, 1")
        return _finite(matrix)
    rotation = quaternion_rotation(node.get("rotation", (0.0, 0.0, 0.0, 1.0)))
    matrix = np.eye(4)
    matrix[:3, :3] = rotation * np.array(node.get("scale", (1, 1, 1)), np.float64)
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return _finite(matrix)


def _finite(matrix: np.ndarray) -> np.ndarray:
    if not (np.abs(matrix) <= MAX_NUMBER).all():
        raise ValueError(f"a node's transform has numbers that are not at most {MAX_NUMBER:g}")
    return matrix


def _instances(container: GltfContainer, node: dict[str, Any]) -> np.ndarray:
    """EXT_mesh_gpu_instancing: (k, 4, 4) to the node's space, for its mesh and its package."""
    attributes = node.get("extensions", {}).get(INSTANCING, {}).get("attributes", {})
    if not attributes:
        return np.eye(4)[None]
    counts = {container.count(number) for number in attributes.values()}
    if len(counts) != 1 or max(counts) > MAX_INSTANCES:
        raise ValueError(
            f"{INSTANCING} has attributes of {sorted(counts)} items; expected one number, at most "
            f"{MAX_INSTANCES}"
        )
    values = {
        member: container.accessor(attributes[name]).tolist()
        for name, member in _MEMBERS.items()
        if name in attributes
    }
    if not values:
        return np.broadcast_to(np.eye(4), (*counts, 4, 4))
    rows = zip(*values.values(), strict=True)
    return np.reshape(
        [local_matrix(dict(zip(values, row, strict=True))) for row in rows], (-1, 4, 4)
    )

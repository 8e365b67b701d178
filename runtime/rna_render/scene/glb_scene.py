"""A .glb that carries a package, in a scene: the nodes that show it, and the other meshes."""

from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from rna_render.scene.gltf_container import GltfContainer, open_gltf, reason_of
from rna_render.scene.gltf_nodes import PlacedNode, placed_nodes
from rna_render.scene.model_base import TransformModel
from rna_render.scene.scene_model import AssetModel, ObjectModel
from rna_render.scene.transforms import as_transform, world_from_object
from rna_sdk.errors import SceneError
from rna_sdk.files.file_kinds import kind_of
from rna_sdk.package import Package


class GlbScene(NamedTuple):
    """Places in the space of the file.

    packages: (k, 4, 4) float64, from the package's space. beside: (m, 3) float64, corners of boxes
    about the meshes that are no fallback.
    """

    packages: np.ndarray
    beside: np.ndarray


def is_glb_scene(path: Path) -> bool:
    """Whether a file is a .glb that carries a package."""
    return path.suffix.lower() == ".glb" and kind_of(path) == "package"


def read_glb_scene(path: Path) -> GlbScene:
    """The scene of a .glb that carries a package.

    Raises PackageError for a broken package, SceneError for broken nodes.
    """
    Package.open(path).close()
    packages, beside = [np.zeros((0, 4, 4))], [np.zeros((0, 3))]
    try:
        container = open_gltf(path)
        for placed in placed_nodes(container, fallbacks=False):
            if placed.has_package:
                packages.append(placed.matrices)
            else:
                beside += _boxes(container, placed)
    except Exception as error:  # whatever a broken file makes Python raise
        raise SceneError(f"it cannot be read as .glb: {reason_of(error)}", file=path) from error
    places = np.concatenate(packages)
    if not len(places):
        raise SceneError("no node of its scene carries the package", file=path)
    return GlbScene(places, np.concatenate(beside))


def box_corners(low: ArrayLike, high: ArrayLike) -> np.ndarray:
    """(8, 3) float64 corners of the box between (3,) corners."""
    sides = np.stack([low, high], axis=1).astype(np.float64)
    return np.stack(np.meshgrid(*sides), axis=-1).reshape(8, 3)


def as_transforms(
    places: np.ndarray, path: Path, outer: TransformModel | None = None
) -> list[TransformModel]:
    """The transforms of places in a .glb, inside an outer one.

    Raises SceneError for a place that shears the package, or scales it unevenly.
    """
    outer = outer or TransformModel()
    world_from_file = world_from_object(outer)
    try:
        return [
            outer if np.array_equal(place, np.eye(4)) else as_transform(world_from_file @ place)
            for place in places
        ]
    except ValueError as error:
        raise SceneError(f"a node with the package: {error}", file=path) from error


def _boxes(container: GltfContainer, placed: PlacedNode) -> list[np.ndarray]:
    """For each primitive of a node and each of its instances, (8, 3) corners about it."""
    if "mesh" not in placed.node:
        return []
    document, boxes = container.json, []
    for primitive in document["meshes"][placed.node["mesh"]]["primitives"]:
        accessor = document["accessors"][primitive["attributes"]["POSITION"]]
        corners = box_corners(accessor["min"], accessor["max"])
        for matrix in placed.matrices:
            boxes.append(corners @ matrix[:3, :3].T + matrix[:3, 3])
    return boxes


def expanded(asset: AssetModel, path: Path) -> tuple[list[AssetModel], list[ObjectModel]]:
    """The contents of an entry of a scene: an asset for each place in a .glb, and its other meshes.

    path: of the asset, as it can be opened. Raises PackageError and SceneError, as
    `read_glb_scene` and `as_transforms`.
    """
    if asset.alone or not is_glb_scene(path):
        return [asset], []
    places = read_glb_scene(path)
    assets = [
        asset.model_copy(update={"alone": True, "transform": transform})
        for transform in as_transforms(places.packages, path, asset.transform)
    ]
    beside = ObjectModel(path=asset.path, transform=asset.transform, fallbacks=False)
    return assets, [beside] if len(places.beside) else []

"""A renderer scene for the Cycles worker, with the original in place of the asset.

The description is JSON in the renderer's own space, +Y up:

- `assets`: 4 x 4 matrices, one for each instance of the original;
- `meshes`: `positions`, `triangles` and the Lambertian `color` of each object, the ground too;
- `lights`: what the scene file says of them, with the paths of images resolved;
- `bounces`: how often light may scatter, or null for what the source itself sets.
"""

from pathlib import Path
from typing import Any

import numpy as np

from rna_render import MeshObject, ground, read_mesh_object
from rna_render.scene import DiffuseModel, MaterialModel, Scene, world_from_object
from rna_sdk.errors import SceneError

_Placed = tuple[MeshObject, np.ndarray, tuple[float, ...]]
"""A mesh, world from object and its colour."""


def cycles_scene(scene: Scene, bounces: int | None = None) -> dict[str, Any]:
    """The description that `BlenderWorker.render_scene` takes.

    scene: with resolved paths. Raises SceneError for what has no twin in Blender:
    assets of several packages, a scaled one (Cycles does not scale the depth of subsurface
    scattering), objects and grounds that are not of one diffuse colour, spheres that shine.
    """
    assets, objects = _assets(scene), _objects(scene)
    meshes = [*objects, *_ground(scene)]
    return {
        "assets": [matrix.tolist() for matrix in assets],
        "meshes": [_described(*mesh) for mesh in meshes],
        "lights": [_light(model.model_dump(mode="json")) for model in scene.lights],
        "bounces": bounces,
    }


def _assets(scene: Scene) -> list[np.ndarray]:
    """World from object, (4, 4), of each."""
    packages = {asset.path for asset in scene.assets}
    if len(packages) > 1:
        raise SceneError(f"found {len(packages)} packages; the Cycles comparison supports one")
    for transform in (asset.transform for asset in scene.assets):
        if transform.scale != 1.0:
            raise SceneError(
                f"found asset scale {transform.scale:g}; the Cycles comparison supports scale 1"
            )
    return [world_from_object(asset.transform) for asset in scene.assets]


def _objects(scene: Scene) -> list[_Placed]:
    meshes = []
    for model in scene.objects:
        colour = _colour(model.material)
        mesh = read_mesh_object(model.path, model.material, model.fallbacks)
        meshes.append((mesh, world_from_object(model.transform), colour))
    return meshes


def _ground(scene: Scene) -> list[_Placed]:
    """The ground as `rna-run` lays it."""
    if scene.ground is None:
        return []
    place = np.eye(4)
    place[:3, 3] = scene.camera.position
    return [(ground(scene.ground, scene.camera), place, _colour(scene.ground.material))]


def _described(mesh: MeshObject, matrix: np.ndarray, colour: tuple[float, ...]) -> dict[str, Any]:
    """World space, without its normals: Cycles shades it flat."""
    positions = mesh.positions @ matrix[:3, :3].T + matrix[:3, 3]
    return {
        "positions": positions.tolist(),
        "triangles": mesh.triangles.tolist(),
        "color": list(colour),
    }


def _colour(material: MaterialModel | None) -> tuple[float, ...]:
    if not isinstance(material, DiffuseModel) or material.texture or any(material.emission):
        raise SceneError(
            "the Cycles comparison supports only objects of one diffuse colour without emission"
        )
    return material.color


def _light(light: dict[str, Any]) -> dict[str, Any]:
    if light["type"] == "sphere":
        raise SceneError("the Cycles comparison does not support sphere lights")
    if light.get("path"):
        light["path"] = str(Path(light["path"]).resolve())
    return light

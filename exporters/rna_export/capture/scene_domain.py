"""The view and light directions that a scene uses on an asset."""

from collections.abc import Iterator

import numpy as np

from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.capture.rays.cones import EVERYWHERE, Cap, cap_towards, merged
from rna_render.scene import (
    AssetModel,
    DirectionalModel,
    EnvironmentModel,
    GroundModel,
    LightModel,
    MaterialModel,
    ObjectModel,
    Scene,
    SceneFile,
    frame_scene,
    world_from_object,
)
from rna_sdk.errors import CaptureError
from rna_sdk.package import Domain
from rna_sdk.runtime import Transform

# Added to every cone: a fit is worst at the edge of what it knows.
MARGIN = np.radians(3.0)


def scene_domain(scene_file: SceneFile, name: str, asset: AssetScene) -> Domain:
    """Views and lights of the asset's instances in the scene, in all frames of its animation.

    name: the package's, without `.rna`. Where other objects scatter light, it goes to and
    comes from everywhere, unless `max_depth` is 1. Raises `CaptureError` if no instance is in the
    scene.
    """
    scene = scene_file.scene
    instances = _instances(scene_file, name)
    frames = range(scene.animation.frames if scene.animation is not None else 1)
    views: list[Cap] = []
    lights: list[Cap] = []
    scattered = scene.max_depth > 1 and _has_other_scatterers(scene)
    if scattered or _has_emitters(scene):
        lights.append(EVERYWHERE)
    if scattered:
        views.append(EVERYWHERE)
    for frame in (frame_scene(scene, number) for number in frames):
        for instance in instances:
            seen = _Instance(instance, asset)
            views.append(seen.towards(np.array(frame.camera.position), 0.0))
            lights += (seen.lit_by(light) for light in frame.lights)
    return Domain(wo=merged(views, MARGIN), wi=merged(lights, MARGIN))


class _Instance:
    """An asset of the scene: its bounding sphere, and the way to its object space."""

    def __init__(self, model: AssetModel, asset: AssetScene) -> None:
        self._transform = Transform(world_from_object(model.transform))
        self._centre, self._radius = asset.centre.astype(np.float64), asset.radius

    def towards(self, position_world: np.ndarray, radius_world: float) -> Cap:
        """Directions from the asset to a sphere in the world."""
        matrix, scale = self._transform.matrix, self._transform.scale
        position = np.linalg.solve(matrix[:3, :3], position_world - matrix[:3, 3])
        return cap_towards(position - self._centre, self._radius + radius_world / scale)

    def lit_by(self, light: LightModel) -> Cap:
        """Directions from the asset to a light."""
        if isinstance(light, EnvironmentModel):
            return EVERYWHERE
        if isinstance(light, DirectionalModel):
            rotation = self._transform.matrix[:3, :3] / self._transform.scale
            axis = rotation.T @ np.array(light.direction)
            return Cap(axis / np.linalg.norm(axis), np.radians(light.angular_diameter_deg / 2.0))
        return self.towards(np.array(light.position), light.bounding_radius)


def _instances(scene_file: SceneFile, name: str) -> list[AssetModel]:
    assets = scene_file.scene.assets
    paths = {asset.path for asset in assets}
    chosen = [asset for asset in assets if asset.path.stem == name or len(paths) == 1]
    if not chosen:
        found = ", ".join(sorted(map(str, paths))) or "none"
        raise CaptureError(
            f"{scene_file.path}: found assets {found}; expected one of {name}.rna, "
            "as the dataset is named"
        )
    return chosen


def _has_other_scatterers(scene: Scene) -> bool:
    materials = list(_materials(scene))
    caught = [m is not None and m.type == "shadow_catcher" for m in materials]
    return len(scene.assets) > 1 or not all(caught)


def _has_emitters(scene: Scene) -> bool:
    """Whether a mesh shines; one with materials of its own may."""
    return any(
        material is None or any(getattr(material, "emission", ())) for material in _materials(scene)
    )


def _materials(scene: Scene) -> Iterator[MaterialModel | None]:
    """Materials of the ground and the objects; None for an object's own."""
    scene_objects: list[GroundModel | ObjectModel] = [*scene.objects]
    scene_objects += [scene.ground] if scene.ground is not None else []
    return (scene_object.material for scene_object in scene_objects)

"""A scene file as the viewer shows it: its first asset, its camera, suns and environment."""

from pathlib import Path
from typing import Any

import numpy as np

from rna_render import read_environment
from rna_render.scene import DirectionalModel, EnvironmentModel, ObjectModel, SceneFile, read_scene
from rna_sdk.errors import PackageError, SceneError, ViewError
from rna_sdk.files.file_kinds import glass_of
from rna_view.site_files import Site


def scene_site(path: Path) -> Site:
    """The page for a scene; `notes` name omitted things, and files of other folders.

    A scene file may be a stranger's: what it names becomes public with the page, so only packages
    and images do. Raises SceneError, with the key, for a file that is neither.
    """
    scene_file = read_scene(path)
    scene = scene_file.scene
    if not scene.assets:
        raise ViewError(f"{path}: the scene has no asset")
    site = Site()
    asset = _add_asset(scene_file, site)
    glass = _add_glass(scene_file, site)
    site.notes.extend(_left_out(scene_file, glass))
    if scene.assets[0].tier is not None:
        site.attributes["tier"] = scene.assets[0].tier
    _add_print(scene_file, site)
    record = {
        "asset": asset,
        "camera": {
            "position": scene.camera.position,
            "look_at": scene.camera.look_at,
            "vertical_fov_deg": scene.camera.vertical_fov_deg,
        },
        "suns": [_sun(light) for light in scene.lights if isinstance(light, DirectionalModel)],
        "environment": _environment(scene_file, site),
        "ground": scene.ground is not None,
        "exposure": scene.exposure,
        "view": scene.view,
    }
    site.attributes["scene"] = site.add_scene(record)
    return site


def _add_asset(scene_file: SceneFile, site: Site) -> str:
    """The name in the page of the scene's first asset."""
    path = scene_file.resolved.assets[0].path
    scene_file.check(("assets", 0, "path"), path)
    _note_if_outside(scene_file, path, site)
    try:
        return site.add_package(path)
    except PackageError as error:
        raise scene_file.error(("assets", 0, "path"), str(error)) from error


def _add_glass(scene_file: SceneFile, site: Site) -> ObjectModel | None:
    """The object that is the smooth glass of the first asset, where that is; None for none."""
    scene, beside = scene_file.scene, glass_of(scene_file.resolved.assets[0].path)
    for index, model in enumerate(scene.objects):
        stands_there = model.transform == scene.assets[0].transform and model.material is None
        if scene_file.resolve(model.path) != beside or not stands_there:
            continue
        try:
            site.add_glass(beside)
        except (OSError, ViewError) as error:
            raise scene_file.error(("objects", index, "path"), str(error)) from error
        return model
    return None


def _add_print(scene_file: SceneFile, site: Site) -> None:
    """Variant, maps and tint of the scene's first asset."""
    model = scene_file.scene.assets[0]
    if model.variant is not None:
        site.attributes["variant-name"] = model.variant
    if model.tint != (1.0, 1.0, 1.0):
        site.attributes["tint"] = " ".join(f"{value:.9g}" for value in model.tint)
    for label, given in model.maps.items():
        path = scene_file.resolve(given)
        _note_if_outside(scene_file, path, site)
        try:
            site.add_print(label, path)
        except (OSError, ViewError) as error:
            raise scene_file.error(("assets", 0, "maps"), str(error)) from error


def _sun(light: DirectionalModel) -> dict[str, Any]:
    return {"direction": light.direction, "irradiance": light.irradiance}


def _environment(scene_file: SceneFile, site: Site) -> dict[str, Any]:
    """The scene's first environment as the page reads it."""
    lights = enumerate(scene_file.scene.lights)
    environments = [(k, light) for k, light in lights if isinstance(light, EnvironmentModel)]
    if not environments:
        return {"strength": 0}
    index, light = environments[0]
    if light.path is None:
        return {"radiance": light.radiance, "strength": 1}
    path = scene_file.resolve(light.path)
    _note_if_outside(scene_file, path, site)
    try:
        read_environment(path)  # the whole file: what only begins as an image is none
    except SceneError as error:
        raise scene_file.error(("lights", index, "path"), str(error)) from error
    image = site.add_image(path)
    strength = float(np.mean(light.radiance))
    return {"image": image, "strength": strength, "rotation_deg": light.rotation_deg}


def _note_if_outside(scene_file: SceneFile, path: Path, site: Site) -> None:
    if not path.is_relative_to(scene_file.path.parent.resolve()):
        site.notes.append(f"the page has a file from outside the scene's folder: {path}")


def _left_out(scene_file: SceneFile, glass: ObjectModel | None) -> list[str]:
    scene = scene_file.scene
    notes = []
    if len(scene.assets) > 1:
        notes.append(f"the page shows the first of {len(scene.assets)} assets")
    transform = scene.assets[0].transform
    if transform != type(transform)():
        notes.append("the page shows the asset at the origin, not where the scene has it")
    objects = [model.path.name for model in scene.objects if model is not glass]
    if objects:
        count = "an object" if len(objects) == 1 else f"{len(objects)} objects"
        notes.append(f"the page leaves out {count}: {objects[0]}")
    if scene.camera.aperture > 0.0:
        notes.append("the page has a pinhole in place of the camera's lens: all is in focus")
    shown = (DirectionalModel, EnvironmentModel)
    others = [light.type for light in scene.lights if not isinstance(light, shown)]
    if others:
        notes.append(f"the page leaves out lights: {', '.join(others)}")
    return notes

"""A scene file as the viewer shows it: its first asset, its camera, suns and environment."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from rna_render.lights.models import DirectionalModel, EnvironmentModel
from rna_render.scene_file import SceneFile, read_scene
from rna_view.errors import ViewError
from rna_view.site_files import Site, json_bytes

SCENE = "scene.json"


def scene_site(path: Path) -> Site:
    """The page for a scene; `notes` name what the page does not show."""
    scene_file = read_scene(path)
    scene = scene_file.scene
    if not scene.assets:
        raise ViewError(f"{path}: the scene has no asset")
    asset = scene_file.asset_path(0)
    site = Site({asset.name: asset}, {"scene": SCENE}, _left_out(scene_file))
    if scene.assets[0].tier is not None:
        site.query["tier"] = scene.assets[0].tier
    record = {
        "asset": asset.name,
        "camera": {
            "position": scene.camera.position,
            "look_at": scene.camera.look_at,
            "vertical_fov_deg": scene.camera.vertical_fov_deg,
        },
        "suns": [_sun(light) for light in scene.lights if isinstance(light, DirectionalModel)],
        "environment": _environment(scene_file, site),
        "ground": scene.ground is not None,
        "exposure": scene.exposure,
    }
    site.contents[SCENE] = json_bytes(record)
    return site


def _sun(light: DirectionalModel) -> dict[str, Any]:
    return {"direction": light.direction, "irradiance": light.irradiance}


def _environment(scene_file: SceneFile, site: Site) -> dict[str, Any]:
    """The scene's first environment as the page reads it."""
    found = [light for light in scene_file.scene.lights if isinstance(light, EnvironmentModel)]
    if not found:
        return {"strength": 0}
    light = found[0]
    if light.path is None:
        return {"radiance": light.radiance, "strength": 1}
    image = scene_file.resolve(light.path)
    site.contents[image.name] = image
    strength = float(np.mean(light.radiance))
    return {"image": image.name, "strength": strength, "rotation_deg": light.rotation_deg}


def _left_out(scene_file: SceneFile) -> list[str]:
    scene = scene_file.scene
    notes = []
    if len(scene.assets) > 1:
        notes.append(f"the page shows the first of {len(scene.assets)} assets")
    transform = scene.assets[0].transform
    if transform != type(transform)():
        notes.append("the page shows the asset at the origin, not where the scene has it")
    if scene.objects:
        notes.append(f"the page leaves out {len(scene.objects)} objects")
    shown = (DirectionalModel, EnvironmentModel)
    others = [light.type for light in scene.lights if not isinstance(light, shown)]
    if others:
        notes.append(f"the page leaves out lights: {', '.join(others)}")
    return notes

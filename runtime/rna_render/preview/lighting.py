"""Lighting of the preview, and its rotation."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_render.scene.light_models import AreaModel, EnvironmentModel, LightModel
from rna_render.scene.model_base import Vector
from rna_render.scene.scene_model import Scene

SCENE_LIGHTS = "scene"
"""The choice that a preview begins with."""

IMAGE_SUFFIXES = (".exr", ".hdr")


@dataclass(frozen=True)
class Lighting:
    """One choice of lights. label: for people. lights: None for the scene's own."""

    label: str
    lights: tuple[LightModel, ...] | None


def lighting_choices(scene_path: Path, folder: Path | None = None) -> dict[str, Lighting]:
    """The scene's own lights, white from all sides, and an environment an image file found.

    Images are looked for beside the scene file, then in `folder`. The keys tell nothing of where
    files lie.
    """
    white = EnvironmentModel(type="environment", radiance=(1.0, 1.0, 1.0), visible_to_camera=False)
    choices = {
        SCENE_LIGHTS: Lighting("The scene's own lights", None),
        "white": Lighting("White from all sides", (white,)),
    }
    for number, path in enumerate(_images(scene_path.parent, folder), 1):
        light = EnvironmentModel(type="environment", path=path)
        choices[f"image-{number}"] = Lighting(path.stem, (light,))
    return choices


def turned(lights: Sequence[LightModel], degrees: float, pivot: Vector) -> tuple[LightModel, ...]:
    """The lights, turned together about the vertical axis through `pivot`.

    degrees: counter-clockwise seen from above, as an environment's `rotation_deg`.
    """
    return tuple(_turned(light, degrees, np.asarray(pivot, np.float64)) for light in lights)


def _turned(light: LightModel, degrees: float, pivot: np.ndarray) -> LightModel:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    about_y = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    changes: dict[str, object] = {}
    # By the names of keys: every kind of light means the same by them.
    for name in type(light).model_fields.keys() & {"direction", "up", "position", "look_at"}:
        middle = pivot if name in ("position", "look_at") else 0.0
        value = about_y @ (np.asarray(getattr(light, name)) - middle) + middle
        changes[name] = tuple(float(x) for x in value)
    if isinstance(light, EnvironmentModel):
        changes["rotation_deg"] = light.rotation_deg + degrees
    return light.model_copy(update=changes)


def lit(scene: Scene, lighting: Lighting, degrees: float) -> Scene:
    """The scene under `lighting`, turned by `degrees` about its camera's target.

    Lights with a shape are objects of the scene: they stay, where they are.
    """
    chosen = scene.lights if lighting.lights is None else lighting.lights
    without_shape = [light for light in chosen if not isinstance(light, AreaModel)]
    shapes = [light for light in scene.lights if isinstance(light, AreaModel)]
    lights = (*turned(without_shape, degrees, scene.camera.look_at), *shapes)
    return scene.model_copy(update={"lights": lights})


def _images(*folders: Path | None) -> list[Path]:
    result: dict[Path, None] = {}
    for folder in folders:
        for path in sorted(folder.iterdir()) if folder is not None else ():
            if path.suffix.lower() in IMAGE_SUFFIXES and path.is_file() and not _is_render(path):
                result[path.resolve()] = None
    return list(result)


def _is_render(path: Path) -> bool:
    """Whether rna-run wrote the file: pictures often stand beside the scene they are of."""
    import OpenEXR

    if path.suffix.lower() != ".exr":
        return False
    try:
        with OpenEXR.File(str(path), header_only=True) as file:
            return "rnaScene" in file.header()
    except (OSError, RuntimeError, ValueError):
        return False  # who chooses it is told what is wrong with it

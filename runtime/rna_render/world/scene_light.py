"""Whether anything in a scene shines."""

from __future__ import annotations

import warnings

from rna_render.scene.light_models import LightModel
from rna_render.scene.scene_file import SceneFile
from rna_render.world.world import World


class DarkWarning(UserWarning):
    """Nothing in a scene shines."""


def warn_of_darkness(scene_file: SceneFile, world: World) -> None:
    """Warns with DarkWarning where no light, object, ground or asset of the scene shines."""
    shining = any(p.light is not None and p.light is not p.thing for p in world.placements)
    if not shining and not any(map(_shines, scene_file.scene.lights)):
        message = "the scene has no light, so its image is black: give it lights (docs/scene.md)"
        warnings.warn(f"{scene_file.path}: {message}", DarkWarning, stacklevel=2)


def _shines(light: LightModel) -> bool:
    strengths = ("irradiance", "intensity", "radiance")
    return any(any(getattr(light, name, ())) for name in strengths)

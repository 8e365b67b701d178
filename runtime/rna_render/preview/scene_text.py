"""The preview's view as text for the scene file."""

from pathlib import Path
from typing import Any

from rna_render.scene.core_yaml import dump_yaml
from rna_render.scene.scene_model import Scene

_DIGITS = 6


def scene_text(scene: Scene, folder: Path) -> str:
    """YAML of a scene's camera, exposure, view transform and lights, which replaces those keys.

    folder: of the scene file; paths below it are relative to it.
    """
    lights = [
        {"type": light.type, **light.model_dump(mode="json", exclude_defaults=True)}
        for light in scene.lights
    ]
    for light in lights:
        if "path" in light and Path(light["path"]).is_relative_to(folder.resolve()):
            light["path"] = Path(light["path"]).relative_to(folder.resolve()).as_posix()
    record = {
        "camera": scene.camera.model_dump(mode="json"),
        "exposure": scene.exposure,
        "view": scene.view,
        "lights": lights,
    }
    return dump_yaml(_rounded(record))


def _rounded(value: Any) -> Any:
    """Floats with the digits that a person wants to read."""
    if isinstance(value, float):
        return float(f"{value:.{_DIGITS}g}")
    if isinstance(value, dict):
        return {key: _rounded(one) for key, one in value.items()}
    return [_rounded(one) for one in value] if isinstance(value, list | tuple) else value

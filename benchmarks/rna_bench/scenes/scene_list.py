"""The scenes: environments, a lamp, a wall beside the asset, instances near and far."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rna_bench.scenes.stage import Stage
from rna_export.capture.blender_process import blender_env
from rna_render.scene import Scene
from rna_sdk.errors import SceneError

LAMP, WALL, NEAR_AND_FAR = "lamp", "wall", "near-and-far"
BESIDE_ENVIRONMENTS = (LAMP, WALL, NEAR_AND_FAR)

_ROWS = ((3.5, 2), (8.0, 4), (15.0, 6), (26.0, 9))
"""Distance behind the first asset, in its radii, and instances of each row."""


def scenes(stage: Stage, environments: Sequence[Path], folder: Path) -> dict[str, Scene]:
    """All scenes by name; environments are called as their files.

    folder: for the mesh of the wall. The first environment, if any, lights the instances near and
    far, else the lamp does. Raises SceneError where two would have one name.
    """
    skies = {path.stem: stage.environment(path) for path in environments}
    if len({*skies, *BESIDE_ENVIRONMENTS}) < len(environments) + len(BESIDE_ENVIRONMENTS):
        raise SceneError("--environment: found two scenes of one name; rename a file")
    light = next(iter(skies.values()), stage.lamp)
    ground = stage.ground
    result = {name: stage.scene(sky, ground=ground) for name, sky in skies.items()}
    result[LAMP] = stage.scene(stage.lamp, ground=ground)
    result[WALL] = stage.scene(stage.lamp, ground=ground, objects=[stage.wall(folder)])
    result[NEAR_AND_FAR] = stage.scene(light, ground=_wide(ground), assets=_near_and_far(stage))
    return result


def _near_and_far(stage: Stage) -> list[dict[str, Any]]:
    rows = [stage.row_of_assets(0.0, 1, 0.0)]
    rows += [stage.row_of_assets(*row, first_turn=40.0 * k) for k, row in enumerate(_ROWS, 1)]
    return [asset for row in rows for asset in row]


def _wide(ground: dict[str, Any]) -> dict[str, Any]:
    return {**ground, "size": 4 * ground["size"]}


def find_environment(name: str) -> Path:
    """A file, or one of the images that come with Blender, by its name.

    Raises SceneError where there is neither.
    """
    path = Path(name)
    if path.is_file():
        return path.resolve()
    python = blender_env.find_python()
    folder = "lib/python*/site-packages/bpy/*/datafiles/studiolights/world"
    ours = {path.stem: path for path in python.parent.parent.glob(f"{folder}/*.exr")}
    if name not in ours:
        known = ", ".join(sorted(ours))
        raise SceneError(f"--environment: found {name}; expected a file or one of {known}")
    return ours[name]

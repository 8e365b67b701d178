"""The scene file that `rna-make` leaves beside a package, as a next step: it shows the package."""

from pathlib import Path

from rna_render.scene import default_scene, scene_text

SCENE_NAME = "scene.yaml"


def write_starter(package: Path) -> Path | None:
    """Writes a scene of the package beside it; None where a file of this name is there already.

    Raises OSError if it cannot be written, PackageError for a broken package.
    """
    path, text = package.with_name(SCENE_NAME), scene_text(default_scene(package))
    try:
        with path.open("x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError:
        return None
    return path

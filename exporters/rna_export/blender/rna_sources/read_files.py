"""Files that a source references: needed to open it on another machine."""

import os
import re
import sys
from pathlib import Path

import bpy
from rna_materials.udim_tiles import path_of

_opened: set[str] = set()  # by Python


def watch() -> None:
    """Remember from now on the files that Python opens."""
    sys.addaudithook(_hear)


def _hear(event: str, arguments: tuple[object, ...]) -> None:
    if event == "open" and isinstance(arguments[0], str):
        _opened.add(arguments[0])


def files_of(source: str) -> dict[str, list[str]]:
    """Paths: `travel` is named by its place to the source, `fixed` by an absolute path."""
    folder = os.path.dirname(os.path.abspath(source))
    kinds: dict[str, str] = {}
    for path in [*_opened, *(getattr(m, "__file__", None) or "" for m in [*sys.modules.values()])]:
        kinds[os.path.abspath(path)] = "travel" if _is_below(path, folder) else "fixed"
    for path in _of_blender():
        # What an importer names in Blender by an absolute path lies where the source says.
        imported = not source.endswith(".blend") and _is_below(path, folder)
        kind = "travel" if path.startswith("//") or imported else "fixed"
        kinds[os.path.abspath(bpy.path.abspath(path))] = kind
    kinds.pop(os.path.abspath(source), None)
    result: dict[str, list[str]] = {"travel": [], "fixed": []}
    for path, kind in sorted(kinds.items()):
        if os.path.isfile(path) and not any(_is_below(path, other) for other in _not_the_users()):
            result[kind].append(path)
    return {name: [p for p in paths if "__pycache__" not in p] for name, paths in result.items()}


def _of_blender() -> list[str]:
    """Paths that Blender names, as they are stored: with all tiles and frames of images."""
    paths: list[str] = bpy.utils.blend_paths(absolute=False, packed=False, local=False)
    for image in bpy.data.images:
        if image.source == "TILED":
            paths += [path_of(image.filepath, tile.number) for tile in image.tiles]
        elif image.source == "SEQUENCE":
            paths += _frames(image.filepath)
    return paths


def _frames(path: str) -> list[str]:
    """Images of a sequence: those whose names differ in the last number alone."""
    numbered = re.fullmatch(r"(.*?)\d+(\D*)", path, re.DOTALL)
    if numbered is None:
        return []
    begin, end = numbered.groups()
    folder, name = os.path.split(bpy.path.abspath(begin))
    pattern = re.compile(re.escape(name) + r"(\d+)" + re.escape(end))
    if not os.path.isdir(folder):
        return []
    found = (pattern.fullmatch(each) for each in sorted(os.listdir(folder)))
    return [f"{begin}{match[1]}{end}" for match in found if match]


def _is_below(path: str, folder: str) -> bool:
    return os.path.abspath(path).startswith(folder.rstrip("/") + "/")


def _not_the_users() -> set[str]:
    """Folders of Python, Blender, ours and the system."""
    installed = {sys.prefix, sys.base_prefix, bpy.utils.resource_path("LOCAL")}
    installed |= {bpy.utils.resource_path("USER"), bpy.app.tempdir, str(Path(__file__).parents[1])}
    system = ("/proc", "/sys", "/dev", "/usr", "/etc", "/lib", "/var")
    return {os.path.abspath(folder) for folder in (*installed, *system) if folder}

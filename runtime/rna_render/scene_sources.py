"""The files that a scene is made of, so that they can be brought to other machines."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from pydantic import BaseModel

import rna_sdk
from rna_render.scene_file import SceneFile
from rna_sdk.regular_file import check_regular, read_regular
from rna_work.places import Place
from rna_work.sources import Carried


def carried_scene(scene_file: SceneFile, where: Place) -> Carried:
    """The scene file for workers, with all that it names. Raises SceneError if a file is missing.

    Paths in the scene that are absolute stay as they are: such files have to be on all machines.
    """
    if not where.far:
        return where.carry(scene_file.path)
    relative, absolute = _files(scene_file)
    return where.carry(scene_file.path, relative, absolute)


def scene_key(scene_file: SceneFile) -> str:
    """The same for the same image alone: of the scene, and of the bytes of all that it reads.

    Raises SceneError if a file is missing.
    """
    relative, absolute = _files(scene_file)
    key = hashlib.sha256(f"{rna_sdk.__version__} {scene_file.scene.model_dump_json()}".encode())
    for file in sorted({*relative, *absolute}):
        with file.open("rb") as stream:
            digest = hashlib.file_digest(stream, "sha256").hexdigest()
        key.update(f"{file.name} {digest}".encode())
    return key.hexdigest()


def _files(scene_file: SceneFile) -> tuple[list[Path], list[Path]]:
    """Files of the scene: those named relative to it, and those by absolute paths."""
    relative: list[Path] = []
    absolute: list[Path] = []
    for path in set(named_paths(scene_file.scene)):
        file = scene_file.resolve(path)
        try:
            check_regular(file)
        except OSError as error:
            raise scene_file.error((), f"{error.strerror}: {file}") from error
        files = [scene_file.path.parent / path, *read_with(scene_file.path.parent / path)]
        (absolute if path.is_absolute() else relative).extend(files)
    return relative, absolute


def named_paths(value: object) -> Iterator[Path]:
    """All paths anywhere in a part of a scene."""
    if isinstance(value, Path):
        yield value
    elif isinstance(value, BaseModel):
        for _, part in value:
            yield from named_paths(part)
    elif isinstance(value, tuple):
        for part in value:
            yield from named_paths(part)


def read_with(path: Path) -> list[Path]:
    """Existing files that a mesh file refers to."""
    read = {".gltf": _of_gltf, ".obj": _of_obj}.get(path.suffix.lower())
    try:
        names = read(path) if read is not None else []
        return [file for name in names if (file := path.parent / name).is_file()]
    except Exception:  # whatever a broken file raises: who reads its mesh says what is wrong
        return []


def _of_gltf(path: Path) -> list[str]:
    data: dict[str, Any] = json.loads(read_regular(path))
    entries = [*data.get("buffers", []), *data.get("images", [])]
    uris = [entry.get("uri", "data:") for entry in entries]
    return [unquote(uri) for uri in uris if not uri.startswith("data:")]


def _of_obj(path: Path) -> list[str]:
    libraries = re.findall(r"^\s*mtllib\s+(.+?)\s*$", path.read_text(errors="replace"), re.M)
    maps = []
    for name in libraries:
        file = path.parent / name
        if file.is_file():
            lines = re.findall(r"^\s*map_\w+\s+(.+?)\s*$", file.read_text(errors="replace"), re.M)
            maps += [str(Path(name).parent / line.split()[-1]) for line in lines]
            maps += [str(Path(name).parent / line) for line in lines]
    return [*libraries, *maps]

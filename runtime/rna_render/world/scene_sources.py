"""The files that a scene is made of: to bring them to other machines, and to tell them apart."""

import hashlib
import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote

from pydantic import BaseModel

import rna_sdk
from rna_render.scene.gltf_container import open_gltf
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_messages import Key
from rna_sdk.files.regular_file import read_regular
from rna_work.cached import content_hash
from rna_work.executors import Executor
from rna_work.sources import Carried


def carried_scene(scene_file: SceneFile, executor: Executor) -> Carried:
    """The scene file for workers, with all that it names. Raises SceneError if a file is missing.

    Paths in the scene that are absolute stay as they are: such files have to be on all machines.
    """
    if not executor.far:
        return executor.carry(scene_file.path)
    relative, absolute = _files(scene_file)
    return executor.carry(scene_file.path, relative, absolute)


def scene_key(scene_file: SceneFile) -> str:
    """A hash that equal images share: of the scene, and of the bytes of all that it reads.

    Raises SceneError if a file is missing.
    """
    contents = contents_key(scene_file)
    key = f"{rna_sdk.__version__} {scene_file.scene.model_dump_json()} {contents}"
    return hashlib.sha256(key.encode()).hexdigest()


def contents_key(scene_file: SceneFile) -> str:
    """A hash of the bytes of all files that the scene reads, under their names.

    Raises SceneError if a file is missing.
    """
    check_files(scene_file)
    key = hashlib.sha256()
    for file in sorted(set(files_of(scene_file)[1:])):
        scene_file.check((), file)
        key.update(f"{file.name} {content_hash(file)}\n".encode())
    return key.hexdigest()


def files_of(scene_file: SceneFile) -> list[Path]:
    """The scene file, the files that it names, and those existing ones that these refer to."""
    named = dict.fromkeys(map(scene_file.resolve, named_paths(scene_file.scene)))
    return [scene_file.path, *(file for path in named for file in (path, *read_with(path)))]


def _files(scene_file: SceneFile) -> tuple[list[Path], list[Path]]:
    """Files of the scene: those named relative to it, and those by absolute paths."""
    relative: list[Path] = []
    absolute: list[Path] = []
    check_files(scene_file)
    for path in set(named_paths(scene_file.scene)):
        files = [scene_file.path.parent / path, *read_with(scene_file.path.parent / path)]
        (absolute if path.is_absolute() else relative).extend(files)
    return relative, absolute


def check_files(scene_file: SceneFile) -> None:
    """Raises SceneError, with file, line and key, where a file that the scene names is missing."""
    first: dict[tuple[Key, Path], Key] = {}
    for key, path in _keyed_paths(scene_file.scene, ()):
        first.setdefault((key[:1], path), key)
    for (_, path), key in first.items():
        scene_file.check(key, scene_file.resolve(path))


def named_paths(value: object) -> Iterator[Path]:
    """All paths anywhere in a part of a scene."""
    return (path for _, path in _keyed_paths(value, ()))


def _keyed_paths(value: object, key: Key) -> Iterator[tuple[Key, Path]]:
    if isinstance(value, Path):
        yield key, value
    elif isinstance(value, BaseModel):
        for name, part in value:
            yield from _keyed_paths(part, (*key, name))
    elif isinstance(value, tuple):
        for index, part in enumerate(value):
            yield from _keyed_paths(part, (*key, index))


def read_with(path: Path) -> list[Path]:
    """Existing files that a mesh file refers to."""
    readers = {".gltf": _of_gltf, ".glb": _of_gltf, ".obj": _of_obj}
    read = readers.get(path.suffix.lower())
    try:
        names = read(path) if read is not None else []
        return [file for name in names if (file := path.parent / name).is_file()]
    except Exception:  # whatever a broken file raises: who reads its mesh says what is wrong
        return []


def _of_gltf(path: Path) -> list[str]:
    data = open_gltf(path).json
    entries = [*data.get("buffers", []), *data.get("images", [])]
    uris = [entry.get("uri", "data:") for entry in entries]
    return [unquote(uri) for uri in uris if not uri.startswith("data:")]


def _of_obj(path: Path) -> list[str]:
    libraries = re.findall(r"(?im)^\s*mtllib\s+(.+?)\s*$", _text(path))
    maps = []
    for name in libraries:
        file = path.parent / name
        if file.is_file():
            lines = re.findall(r"(?im)^\s*map_\w+\s+(.+?)\s*$", _text(file))
            maps += [str(Path(name).parent / line.split()[-1]) for line in lines]
            maps += [str(Path(name).parent / line) for line in lines]
    return [*libraries, *maps]


def _text(path: Path) -> str:
    return read_regular(path).decode(errors="replace")

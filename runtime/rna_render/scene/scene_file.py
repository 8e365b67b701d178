"""Scene files: YAML in, a validated scene out, and every error with its file, line and key."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import yaml
from pydantic import BaseModel, ValidationError

from rna_render.scene.animation import frame_scene
from rna_render.scene.core_yaml import CoreLoader
from rna_render.scene.glb_scene import expanded
from rna_render.scene.limits import MAX_SCENE_BYTES
from rna_render.scene.scene_messages import Key, Mistake, mistakes
from rna_render.scene.scene_model import AssetModel, CameraModel, Scene
from rna_render.scene.scene_of_package import default_scene
from rna_sdk.errors import SceneError
from rna_sdk.files.file_kinds import kind_of, not_a
from rna_sdk.files.regular_file import check_regular

# A few lines of YAML aliases can unfold into any number of values.
MAX_DEPTH = 16
MAX_VALUES = 1_000_000

_SHOWN = 20  # mistakes after the first


@dataclass(frozen=True)
class SceneFile:
    """A scene, and where in its file each key stands.

    path: the file. scene: what it says, with an asset for each place in a .glb. lines: from key to
    line, counted from 1; none for the default scene of a package. next_camera: of the next frame,
    where `scene` is one of several. first_camera: of the file, where `scene` is one frame of it.
    entries: of assets and objects of `scene` that a .glb has, the key of its entry in the file.
    """

    path: Path
    scene: Scene
    lines: dict[Key, int]
    next_camera: CameraModel | None = None
    first_camera: CameraModel | None = None
    entries: dict[Key, Key] = field(default_factory=dict)

    def at(self, frame: float) -> "SceneFile":
        """The file with the scene of one frame of its animation; this one if it has none."""
        scene, after = frame_scene(self.scene, frame), frame_scene(self.scene, frame + 1.0)
        return replace(self, scene=scene, next_camera=after.camera, first_camera=self.viewpoint)

    @property
    def viewpoint(self) -> CameraModel:
        """The camera of the file, about which all its frames are rendered, on every machine."""
        return self.first_camera or self.scene.camera

    @property
    def camera_after(self) -> CameraModel:
        """The camera of the next frame; this frame's camera if it does not move."""
        return self.next_camera or frame_scene(self.scene, 1.0).camera

    def error(self, key: Key, message: str) -> SceneError:
        """An error that points at `key`."""
        key = self.entries.get(key[:2], key[:2]) + key[2:]
        return SceneError(message, file=self.path, line=_line(self.lines, key), key=_dotted(key))

    def resolve(self, path: Path) -> Path:
        """`path`, which the file gives relative to itself."""
        return (self.path.parent / path).resolve()

    @cached_property
    def resolved(self) -> Scene:
        """The scene with all paths as they can be opened."""
        scene: Scene = _with_paths(self.scene, self.resolve)
        return scene

    def check(self, key: Key, path: Path) -> None:
        """Raises SceneError, which points at `key`, where `path` is not a regular file.

        An asset's path has to have the name of a package, too.
        """
        try:
            check_regular(path)
        except FileNotFoundError as error:
            raise self.error(key, f"no such file: {path}") from error
        except OSError as error:
            raise self.error(key, f"{error.strerror}: {path}") from error
        is_asset = key[:1] == ("assets",) and key[2:] == ("path",)
        if is_asset and (wrong := not_a("package", path)) is not None:
            raise self.error(key, f"{path.name} is {wrong}")

    def with_changes(self, tier: str | None = None, **changes: Any) -> "SceneFile":
        """This scene with other values for top-level keys, and `tier` for every asset."""
        assets = self.scene.assets
        if tier is not None:
            assets = tuple(asset.model_copy(update={"tier": tier}) for asset in assets)
        scene = self.scene.model_copy(update={"assets": assets, **changes})
        return replace(self, scene=scene)


def read_scene(path: Path) -> SceneFile:
    """Read and validate a scene file.

    path: a YAML file, or a package, which is shown in its default scene.

    Raises SceneError, with file, line and key, if it cannot be read, is not YAML, or does not
    fit rna_render.scene.scene_model.Scene; PackageError for a broken package.
    """
    try:
        size = check_regular(path).st_size
    except OSError as error:
        raise SceneError(error.strerror or str(error), file=path) from error
    data: object
    lines: dict[Key, int]
    if kind_of(path) == "package":
        data, lines = default_scene(path), {}  # the person has no file with lines
    elif (wrong := not_a("scene", path)) is not None:
        raise SceneError(wrong, file=path)
    elif size > MAX_SCENE_BYTES:
        message = f"has {size} bytes; a scene file has at most {MAX_SCENE_BYTES}"
        raise SceneError(message, file=path)
    else:
        data, lines = _parse(path)
    try:
        scene = Scene.model_validate(data)
    except ValidationError as error:
        raise _scene_error(path, lines, error) from error
    return _expanded(SceneFile(path, scene, lines))


def _expanded(file: SceneFile) -> SceneFile:
    """The scene with the assets and meshes of each .glb. Raises SceneError, as `expanded`."""
    assets: list[AssetModel] = []
    objects = [*file.scene.objects]
    entries: dict[Key, Key] = {}
    for index, asset in enumerate(file.scene.assets):
        entry = ("assets", index)
        try:
            placed, beside = expanded(asset, file.resolve(asset.path))
        except SceneError as error:
            raise file.error((*entry, "path"), str(error)) from error
        entries |= {("assets", len(assets) + i): entry for i in range(len(placed))}
        entries |= {("objects", len(objects) + i): entry for i in range(len(beside))}
        assets += placed
        objects += beside
    update = {"assets": tuple(assets), "objects": tuple(objects)}
    return replace(file, scene=file.scene.model_copy(update=update), entries=entries)


def _with_paths(part: Any, resolve: Callable[[Path], Path]) -> Any:
    """A part of a scene with all its paths resolved."""
    if isinstance(part, Path):
        return resolve(part)
    if isinstance(part, tuple):
        return tuple(_with_paths(item, resolve) for item in part)
    if isinstance(part, dict):
        return {key: _with_paths(item, resolve) for key, item in part.items()}
    if isinstance(part, BaseModel):
        return part.model_copy(update={k: _with_paths(v, resolve) for k, v in part})
    return part


def _parse(path: Path) -> tuple[object, dict[Key, int]]:
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or "is not UTF-8 text"
        raise SceneError(reason, file=path) from error
    lines: dict[Key, int] = {}
    try:
        loader = CoreLoader(text)
        node = loader.get_single_node()
        if node is None:
            raise SceneError("the file is empty", file=path)
        _collect_lines(path, node, (), lines)
        return loader.construct_document(node), lines
    except yaml.MarkedYAMLError as error:
        line = error.problem_mark.line + 1 if error.problem_mark else None
        raise SceneError(f"not YAML: {error.problem}", file=path, line=line) from error
    except RecursionError as error:
        raise SceneError("too deep for a scene", file=path) from error
    except yaml.YAMLError as error:
        raise SceneError(f"not YAML: {' '.join(str(error).split())}", file=path) from error


def _collect_lines(path: Path, node: yaml.Node, key: Key, lines: dict[Key, int]) -> None:
    """Note the line of every key below `node`; refuse keys that are there twice."""
    lines.setdefault(key, node.start_mark.line + 1)
    if len(key) > MAX_DEPTH or len(lines) > MAX_VALUES:
        raise SceneError("too deep or too long for a scene", file=path, line=lines[key])
    if isinstance(node, yaml.SequenceNode):
        for index, item in enumerate(node.value):
            _collect_lines(path, item, (*key, index), lines)
    elif isinstance(node, yaml.MappingNode):
        for name, value in node.value:
            child, line = (*key, str(name.value)), name.start_mark.line + 1
            if child in lines:
                message = f"is here twice, first on line {lines[child]}"
                raise SceneError(message, file=path, line=line, key=_dotted(child))
            lines[child] = line
            _collect_lines(path, value, child, lines)


def _scene_error(path: Path, lines: dict[Key, int], error: ValidationError) -> SceneError:
    """All of pydantic's errors, a line each, in the order of the file; it points at the first."""
    found = mistakes(Scene, error.errors())
    first, *others = sorted(found, key=lambda mistake: _line(lines, mistake.key) or 0)

    def located(mistake: Mistake, message: str) -> SceneError:
        line, key = _line(lines, mistake.key), _dotted(mistake.key) or None
        return SceneError(message, file=path, line=line, key=key)

    shown = [str(located(other, other.message)) for other in others[:_SHOWN]]
    if len(others) > _SHOWN:
        shown.append(f"and {len(others) - _SHOWN} more")
    return located(first, "\n".join([first.message, *shown]))


def _line(lines: dict[Key, int], key: Key) -> int | None:
    """The line of `key`, or of the nearest thing around it that the file has."""
    while key and key not in lines:
        key = key[:-1]
    return lines.get(key)


def _dotted(key: Key) -> str:
    """`lights[0].irradiance`."""
    parts = [f"[{part}]" if isinstance(part, int) else f".{part}" for part in key]
    return "".join(parts).removeprefix(".")

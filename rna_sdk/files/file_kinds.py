"""Kinds of files by their names, for errors that name another kind, and files beside it."""

from pathlib import Path
from typing import Literal

from rna_sdk.commands.console import command_line
from rna_sdk.files.regular_file import check_regular

Kind = Literal["package", "scene", "model"]

_GLTF = (".gltf", ".glb")
_CARRIED, _LARGEST_JSON = b"RNA_relightable_asset", 2**23

_SUFFIXES: dict[Kind, tuple[str, ...]] = {
    "package": (".rna",),
    "scene": (".yaml", ".yml"),
    "model": (
        *_GLTF,
        *(".blend", ".obj", ".ply", ".abc", ".usd", ".usda", ".usdc", ".usdz"),
        *(".fbx", ".stl", ".dae", ".data", ".hair"),
    ),
}


def kind_of(path: Path) -> Kind | None:
    """The kind of a file by its suffix, a .glb with a package is a package; None for others."""
    suffix = path.suffix.lower()
    if suffix == ".glb" and _carries_package(path):
        return "package"
    return next((kind for kind, known in _SUFFIXES.items() if suffix in known), None)


def _carries_package(path: Path) -> bool:
    """Whether the JSON of a .glb names our extension; its readers say where it is broken."""
    try:
        check_regular(path)
        with path.open("rb") as file:
            head = file.read(20)
            size = min(int.from_bytes(head[12:16], "little"), _LARGEST_JSON)
            return head[:4] == b"glTF" and _CARRIED in file.read(size)
    except OSError:
        return False


def is_gltf(path: Path) -> bool:
    """Whether a file is glTF, by its suffix."""
    return path.suffix.lower() in _GLTF


def not_a(wanted: Kind, path: Path) -> str | None:
    """Why a file is not of the wanted kind, with a command for it; None if its kind is unknown.

    The text follows the file's name in an error.
    """
    kind = kind_of(path)
    if kind is None or kind == wanted or (wanted == "model" and is_gltf(path)):
        return None
    made = path.with_suffix(".rna").name
    what_to_do = {
        "model": f"; {command_line('rna-make', path, '--out', made)} makes a package of it",
        "package": f"; {command_line('rna-run', path, '--png', path.stem + '.png')} shows it",
        "scene": f"; {command_line('rna-run', path, '--png', path.stem + '.png')} renders it",
    }
    return f"a {kind}, not a {wanted}{what_to_do[kind]}"


def glass_of(package: Path) -> Path:
    """Where the glass of a package is, if it has any: `bottle.glass.glb` beside `bottle.rna`.

    It is an ordinary glTF mesh, and no part of the package.
    """
    return package.with_name(f"{package.stem}.glass.glb")

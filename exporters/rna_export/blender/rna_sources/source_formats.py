"""The files that a source may be; does not import Blender. A reader is in `source_scene`."""

from __future__ import annotations

from typing import Literal, NamedTuple


class SourceFormat(NamedTuple):
    """What a suffix stands for.

    up: axis that is up where neither the file nor `--up` says so; "USD" for what the file says.
    options: which ones `groom_options` has for it after `--`.
    """

    reader: Literal["blend", "gltf", "obj", "ply", "scene", "groom", "script"]
    up: Literal["Y", "Z", "USD"]
    options: Literal["groom", "scene"] | None = None


SOURCE_FORMATS = {
    ".blend": SourceFormat("blend", "Z"),
    ".gltf": SourceFormat("gltf", "Y"),
    ".glb": SourceFormat("gltf", "Y"),
    ".obj": SourceFormat("obj", "Y"),
    ".ply": SourceFormat("ply", "Z"),  # it says no up; Blender's then, as for scripts
    ".abc": SourceFormat("scene", "Y", "scene"),
    ".usd": SourceFormat("scene", "USD", "scene"),
    ".usda": SourceFormat("scene", "USD", "scene"),
    ".usdc": SourceFormat("scene", "USD", "scene"),
    ".usdz": SourceFormat("scene", "USD", "scene"),
    ".hair": SourceFormat("groom", "Z", "groom"),
    ".tfx": SourceFormat("groom", "Y", "groom"),
    ".py": SourceFormat("script", "Z"),
}

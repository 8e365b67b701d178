"""Pictures in packages: the size in the header of a PNG (PNG specification, 11.2.2)."""

from __future__ import annotations

import struct
from collections.abc import Set

from rna_sdk.package.container.zip_container import Container
from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.package.issues import Code, Issue
from rna_sdk.package.limits import MAX_TEXTURE_SIDE
from rna_sdk.package.manifest.extensions import Poster, StandinTextures, extension
from rna_sdk.package.manifest.manifest_model import Manifest

_START = b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR"
_SIZE = struct.Struct(">II")


def png_size(data: bytes | memoryview) -> tuple[int, int] | None:
    """Width and height of a PNG; None where the bytes are not one."""
    if bytes(data[: len(_START)]) != _START or len(data) < len(_START) + _SIZE.size:
        return None
    width, height = _SIZE.unpack_from(data, len(_START))
    return width, height


def poster_issues(container: Container, manifest: Manifest, intact: Set[str]) -> list[Issue]:
    """The warning of a poster that is not what the manifest says."""
    poster = extension(manifest, Poster)
    if poster is None or poster.image not in intact:
        return []
    size, declared = png_size(container.view(poster.image)), (poster.width, poster.height)
    if size == declared:
        return []
    found = "no PNG" if size is None else f"{size[0]} x {size[1]} pixels"
    expected = f"a PNG of {declared[0]} x {declared[1]} pixels"
    return [Issue.of(Code.POSTER_IMAGE, poster.image, found, expected)]


def texture_issues(
    container: Container, manifest: Manifest, part: int, mesh: Mesh, intact: Set[str]
) -> list[Issue]:
    """The warnings of a part's stand-in textures."""
    data = extension(manifest, StandinTextures)
    textures = None if data is None else data.parts[part]
    if data is None or textures is None:
        return []
    if mesh.uvs is None:
        where = f"/extensions/{data.NAME}/parts/{part}"
        found = "a mesh without TEXCOORD_0"
        return [Issue.of(Code.STANDIN_TEXTURE, where, found, "texture coordinates")]
    issues = []
    for name in dict.fromkeys(textures.entries.values()):
        size = png_size(container.view(name)) if name in intact else (1, 1)
        if size is None or not (1 <= min(size) and max(size) <= MAX_TEXTURE_SIDE):
            found = "no PNG" if size is None else f"{size[0]} x {size[1]} pixels"
            expected = f"a PNG of 1 to {MAX_TEXTURE_SIDE} pixels a side"
            issues.append(Issue.of(Code.STANDIN_TEXTURE, name, found, expected))
    return issues

"""RNA_poster: the size in the header of a PNG (PNG specification, 11.2.2)."""

from __future__ import annotations

import struct
from collections.abc import Set

from rna_sdk.package.container.zip_container import Container
from rna_sdk.package.issues import Code, Issue
from rna_sdk.package.manifest.extensions import Poster, extension
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

"""Write a package into a binary glTF; `carrier` is the inverse."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rna_sdk.errors import PackageError, RnaError
from rna_sdk.files.regular_file import read_regular
from rna_sdk.package.container.glb_chunks import CHUNK, HEADER, pack_glb
from rna_sdk.package.gltf.carrier import EXTENSION, MIME_TYPE, read_carrier, split_carrier
from rna_sdk.package.issues import Code
from rna_sdk.package.limits import ALIGNMENT, MAX_FILE_BYTES
from rna_sdk.package.package import Package

_LOCAL_HEADER = b"PK\3\4"  # that a package begins with


def carrying(view: int) -> dict[str, Any]:
    """The `extensions` of a node whose package is in this buffer view."""
    return {EXTENSION: {"package": view, "mimeType": MIME_TYPE}}


def packed(document: dict[str, Any], blob: bytes) -> bytes:
    """A .glb whose binary chunk has its data at a multiple of 64 bytes of the file.

    Raises RnaError for one that is too large.
    """
    whole = {**document, "buffers": [{"byteLength": len(blob)}, *document.get("buffers", ())[1:]]}
    text = json.dumps(whole, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-(HEADER.size + CHUNK.size + len(text) + CHUNK.size) % ALIGNMENT)
    if len(text) + len(blob) > MAX_FILE_BYTES - ALIGNMENT:
        raise RnaError(f"a .glb of {len(text) + len(blob)} bytes: expected less than 4 GiB")
    return pack_glb(text, blob)


def with_package(glb: Path, package: Package, nodes: Sequence[str] = ()) -> bytes:
    """A .glb of another program, which becomes the package's fallback; all in it stays as it is.

    nodes: names of the nodes that carry the package, each in its own space. Without any, those that
    a program left the extension at when it dropped the package; else a new node about all that the
    default scene shows.

    Raises:
        RnaError: what cannot carry a package, carries one, or has no such node.
    """
    try:
        return _with_package(*_opened(glb), package, nodes, glb)
    except (AttributeError, LookupError, TypeError, ValueError) as error:
        raise RnaError(f"{glb}: is no valid glTF: {error}") from error


def with_fallback_flip(glb: Path, flip: float) -> bytes:
    """A .glb that carries a package, with the error of its fallback."""
    data = memoryview(read_regular(glb))
    document, place = split_carrier(data)
    for node in document["nodes"]:
        if EXTENSION in (extensions := node.get("extensions", {})):
            extensions[EXTENSION]["fallbackFlip"] = flip
    return packed(document, bytes(data[place]))


def _with_package(
    document: dict[str, Any], blob: bytes, package: Package, nodes: Sequence[str], glb: Path
) -> bytes:
    view = len(document.setdefault("bufferViews", []))
    every = document.get("nodes", ())
    left = [node for node in every if node.get("extensions", {}).pop(EXTENSION, None)]
    carriers = _named(document, nodes, glb) if nodes else left
    for node in carriers or [_root(document, package.manifest.name)]:
        node["extensions"] = {**node.get("extensions", {}), **carrying(view)}
    start = len(blob) + -len(blob) % ALIGNMENT
    size = len(package.file_data)
    document["bufferViews"].append({"buffer": 0, "byteOffset": start, "byteLength": size})
    used = dict.fromkeys([*document.get("extensionsUsed", ()), EXTENSION])
    document["extensionsUsed"] = list(used)
    return packed(document, b"".join((blob.ljust(start, b"\0"), package.file_data)))


def _opened(glb: Path) -> tuple[dict[str, Any], bytes]:
    """The JSON of a .glb without a package, and its buffer."""
    try:
        data = memoryview(read_regular(glb))
        document, place = split_carrier(data)
    except OSError as error:
        raise RnaError(f"{glb}: {error.strerror}") from error
    except PackageError as error:
        raise RnaError(f"{glb}: {error.issues[0]}") from error
    if _has_package(data):
        raise RnaError(f"{glb}: carries a package; expected a .glb without one")
    buffers = document.get("buffers", [])
    if buffers and "uri" in buffers[0]:
        raise RnaError(f"{glb}: its first buffer is another file; expected it inside the .glb")
    blob = bytes(data[place])
    if buffers and buffers[0]["byteLength"] > len(blob):
        raise RnaError(f"{glb}: its buffer is cut short: it has {len(blob)} bytes")
    return document, blob


def _has_package(data: memoryview) -> bool:
    """Whether a .glb has a package, or several, and not only the extension at its nodes.

    Programs that drop what they do not know may leave that, with the number of another buffer view.
    """
    try:
        return bytes(data[read_carrier(data).package][:4]) == _LOCAL_HEADER
    except PackageError as error:
        left = (Code.GLB_NO_PACKAGE, Code.GLB_PACKAGE, Code.GLB_ALIGNMENT)
        return error.issues[0].code not in {code.name for code in left}


def _named(document: dict[str, Any], names: Sequence[str], glb: Path) -> list[dict[str, Any]]:
    """The nodes of these names; a name may belong to several nodes."""
    nodes = document.get("nodes", [])
    found = [node for node in nodes if node.get("name") in names]
    known = [str(node["name"]) for node in nodes if "name" in node]
    if missing := [name for name in names if name not in known]:
        raise RnaError(f"{glb}: has no node {missing[0]!r}; its nodes: {', '.join(known[:20])}")
    return found


def _root(document: dict[str, Any], name: str) -> dict[str, Any]:
    """A new node about all roots of the default scene."""
    nodes = document.setdefault("nodes", [])
    scenes = document.setdefault("scenes", [{}])
    scene = scenes[document.setdefault("scene", 0)]
    root: dict[str, Any] = {"name": name}
    if roots := scene.get("nodes"):
        root["children"] = roots
    scene["nodes"] = [len(nodes)]
    nodes.append(root)
    return root

"""Small .glb files that carry a package, good and broken."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

from rna_sdk.package.container.glb_chunks import HEADER, MAGIC, pack_glb
from rna_sdk.package.gltf.carrier import EXTENSION
from rna_sdk.package.gltf.glb_file import write_glb

Document = dict[str, Any]


def make_carrier(package: Path, path: Path) -> Path:
    """A .glb with the package and the usual fallback."""
    write_glb(package, path)
    return path


def opened(path: Path) -> tuple[Document, bytes]:
    """JSON and buffer of a .glb."""
    data = path.read_bytes()
    size = int.from_bytes(data[12:16], "little")
    return json.loads(data[20 : 20 + size]), data[28 + size :]


def written(document: Document, blob: bytes, path: Path, padding: int | None = None) -> Path:
    """A .glb whose buffer starts at a multiple of 64, or `padding` spaces behind the JSON."""
    text = json.dumps(document).encode()
    text += b" " * (-(28 + len(text)) % 64 if padding is None else padding)
    path.write_bytes(pack_glb(text, blob))
    return path


def changed(path: Path, out: Path, change: Callable[[Document], object]) -> Path:
    """A copy with another JSON."""
    document, blob = opened(path)
    change(document)
    return written(document, blob, out)


def _record(document: Document) -> dict[str, Any]:
    record: dict[str, Any] = document["nodes"][-1]["extensions"][EXTENSION]
    return record


def _second(document: Document) -> None:
    view = {"buffer": 0, "byteOffset": 0, "byteLength": 64}
    document["bufferViews"].append(view)
    node = {"mesh": 0, "extensions": {EXTENSION: {**_record(document), "package": 99}}}
    node["extensions"][EXTENSION]["package"] = len(document["bufferViews"]) - 1
    document["nodes"].append(node)


def _deep(document: Document) -> None:
    nested: list[Any] = []
    for _ in range(100):
        nested = [nested]
    document["extras"] = nested


CHANGES: dict[str, tuple[str, Callable[[Document], object]]] = {
    "no_extension": ("GLB_NO_PACKAGE", lambda d: d["nodes"][-1].pop("extensions")),
    "two_packages": ("GLB_SEVERAL", _second),
    "nodes_of_an_object": ("GLB_CONTAINER", lambda d: d.update(nodes={})),
    "nested_json": ("GLB_CONTAINER", _deep),
    "no_such_view": ("GLB_PACKAGE", lambda d: _record(d).update(package=999)),
    "negative_view": ("GLB_PACKAGE", lambda d: _record(d).update(package=-1)),
    "view_that_is_true": ("GLB_PACKAGE", lambda d: _record(d).update(package=True)),
    "no_view": ("GLB_PACKAGE", lambda d: _record(d).pop("package")),
    "another_type": ("GLB_PACKAGE", lambda d: _record(d).update(mimeType="image/png")),
    "record_of_text": (
        "GLB_PACKAGE",
        lambda d: d["nodes"][-1]["extensions"].update({EXTENSION: "x"}),
    ),
    "view_out_of_the_buffer": (
        "GLB_PACKAGE",
        lambda d: d["bufferViews"][0].update(byteLength=2**31),
    ),
    "view_behind_the_buffer": (
        "GLB_PACKAGE",
        lambda d: d["bufferViews"][0].update(byteOffset=2**31),
    ),
    "view_of_text": ("GLB_PACKAGE", lambda d: d["bufferViews"][0].update(byteLength="64")),
    "buffer_of_a_file": ("GLB_PACKAGE", lambda d: d["buffers"][0].update(uri="a.bin")),
    "another_buffer": ("GLB_PACKAGE", lambda d: d["bufferViews"][0].update(buffer=1)),
    "moved_view": (
        "GLB_ALIGNMENT",
        lambda d: d["bufferViews"][0].update(byteOffset=4, byteLength=64),
    ),
    "package_cut": ("ZIP_TRUNCATED", lambda d: d["bufferViews"][0].update(byteLength=1024)),
    "view_at_half_a_byte": ("GLB_PACKAGE", lambda d: d["bufferViews"][0].update(byteOffset=64.5)),
    "view_of_nothing": ("GLB_PACKAGE", lambda d: d["bufferViews"].__setitem__(0, None)),
    "views_of_an_object": ("GLB_PACKAGE", lambda d: d.update(bufferViews={"0": {}})),
    "no_buffers": ("GLB_PACKAGE", lambda d: d.pop("buffers")),
    "extensions_of_a_list": (
        "GLB_NO_PACKAGE",
        lambda d: d["nodes"][-1].update(extensions=[EXTENSION]),
    ),
    "empty_package": ("GLB_PACKAGE", lambda d: d["bufferViews"][0].update(byteLength=0)),
    "buffer_that_is_false": ("GLB_PACKAGE", lambda d: d["bufferViews"][0].update(buffer=False)),
    "buffer_of_null": ("GLB_PACKAGE", lambda d: d["buffers"][0].update(uri=None)),
    "view_before_the_buffer": ("GLB_PACKAGE", lambda d: d["bufferViews"][0].update(byteOffset=-64)),
    "view_at_null": ("GLB_PACKAGE", lambda d: d["bufferViews"][0].update(byteOffset=None)),
    "view_far_away": ("GLB_PACKAGE", lambda d: d["bufferViews"][0].update(byteOffset=64 * 10**30)),
    "views_of_null": ("GLB_PACKAGE", lambda d: d.update(bufferViews=None)),
    "half_a_view": ("GLB_PACKAGE", lambda d: _record(d).update(package=0.5)),
    "view_of_a_list": ("GLB_PACKAGE", lambda d: _record(d).update(package=[0])),
    "view_of_long_text": ("GLB_PACKAGE", lambda d: _record(d).update(package="9" * 10**5)),
    "type_of_a_number": ("GLB_PACKAGE", lambda d: _record(d).update(mimeType=5)),
    "type_of_two_lines": ("GLB_PACKAGE", lambda d: _record(d).update(mimeType="a\nb\x1b[31m")),
    "record_of_null": (
        "GLB_NO_PACKAGE",
        lambda d: d["nodes"][-1]["extensions"].update({EXTENSION: None}),
    ),
    "second_package_broken": (
        "GLB_PACKAGE",
        lambda d: (_second(d), _record(d).update(package="x")),
    ),
    "not_a_number": ("JSON_NOT_FINITE", lambda d: d["nodes"][0].update(scale=[float("nan")] * 3)),
}
"""Name of a broken file -> its code, and what makes it of a good one's JSON."""


def _bound_to_it(document: Document) -> None:
    """Makes the node a joint of another mesh."""
    number = len(document["nodes"]) - 1
    document["skins"] = [{"joints": [number]}]
    document["nodes"].append({"mesh": 0, "skin": 0})
    document["scenes"][0]["nodes"].append(number + 1)


def _in_draco(document: Document) -> None:
    draco = {"KHR_draco_mesh_compression": {"bufferView": 1, "attributes": {"POSITION": 0}}}
    document["meshes"][0]["primitives"][0]["extensions"] = draco
    for name in ("extensionsUsed", "extensionsRequired"):
        document[name] = [*document.get(name, []), *draco]


def _sparse(document: Document) -> None:
    """An accessor of the fallback takes two billion numbers from the package."""
    view = {"bufferView": 0, "componentType": 5125}
    document["accessors"][0]["sparse"] = {"count": 2**31, "indices": view, "values": view}


HARMLESS: dict[str, Callable[[Document], object]] = {
    "stride_of_the_view": lambda d: d["bufferViews"][0].update(byteStride=64),
    "target_of_the_view": lambda d: d["bufferViews"][0].update(target=34962),
    "a_bone": _bound_to_it,
    "fallback_in_draco": _in_draco,
    "sparse_fallback": _sparse,
    "view_that_is_an_image": lambda d: d.update(
        images=[{"bufferView": 0, "mimeType": "image/png"}]
    ),
    "extension_on_a_scene": lambda d: d["scenes"][0].update(extensions={EXTENSION: {"package": 9}}),
}
"""Name of an odd file -> what makes it of a good one's JSON; the package is read as before."""


def _with_text(data: bytes, change: Callable[[bytes], bytes]) -> bytes:
    """The file with another text in place of its JSON."""
    at = data.index(b"BIN\0")
    return pack_glb(change(data[20 : at - 4]), data[at + 4 :])


def _with_length(data: bytes, length: int) -> bytes:
    """The file with another length of its binary chunk."""
    at = data.index(b"BIN\0")
    return data[: at - 4] + length.to_bytes(4, "little") + data[at:]


CUTS: dict[str, Callable[[bytes], bytes]] = {
    "cut": lambda data: data[:-100],
    "longer": lambda data: data + bytes(4),
    "four_bytes": lambda data: data[:4],
    "header_alone": lambda data: HEADER.pack(MAGIC, 2, 12),
    "version_1": lambda data: data[:4] + b"\1\0\0\0" + data[8:],
    "endless_json": lambda data: data[:12] + b"\xff\xff\xff\xff" + data[16:],
    "json_of_another_kind": lambda data: data[:16] + b"NOSJ" + data[20:],
    "no_json": lambda data: data[:20] + b"]" + data[21:],
    "deep": lambda data: pack_glb(b'{"a":' * 10**5 + b"0" + b"}" * 10**5, data[-4:]),
    "not_utf8": lambda data: pack_glb(b'{"a":"\xff"}', data[-4:]),
    "two_json_chunks": lambda data: data.replace(b"BIN\0", b"JSON", 1),
    "endless_buffer": lambda data: _with_length(data, 0xFFFFFFF0),
    "byte_order_mark": lambda data: _with_text(data, lambda text: b"\xef\xbb\xbf" + text),
    "utf16": lambda data: _with_text(data, lambda text: text.decode().encode("utf-16")),
    "comment": lambda data: _with_text(data, lambda text: text.rstrip()[:-1] + b"/* */}"),
    "padded_by_zeros": lambda data: _with_text(data, lambda text: text + bytes(64)),
    "half_a_surrogate": lambda data: _with_text(
        data, lambda text: text.rstrip()[:-1] + b',"extras":"\\ud800"}'
    ),
    "length_of_zero": lambda data: data[:8] + bytes(4) + data[12:],
    "bomb": lambda data: pack_glb(b'{"extras":[' + b"[]," * 2**22 + b"0]}", data[-4:]),
}
"""Name of a broken file -> what makes it of a good one's bytes; the code is GLB_CONTAINER."""


def broken_carriers(good: Path, folder: Path) -> list[Path]:
    """All broken files, made of a good one."""
    paths = [changed(good, folder / f"{name}.glb", CHANGES[name][1]) for name in CHANGES]
    for name, cut in CUTS.items():
        paths.append(folder / f"{name}.glb")
        paths[-1].write_bytes(cut(good.read_bytes()))
    return paths

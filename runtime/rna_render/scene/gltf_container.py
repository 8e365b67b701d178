"""glTF 2.0 files: their JSON, and the bytes, numbers and images that it refers to.

The reader is our own because trimesh's takes normalised and sparse accessors for plain ones, and
drops images that it cannot read, texture coordinates without a material and how images wrap, all
without a word. What is wrong raises whatever Python raises for it; `read_mesh_object` says where.
"""

import base64
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from rna_render.scene.limits import MAX_ZERO_ITEMS
from rna_sdk.errors import SceneError
from rna_sdk.files.regular_file import read_regular

# glTF 2.0, section 3.6.2.2: component types, and the divisors of normalised ones.
DTYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}

_LONGEST_REASON = 200
_LONGEST_URI = 512
"""Longest URI of another file; longer ones are data without `data:`, which flood errors."""

# Section 4.4: the binary container.
GLB_MAGIC, GLB_VERSION, CHUNK_JSON, CHUNK_BINARY = b"glTF", 2, b"JSON", b"BIN\0"


@dataclass(frozen=True, slots=True, eq=False)
class GltfContainer:
    """A glTF file. path: of it. json: its document. binary: of a .glb, its second chunk."""

    path: Path
    json: dict[str, Any]
    binary: bytes | None
    _buffers: dict[int, bytes]

    def accessor(self, number: int) -> np.ndarray:
        """The numbers of an accessor: (count, width), in their own dtype or decoded float32."""
        accessor = self.item("accessors", number)
        dtype, width = np.dtype(DTYPES[accessor["componentType"]]), WIDTHS[accessor["type"]]
        count = self.count(number)
        if accessor.get("bufferView") is not None:
            values = self._rows(accessor, dtype, width, count)
        else:
            if count > MAX_ZERO_ITEMS:
                raise ValueError(
                    f"accessor {number} has {count} items and no buffer view; "
                    f"at most {MAX_ZERO_ITEMS} can be without one"
                )
            values = np.zeros((count, width), dtype)
        if sparse := accessor.get("sparse"):
            values = values.copy()
            dtype_of_rows = np.dtype(DTYPES[sparse["indices"]["componentType"]])
            rows = self._rows(sparse["indices"], dtype_of_rows, 1, sparse["count"])[:, 0]
            values[rows] = self._rows(sparse["values"], dtype, width, sparse["count"])
        if accessor.get("normalized", False):
            return np.maximum(values / np.float32(np.iinfo(dtype).max), np.float32(-1))
        return values

    def count(self, number: int) -> int:
        """Number of items of an accessor. Raises ValueError if the file's value is no count."""
        count = self.item("accessors", number)["count"]
        if not isinstance(count, int) or count < 0:
            raise ValueError(f"accessor {number} has a count of {count!r}")
        return count

    def image(self, number: int) -> tuple[Path | bytes, object]:
        """An image's file or bytes, and its name in messages."""
        image = self.item("images", number)
        if "bufferView" in image:
            view = self.item("bufferViews", image["bufferView"])
            return self._view_bytes(view), f"{self.path}, image {number}"
        if image["uri"].startswith("data:"):
            return _data_uri(image["uri"]), f"{self.path}, image {number}"
        path = self._beside(image["uri"])
        return path, path

    def item(self, name: str, number: int) -> dict[str, Any]:
        """An object of an array of the document. Raises ValueError if it has no such item."""
        items: list[dict[str, Any]] = self.json[name]
        if not 0 <= number < len(items):
            raise ValueError(f"{name} has no item {number}")
        return items[number]

    def _rows(self, place: dict[str, Any], dtype: np.dtype, width: int, count: int) -> np.ndarray:
        """Items of a buffer view, with gaps of its stride: (count, width)."""
        view = self.item("bufferViews", place["bufferView"])
        data, start = self._view_bytes(view), place.get("byteOffset", 0)
        size = dtype.itemsize * width
        stride = view.get("byteStride", size)
        if (
            min(start, count) < 0
            or stride < size
            or start + (count - 1) * stride + size > len(data)
        ):
            raise ValueError(f"{count} items do not fit in their buffer view")
        strides = (stride, dtype.itemsize)
        return np.ndarray((count, width), dtype, data, start, strides).copy()

    def _view_bytes(self, view: dict[str, Any]) -> bytes:
        data = self._buffer(view["buffer"])
        start, length = view.get("byteOffset", 0), view["byteLength"]
        if min(start, length) < 0 or start + length > len(data):
            raise ValueError("a buffer view ends behind its buffer")
        return data[start : start + length]

    def _buffer(self, number: int) -> bytes:
        if number not in self._buffers:
            buffer = self.item("buffers", number)
            self._buffers[number] = self._buffer_bytes(buffer)
        return self._buffers[number]

    def _buffer_bytes(self, buffer: dict[str, Any]) -> bytes:
        uri = buffer.get("uri")
        if uri is None:
            if self.binary is None:
                raise ValueError("a buffer has no uri, and there is no binary chunk")
            return self.binary
        if uri.startswith("data:"):
            return _data_uri(uri)
        path = self._beside(uri)
        try:
            return read_regular(path)
        except OSError as error:
            raise SceneError(error.strerror or str(error), file=path) from error

    def _beside(self, uri: str) -> Path:
        if len(uri) > _LONGEST_URI:
            raise ValueError(f"a uri of {len(uri)} characters, which begins with {uri[:40]!r}")
        return self.path.parent / unquote(uri)


def reason_of(error: Exception) -> str:
    """The fault of a broken file in a line, from the error of reading it, of whatever type."""
    said = " ".join(str(error).split())[:_LONGEST_REASON]
    if isinstance(error, KeyError):
        return f"{said} is missing or unknown"
    if isinstance(error, IndexError):
        return "an index is beyond the last item"
    if isinstance(error, TypeError | AttributeError):
        return "a value has another type than it should"
    return said if isinstance(error, ValueError) else f"{type(error).__name__} {said}".strip()


def open_gltf(path: Path) -> GltfContainer:
    """A .gltf or .glb file; OSError or ValueError if it is not there or is none."""
    data, binary = read_regular(path), None
    if path.suffix.lower() == ".glb":
        data, binary = _glb_chunks(data)
    try:
        document = json.loads(data)
    except UnicodeDecodeError as error:
        raise ValueError("it is not UTF-8 text") from error
    if not isinstance(document, dict):
        raise ValueError("it is not a JSON object")
    version = str(document["asset"]["version"])
    if version.split(".")[0] != "2":
        raise ValueError(f"it has glTF's version {version}, not 2")
    return GltfContainer(path, document, binary, {})


def _glb_chunks(data: bytes) -> tuple[bytes, bytes | None]:
    if data[:4] != GLB_MAGIC or int.from_bytes(data[4:8], "little") != GLB_VERSION:
        raise ValueError("it does not start as a .glb of version 2 does")
    chunks: dict[bytes, bytes] = {}
    start = 12
    while start + 8 <= len(data):
        length, kind = (
            int.from_bytes(data[start : start + 4], "little"),
            data[start + 4 : start + 8],
        )
        if start + 8 + length > len(data):
            raise ValueError("it ends within a chunk")
        chunks.setdefault(kind, data[start + 8 : start + 8 + length])
        start += 8 + length
    if CHUNK_JSON not in chunks:
        raise ValueError("it has no JSON chunk")
    return chunks[CHUNK_JSON], chunks.get(CHUNK_BINARY)


def _data_uri(uri: str) -> bytes:
    head, comma, body = uri.partition(",")
    if not comma or not head.endswith(";base64"):
        raise ValueError("a data: URI is not in base64")
    return base64.b64decode(body, validate=True)

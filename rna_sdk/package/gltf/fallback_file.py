"""The file of a fallback while it grows: the package first, then what the package does not hold."""

import io
from collections.abc import Mapping
from pathlib import PurePosixPath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.geometry import gltf_model as gltf
from rna_sdk.package.gltf.carrier import EXTENSION
from rna_sdk.package.gltf.carrier_writer import carrying, packed
from rna_sdk.package.manifest.manifest_model import Wrap
from rna_sdk.package.package import Package

IMAGES = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg"}
"""Media types of the images that viewers know, by suffix."""

REPEAT: tuple[Wrap, Wrap] = ("repeat", "repeat")
CLAMP: tuple[Wrap, Wrap] = ("clamp", "clamp")

_WRAPS = {"repeat": 10497, "clamp": 33071, "mirror": 33648}
_WITHOUT_MIPMAPS = {"magFilter": 9729, "minFilter": 9729}
_FULL = 65535


class FallbackFile:
    """The arrays of a glTF document that grow, and its buffer, which begins with the package."""

    def __init__(self, package: Package) -> None:
        self._package = package
        self._lists: dict[str, list[dict[str, Any]]] = {}
        self._blob: list[bytes | memoryview] = []
        self._size = 0
        self._textures: dict[tuple[str, tuple[Wrap, Wrap]], dict[str, int]] = {}
        self.view(self.append(package.file_data), len(package.file_data))
        self.is_quantised = False
        self.extensions: set[str] = set()

    def add(self, name: str, member: dict[str, Any]) -> int:
        """Append to the array `name`; its index there."""
        members = self._lists.setdefault(name, [])
        members.append(member)
        return len(members) - 1

    def view(self, start: int, size: int, **members: int) -> int:
        """A buffer view."""
        view = {"buffer": 0, "byteOffset": start, "byteLength": size, **members}
        return self.add("bufferViews", view)

    def colors(self, colors: NDArray[np.float32]) -> int:
        """An accessor of linear colours (v, 3) from 0 to 1, in 16 bits a channel."""
        return self._shares(np.column_stack([colors, np.ones(len(colors), colors.dtype)]), "VEC4")

    def coordinates(self, places: NDArray[np.float64]) -> int:
        """An accessor of texture coordinates (v, 2) from 0 to 1, in 16 bits each."""
        return self._shares(places, "VEC2")

    def _shares(self, values: NDArray[np.floating], kind: str) -> int:
        rows = np.rint(np.clip(values, 0.0, 1.0) * values.dtype.type(_FULL)).astype("<u2")
        view = self.view(self.append(rows.tobytes()), rows.nbytes, target=gltf.ARRAY_BUFFER)
        form = {"componentType": gltf.UNSIGNED_SHORT, "normalized": True, "type": kind}
        return self.add("accessors", {"bufferView": view, "count": len(rows), **form})

    def texture(self, pixels: NDArray[np.uint8], is_palette: bool = False) -> dict[str, int]:
        """A texture of (h, w, 3 or 4); a palette does not repeat, and its texels are not mixed."""
        png = _png(pixels)
        form = (CLAMP, _WITHOUT_MIPMAPS) if is_palette else (REPEAT, {})
        return self._texture(self.append(png), len(png), "image/png", *form)

    def texture_of(self, entry: str, wrap: tuple[Wrap, Wrap] = REPEAT) -> dict[str, int]:
        """A texture that is an image of the package."""
        if (entry, wrap) not in self._textures:
            data, start = self._package.entry(entry)
            start = self.append(data) if start is None else start
            kind = IMAGES[PurePosixPath(entry).suffix]
            self._textures[entry, wrap] = self._texture(start, len(data), kind, wrap, {})
        return self._textures[entry, wrap]

    def packed(self, **asset: str) -> bytes:
        """The file."""
        parts = list(range(len(self._lists["nodes"])))
        name = self._package.manifest.name
        root = self.add("nodes", {"name": name, "children": parts, "extensions": carrying(0)})
        document: dict[str, Any] = {
            "asset": {"version": "2.0", **asset},
            "extensionsUsed": [EXTENSION, *sorted(self.extensions)],
            "scene": 0,
            "scenes": [{"nodes": [root]}],
            **self._lists,
        }
        if self.is_quantised:
            document["extensionsUsed"].append(gltf.QUANTIZATION)
            document["extensionsRequired"] = [gltf.QUANTIZATION]
        return packed(document, b"".join(self._blob))

    def _texture(
        self,
        start: int,
        size: int,
        kind: str,
        wrap: tuple[Wrap, Wrap],
        filters: Mapping[str, int],
    ) -> dict[str, int]:
        image = self.add("images", {"bufferView": self.view(start, size), "mimeType": kind})
        sampler = dict(zip(("wrapS", "wrapT"), (_WRAPS[side] for side in wrap), strict=True))
        sampler |= filters
        samplers = self._lists.setdefault("samplers", [])
        if sampler not in samplers:
            samplers.append(sampler)
        place = {"source": image, "sampler": samplers.index(sampler)}
        return {"index": self.add("textures", place)}

    def append(self, data: bytes | memoryview) -> int:
        """Where the bytes are in the buffer, once they are in it; a multiple of 4."""
        start = self._size
        padding = bytes(-len(data) % 4)
        self._blob += [data, padding]
        self._size += len(data) + len(padding)
        return start


def _png(pixels: NDArray[np.uint8]) -> bytes:
    """A PNG of (h, w, 3 or 4) uint8."""
    from PIL import Image  # loads with the first image

    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "PNG")
    return file.getvalue()

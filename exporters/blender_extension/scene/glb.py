"""Writes binary glTF 2.0: triangles with materials and textures."""

import json
import struct

import numpy as np

_FLOAT = 5126
_TYPES = {2: "VEC2", 3: "VEC3", 4: "VEC4"}


class Glb:
    """One mesh of several primitives, each of its own material."""

    def __init__(self):
        self._buffer = bytearray()
        self._json = {"bufferViews": [], "accessors": [], "materials": [], "primitives": []}
        self._images, self._extensions = [], set()
        self._seen = {}

    def add_material(self, material):
        """A glTF material, as a mapping; returns its index."""
        self._extensions |= set(material.get("extensions", ()))
        self._json["materials"].append(material)
        return len(self._json["materials"]) - 1

    def add_texture(self, data, media_type):
        """The bytes of a PNG or JPEG; returns the index of a texture. The same bytes once."""
        if data not in self._seen:
            self._images.append({"bufferView": self._add_view(data), "mimeType": media_type})
            self._seen[data] = len(self._images) - 1
        return self._seen[data]

    def add_triangles(self, material, **attributes):
        """Three rows a triangle. attributes: NORMAL and so on, (3 t, 2 to 4) float32.

        material: its index, or None.
        """
        rows = {name: self._add_rows(name, values) for name, values in attributes.items()}
        primitive = {"attributes": rows}
        if material is not None:
            primitive["material"] = material
        self._json["primitives"].append(primitive)

    def _add_rows(self, name, values):
        values = np.ascontiguousarray(values, np.float32)
        accessor = {
            "bufferView": self._add_view(values.tobytes()),
            "componentType": _FLOAT,
            "count": len(values),
            "type": _TYPES[values.shape[1]],
        }
        if name == "POSITION":
            accessor["min"], accessor["max"] = (
                f(axis=0).tolist() for f in (values.min, values.max)
            )
        self._json["accessors"].append(accessor)
        return len(self._json["accessors"]) - 1

    def _add_view(self, data):
        self._buffer += bytes(-len(self._buffer) % 4)
        view = {"buffer": 0, "byteOffset": len(self._buffer), "byteLength": len(data)}
        self._json["bufferViews"].append(view)
        self._buffer += data
        return len(self._json["bufferViews"]) - 1

    def to_bytes(self):
        """The file."""
        document = self._json
        self._buffer += bytes(-len(self._buffer) % 4)
        described = {
            "asset": {"version": "2.0", "generator": "RNA SDK extension for Blender"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": document["primitives"]}],
            "accessors": document["accessors"],
            "bufferViews": document["bufferViews"],
            "buffers": [{"byteLength": len(self._buffer)}],
        }
        if document["materials"]:
            described["materials"] = document["materials"]
        if self._images:
            described["images"] = self._images
            described["textures"] = [{"source": k} for k in range(len(self._images))]
        if self._extensions:
            described["extensionsUsed"] = sorted(self._extensions)
        text = json.dumps(described).encode()
        text += b" " * (-len(text) % 4)
        total = 12 + 8 + len(text) + 8 + len(self._buffer)
        head = struct.pack("<III", 0x46546C67, 2, total)
        chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
        return head + chunks + struct.pack("<II", len(self._buffer), 0x004E4942) + self._buffer

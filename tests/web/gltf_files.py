"""Binary glTF files with packages inside, beside a cube that stands for them."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from rna_sdk.package.geometry.glb_writer import pack_glb

EXTENSION = "RNA_relightable_asset"
CUBE = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], "<f4")
FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
TRIANGLES = np.array([[f[0], f[j], f[j + 1]] for f in FACES for j in (1, 2)], "<u2")
COMPONENTS = {"<f4": 5126, "<u2": 5123}
TYPES = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}


class GltfFile:
    """A red cube as mesh 0, and additions; `document` is the JSON."""

    def __init__(self) -> None:
        self.binary = b""
        self.document: dict[str, Any] = {
            "asset": {"version": "2.0"},
            "extensionsUsed": [EXTENSION],
            "scenes": [{"nodes": [0]}],
            "bufferViews": [],
            "accessors": [],
            "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
        }
        positions, indices = self.accessor(CUBE), self.accessor(TRIANGLES.reshape(-1, 1))
        sides = {"min": CUBE.min(axis=0).tolist(), "max": CUBE.max(axis=0).tolist()}
        self.document["accessors"][positions] |= sides
        corners = {"attributes": {"POSITION": positions}, "indices": indices, "material": 0}
        self.document["meshes"] = [{"primitives": [corners]}]

    def view(self, data: bytes) -> int:
        """The index of a buffer view of these bytes."""
        self.binary += bytes(-len(self.binary) % 64)
        view = {"buffer": 0, "byteOffset": len(self.binary), "byteLength": len(data)}
        self.document["bufferViews"].append(view)
        self.binary += data
        return len(self.document["bufferViews"]) - 1

    def accessor(self, values: np.ndarray) -> int:
        """The index of an accessor of (n, items) values."""
        record = {
            "bufferView": self.view(values.tobytes()),
            "componentType": COMPONENTS[values.dtype.str],
            "count": len(values),
            "type": TYPES[values.shape[1]],
        }
        self.document["accessors"].append(record)
        return len(self.document["accessors"]) - 1

    def to_bytes(self) -> bytes:
        self.document["buffers"] = [{"byteLength": len(self.binary)}]
        document = json.dumps(self.document).encode()
        return pack_glb(document + b" " * ((36 - len(document)) % 64), self.binary)


def asset_node(package: int, **more: Any) -> dict[str, Any]:
    """A node with the package of a buffer view, in whose place others show the cube."""
    extension = {"package": package, "mimeType": "model/vnd.rna"}
    return {"mesh": 0, "extensions": {EXTENSION: extension}, **more}


def write_gltf(path: Path, packages: Sequence[Path]) -> Path:
    """A node for each package."""
    file = GltfFile()
    views = [file.view(package.read_bytes()) for package in packages]
    file.document["nodes"] = [asset_node(view) for view in views]
    file.document["scenes"] = [{"nodes": list(range(len(views)))}]
    path.write_bytes(file.to_bytes())
    return path

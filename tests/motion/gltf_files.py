"""Small glTF files that move: nodes, skins and morph targets."""

import base64
import json
from pathlib import Path
from typing import Any

import numpy as np

from rna_sdk.package import Mesh

TYPES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
COMPONENTS = {"float32": 5126, "uint32": 5125, "uint16": 5123, "uint8": 5121}


class GltfFile:
    """A document that arrays are added to. Members of the document are set in `data`."""

    def __init__(self) -> None:
        self.data: dict[str, Any] = {"asset": {"version": "2.0"}, "scene": 0, "accessors": []}
        self.data |= {"bufferViews": [], "animations": []}
        self._bytes = b""

    def add(self, array: np.ndarray) -> int:
        """The number of a new accessor."""
        rows = array.reshape(len(array), -1)
        view = {"buffer": 0, "byteOffset": len(self._bytes), "byteLength": array.nbytes}
        self.data["bufferViews"].append(view)
        self._bytes += np.ascontiguousarray(array).tobytes() + b"\0" * (-array.nbytes % 4)
        accessor = {"bufferView": len(self.data["bufferViews"]) - 1, "count": len(array)}
        accessor |= {"componentType": COMPONENTS[array.dtype.name], "type": TYPES[rows.shape[1]]}
        self.data["accessors"].append(accessor)
        return len(self.data["accessors"]) - 1

    def mesh(self, mesh: Mesh, **attributes: np.ndarray) -> dict[str, Any]:
        """A glTF mesh of one primitive."""
        named = {"POSITION": mesh.positions, "NORMAL": mesh.normals, **attributes}
        indices = self.add(mesh.triangles.reshape(-1))
        primitive = {"attributes": {k: self.add(v) for k, v in named.items()}, "indices": indices}
        return {"primitives": [primitive]}

    def animate(self, tracks: list[tuple[int, str, Any, Any]], kind: str = "LINEAR") -> None:
        """An animation of tracks: node, path, times, values."""
        samplers = [
            {
                "input": self.add(np.float32(t)),
                "output": self.add(np.float32(v)),
                "interpolation": kind,
            }
            for _, _, t, v in tracks
        ]
        channels = [
            {"sampler": k, "target": {"node": node, "path": path}}
            for k, (node, path, _, _) in enumerate(tracks)
        ]
        self.data["animations"].append({"name": "clip", "samplers": samplers, "channels": channels})

    def write(self, path: Path) -> Path:
        """As .gltf, with the buffer inside."""
        uri = "data:application/octet-stream;base64," + base64.b64encode(self._bytes).decode()
        self.data["buffers"] = [{"byteLength": len(self._bytes), "uri": uri}]
        path.write_text(json.dumps(self.data))
        return path


def quaternion(axis: tuple[float, float, float], degrees: float) -> list[float]:
    """x, y, z, w."""
    half = np.radians(degrees) / 2
    return [*(np.sin(half) * np.array(axis)), np.cos(half)]


def moving_node(path: Path, mesh: Mesh, tracks: Any, kind: str = "LINEAR") -> Path:
    """A mesh on node 0, which `tracks` move: (path, times, values)."""
    file = GltfFile()
    file.data |= {"meshes": [file.mesh(mesh)], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}]}
    file.animate([(0, *track) for track in tracks], kind=kind)
    return file.write(path)


def bending_arm(path: Path, mesh: Mesh, degrees: float) -> Path:
    """A mesh on two bones: the part beyond the middle of x turns about z, within 1 s, and with a
    soft seam."""
    low, high = mesh.positions[:, 0].min(), mesh.positions[:, 0].max()
    middle = mesh.positions.mean(axis=0)
    middle[0] = (low + high) / 2
    share = np.clip((mesh.positions[:, 0] - low) / (high - low) * 4 - 1.5, 0, 1)
    zero = np.zeros_like(share)
    file = GltfFile()
    weights = np.float32(np.stack([1 - share, share, zero, zero], axis=1))
    joints = np.tile(np.uint16([0, 1, 0, 0]), (len(share), 1))
    inverse = np.tile(np.eye(4, dtype=np.float32), (2, 1, 1))
    inverse[1, 3, :3] = -middle  # column-major
    skin = {"joints": [1, 2], "inverseBindMatrices": file.add(inverse.reshape(2, 16))}
    file.data |= {
        "meshes": [file.mesh(mesh, JOINTS_0=joints, WEIGHTS_0=weights)],
        "nodes": [
            {"mesh": 0, "skin": 0, "translation": [9, 9, 9]},  # which a skin ignores
            {"children": [2]},
            {"translation": middle.tolist()},
        ],
        "scenes": [{"nodes": [0, 1]}],
        "skins": [skin],
    }
    turns = [quaternion((0, 0, 1), angle) for angle in (0, degrees)]
    file.animate([(2, "rotation", [0, 1], turns)])
    return file.write(path)

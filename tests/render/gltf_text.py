"""Small glTF files of glass."""

import json
from collections.abc import Sequence

import numpy as np
import trimesh

from rna_sdk.package.container.glb_chunks import pack_glb


def box_glb(
    size: Sequence[float],
    colour: Sequence[float] = (1.0, 1.0, 1.0),
    distance: float = 1.0,
    share: float = 1.0,
) -> bytes:
    """A box about the origin, of glass that leaves a colour of light after a distance."""
    box = trimesh.creation.box(size)
    points = np.asarray(box.vertices[box.faces].reshape(-1, 3), np.float32)
    volume = {
        "thicknessFactor": 1.0,
        "attenuationColor": list(colour),
        "attenuationDistance": distance,
    }
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
        "materials": [
            {
                "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
                "extensions": {
                    "KHR_materials_transmission": {"transmissionFactor": share},
                    "KHR_materials_ior": {"ior": 1.5},
                    "KHR_materials_volume": volume,
                },
            }
        ],
        "accessors": [
            {
                "bufferView": 0,
                "componentType": 5126,
                "count": len(points),
                "type": "VEC3",
                "min": points.min(axis=0).tolist(),
                "max": points.max(axis=0).tolist(),
            }
        ],
        "bufferViews": [{"buffer": 0, "byteLength": points.nbytes}],
        "buffers": [{"byteLength": points.nbytes}],
    }
    return pack_glb(json.dumps(document, default=float).encode(), points.tobytes())

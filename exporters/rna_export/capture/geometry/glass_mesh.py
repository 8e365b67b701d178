"""The glass that is left to hosts, as a .glb: KHR_materials_transmission, _volume and _ior."""

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from rna_export.capture.geometry.mesh_cleanup import welded
from rna_export.capture.preflight.material_record import Glass
from rna_sdk.package import Mesh
from rna_sdk.package.container.glb_chunks import pack_glb

_EXTENSIONS = ["KHR_materials_transmission", "KHR_materials_volume", "KHR_materials_ior"]
_FLOAT, _UNSIGNED = 5126, 5125


def glass_glb(corners: Mapping[str, np.ndarray], glass: Sequence[Glass]) -> bytes | None:
    """One mesh with a primitive a material, +Y up, metres; None without a triangle.

    corners: of `BlenderWorker.export_corners`, with the materials by their full name.
    """
    meshes = {each.full_name: _mesh(corners, each.full_name) for each in glass}
    shown = [(each, mesh) for each in glass if (mesh := meshes[each.full_name]) is not None]
    if not shown:
        return None
    blob = b""
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []
    primitives: list[dict[str, Any]] = []
    for number, (_, mesh) in enumerate(shown):
        first = len(accessors)
        for array in (mesh.positions, mesh.normals, mesh.triangles.reshape(-1).astype(np.uint32)):
            views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": array.nbytes})
            accessors.append(_accessor(len(views) - 1, array, with_range=array is mesh.positions))
            blob += np.ascontiguousarray(array, array.dtype.newbyteorder("<")).tobytes()
        attributes = {"POSITION": first, "NORMAL": first + 1}
        primitives.append({"attributes": attributes, "indices": first + 2, "material": number})
    document = {
        "asset": {"version": "2.0", "generator": "rna-capture"},
        "extensionsUsed": _EXTENSIONS,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "glass"}],
        "meshes": [{"primitives": primitives}],
        "materials": [_material(each, mesh) for each, mesh in shown],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(blob)}],
    }
    return pack_glb(json.dumps(document).encode(), blob)


def _mesh(corners: Mapping[str, np.ndarray], name: str) -> Mesh | None:
    of = np.flatnonzero(corners["material"] == name)
    if not len(of):
        return None
    rows = (3 * of[:, None] + np.arange(3)).ravel()
    chosen = {key: corners[key][rows] for key in ("positions", "normals")}
    return welded({**chosen, "has_uv": np.zeros((), bool)})[0]


def _accessor(view: int, array: np.ndarray, with_range: bool) -> dict[str, Any]:
    is_vector = array.ndim == 2
    described = {
        "bufferView": view,
        "componentType": _FLOAT if is_vector else _UNSIGNED,
        "count": len(array),
        "type": "VEC3" if is_vector else "SCALAR",
    }
    if with_range:
        low, high = array.min(axis=0), array.max(axis=0)
        described |= {"min": low.tolist(), "max": high.tolist()}
    return described


def _material(glass: Glass, mesh: Mesh) -> dict[str, Any]:
    low, high = mesh.box()
    volume: dict[str, Any] = {"thicknessFactor": float((high - low).min())}
    strongest = max(glass.absorption)
    if strongest > 0.0:
        # After this distance a third is left of the colour that is absorbed most.
        volume["attenuationDistance"] = 1.0 / strongest
        volume["attenuationColor"] = [float(np.exp(-a / strongest)) for a in glass.absorption]
    return {
        "name": glass.name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [*glass.tint, 1.0],
            "metallicFactor": 0.0,
            "roughnessFactor": glass.roughness,
        },
        "extensions": {
            "KHR_materials_transmission": {"transmissionFactor": 1.0},
            "KHR_materials_ior": {"ior": glass.ior},
            "KHR_materials_volume": volume,
        },
    }

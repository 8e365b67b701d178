"""Write a mesh as the binary glTF of the package; `glb_reader` is the inverse."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package.container.glb_chunks import pack_glb
from rna_sdk.package.geometry import gltf_model as gltf
from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.package.geometry.quantised_mesh import QuantisedMesh

_COMPONENTS: dict[np.dtype[Any], gltf.ComponentType] = {
    np.dtype(np.float32): gltf.FLOAT,
    np.dtype(np.uint32): gltf.UNSIGNED_INT,
    np.dtype(np.uint16): gltf.UNSIGNED_SHORT,
    np.dtype(np.int16): gltf.SHORT,
}


@dataclass(frozen=True)
class _Array:
    """An array of the file: its rows, their type, and the bytes from one to the next."""

    rows: NDArray[Any]
    is_index: bool = False
    normalized: bool = False
    stride: gltf.Stride | None = None
    with_range: bool = False


def mesh_to_glb(mesh: Mesh) -> bytes:
    """The mesh as .glb that any glTF 2.0 viewer opens. The same arrays give the same bytes."""
    stored = mesh.quantised
    arrays = _exact(mesh) if stored is None else _quantised(stored)
    views, accessors, blob = [], [], b""
    for i, array in enumerate(arrays):
        blob += bytes(-len(blob) % 4)
        data = _bytes(array)
        views.append(
            gltf.BufferView(
                buffer=0,
                byte_offset=len(blob),
                byte_length=len(data),
                byte_stride=array.stride,
                target=gltf.ELEMENT_ARRAY_BUFFER if array.is_index else gltf.ARRAY_BUFFER,
            )
        )
        accessors.append(_accessor(i, array))
        blob += data
    named = None if stored is None else (gltf.QUANTIZATION,)
    document = gltf.Gltf(
        asset=gltf.Asset(version="2.0"),
        extensions_used=named,
        extensions_required=named,
        scenes=(gltf.Scene(nodes=(0,)),),
        nodes=(_node(stored),),
        meshes=(gltf.GltfMesh(primitives=(_primitive(mesh.uvs is not None),)),),
        accessors=tuple(accessors),
        buffer_views=tuple(views),
        buffers=(gltf.Buffer(byte_length=len(blob)),),
    )
    return pack_glb(document.model_dump_json(exclude_none=True).encode(), blob)


def _exact(mesh: Mesh) -> list[_Array]:
    """Arrays of an unquantised mesh in the order of the accessors."""
    vertices = [_Array(mesh.positions, with_range=True), _Array(mesh.normals)]
    if mesh.uvs is not None:
        vertices.append(_Array(mesh.uvs))
    return [*vertices, _Array(mesh.triangles.reshape(-1, 1), is_index=True)]


def _quantised(mesh: QuantisedMesh) -> list[_Array]:
    """The arrays of a quantised mesh, as `_exact`."""
    stride: gltf.Stride = gltf.QUANTISED_STRIDE
    vertices = [
        _Array(mesh.positions, stride=stride, with_range=True),
        _Array(mesh.normals, stride=stride, normalized=True),
    ]
    if mesh.uvs is not None:
        short = mesh.uvs.dtype == np.uint16
        vertices.append(_Array(mesh.uvs, stride=4 if short else None, normalized=short))
    index = np.uint16 if len(mesh.positions) < gltf.MAX_SHORT_INDICES else np.uint32
    return [*vertices, _Array(mesh.triangles.reshape(-1, 1).astype(index), is_index=True)]


def _node(mesh: QuantisedMesh | None) -> gltf.Node:
    if mesh is None:
        return gltf.Node(mesh=0)
    x, y, z = mesh.translation.tolist()
    scale = float(mesh.scale[0])
    return gltf.Node(mesh=0, translation=(x, y, z), scale=(scale, scale, scale))


def _bytes(array: _Array) -> bytes:
    rows = np.ascontiguousarray(array.rows, array.rows.dtype.newbyteorder("<"))
    if array.stride is None:
        return rows.tobytes()
    padded = np.zeros((len(rows), array.stride), np.uint8)
    padded[:, : rows.shape[1] * rows.itemsize] = rows.view(np.uint8)
    return padded.tobytes()


def _primitive(has_uvs: bool) -> gltf.Primitive:
    attributes = gltf.Attributes(POSITION=0, NORMAL=1, TEXCOORD_0=2 if has_uvs else None)
    return gltf.Primitive(attributes=attributes, indices=3 if has_uvs else 2)


def _accessor(view: int, array: _Array) -> gltf.Accessor:
    rows = array.rows
    return gltf.Accessor(
        buffer_view=view,
        component_type=_COMPONENTS[rows.dtype.newbyteorder("=")],
        normalized=array.normalized,
        count=len(rows),
        type=next(shape for shape, n in gltf.WIDTHS.items() if n == rows.shape[1]),
        min=tuple(rows.min(axis=0).tolist()) if array.with_range else None,
        max=tuple(rows.max(axis=0).tolist()) if array.with_range else None,
    )

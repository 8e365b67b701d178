"""Write a mesh as the binary glTF of the package; `glb_reader` is the inverse."""

from __future__ import annotations

import struct

import numpy as np
from numpy.typing import NDArray

from rna_sdk.package import gltf
from rna_sdk.package.mesh import Mesh

MAGIC = b"glTF"
CHUNK_JSON = b"JSON"
CHUNK_BIN = b"BIN\0"
HEADER = struct.Struct("<4sII")
CHUNK = struct.Struct("<I4s")


def mesh_to_glb(mesh: Mesh) -> bytes:
    """The mesh as .glb that any glTF 2.0 viewer opens. The same arrays give the same bytes."""
    arrays: list[NDArray[np.float32] | NDArray[np.uint32]] = [mesh.positions, mesh.normals]
    if mesh.uvs is not None:
        arrays.append(mesh.uvs)
    arrays.append(mesh.triangles.reshape(-1, 1))
    views, accessors, blob = [], [], b""
    for i, array in enumerate(arrays):
        is_index = array.dtype == np.uint32
        data = np.ascontiguousarray(array, array.dtype.newbyteorder("<")).tobytes()
        views.append(
            gltf.BufferView(
                buffer=0,
                byte_offset=len(blob),
                byte_length=len(data),
                target=gltf.ELEMENT_ARRAY_BUFFER if is_index else gltf.ARRAY_BUFFER,
            )
        )
        accessors.append(_accessor(i, array, with_range=i == 0))
        blob += data
    document = gltf.Gltf(
        asset=gltf.Asset(version="2.0"),
        scenes=(gltf.Scene(nodes=(0,)),),
        nodes=(gltf.Node(mesh=0),),
        meshes=(gltf.GltfMesh(primitives=(_primitive(mesh.uvs is not None),)),),
        accessors=tuple(accessors),
        buffer_views=tuple(views),
        buffers=(gltf.Buffer(byte_length=len(blob)),),
    )
    return pack_glb(document.model_dump_json(exclude_none=True).encode(), blob)


def pack_glb(document: bytes, blob: bytes) -> bytes:
    """A .glb of a JSON chunk and a binary chunk, each padded to 4 bytes (glTF 2.0, 4.4)."""
    document += b" " * (-len(document) % 4)
    blob += bytes(-len(blob) % 4)
    size = HEADER.size + 2 * CHUNK.size + len(document) + len(blob)
    return b"".join(
        (
            HEADER.pack(MAGIC, 2, size),
            CHUNK.pack(len(document), CHUNK_JSON),
            document,
            CHUNK.pack(len(blob), CHUNK_BIN),
            blob,
        )
    )


def _primitive(has_uvs: bool) -> gltf.Primitive:
    attributes = gltf.Attributes(POSITION=0, NORMAL=1, TEXCOORD_0=2 if has_uvs else None)
    return gltf.Primitive(attributes=attributes, indices=3 if has_uvs else 2)


def _accessor(
    view: int, array: NDArray[np.float32] | NDArray[np.uint32], *, with_range: bool
) -> gltf.Accessor:
    return gltf.Accessor(
        buffer_view=view,
        component_type=gltf.UNSIGNED_INT if array.dtype == np.uint32 else gltf.FLOAT,
        count=len(array),
        type=next(shape for shape, n in gltf.WIDTHS.items() if n == array.shape[1]),
        min=tuple(array.min(axis=0).tolist()) if with_range else None,
        max=tuple(array.max(axis=0).tolist()) if with_range else None,
    )

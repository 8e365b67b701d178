"""An asset that modifiers or shape keys deform, as a motion file of one frame."""

import hashlib
import json
import struct

import numpy as np

from ..axes import from_blender
from ..properties import package_of

_DTYPES = {np.dtype("<f4"): "F32", np.dtype("u1"): "U8"}


def is_deformed(item):
    """Whether something may deform an object. item: evaluated."""
    return bool(item.original.modifiers or getattr(item.original.data, "shape_keys", None))


def parts_of(item, depsgraph):
    """The evaluated objects of an asset's parts, in order. item: of the first, evaluated."""
    parts = {0: item}
    for child in item.original.children:
        record = package_of(child)
        if record is not None and record.path == package_of(item.original).path:
            parts[record.part] = child.evaluated_get(depsgraph)
    return [parts[number] for number in sorted(parts)]


def write_motion(parts, path):
    """Write where the points of an asset's parts are; returns why there is none, or None.

    parts: as of `parts_of`.
    """
    arrays = {"rate": np.float32([24.0])}
    shapes = [_shape(part) for part in parts]
    for part, (links, _, count) in zip(parts, shapes, strict=True):
        if (len(links), count) != _size(part.original.data):
            return "modifiers that change an asset's points or faces are left out"
    hashes = [hashlib.sha256(links.astype("<u4").tobytes()).digest() for links, _, _ in shapes]
    arrays["topology"] = np.frombuffer(b"".join(hashes), np.uint8).reshape(-1, 32)
    for number, (_, points, _) in enumerate(shapes):
        arrays[f"part.{number}"] = from_blender(points)[None]
    path.write_bytes(_tensors(arrays))
    return None


def _size(data):
    """Numbers of links and of points of a mesh or hair."""
    if hasattr(data, "polygons"):
        return len(data.loops), len(data.vertices)
    return len(data.curves) + 1, len(data.points)


def _shape(item):
    """Connections of a part's points, the points in Blender's axes, and their number."""
    if item.type == "CURVES":
        data = item.data
        links = _read(data.curve_offset_data, "value", 1, np.int32).reshape(-1)
        return links, _read(data.position_data, "vector", 3), len(data.points)
    mesh = item.to_mesh()
    try:
        links = _read(mesh.loops, "vertex_index", 1, np.int32).reshape(-1)
        return links, _read(mesh.vertices, "co", 3), len(mesh.vertices)
    finally:
        item.to_mesh_clear()


def _read(collection, name, width, dtype=np.float32):
    values = np.empty(len(collection) * width, dtype)
    collection.foreach_get(name, values)
    return values.reshape(-1, width)


def _tensors(arrays):
    """A safetensors file whose data starts at a multiple of 64."""
    header, blocks, place = {}, [], 0
    for name, array in arrays.items():
        data = np.ascontiguousarray(array).tobytes()
        offsets = [place, place + len(data)]
        dtype, shape = _DTYPES[array.dtype], list(array.shape)
        header[name] = {"dtype": dtype, "shape": shape, "data_offsets": offsets}
        blocks.append(data)
        place += len(data)
    text = json.dumps(header).encode()
    text += b" " * (-(len(text) + 8) % 64)
    return struct.pack("<Q", len(text)) + text + b"".join(blocks)

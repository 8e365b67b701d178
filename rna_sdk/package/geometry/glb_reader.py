"""Read the package's binary glTF from hostile bytes; `glb_writer` is the inverse."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from rna_sdk.package.container.glb_chunks import CHUNK, CHUNK_BIN, CHUNK_JSON, HEADER, MAGIC
from rna_sdk.package.container.strict_json import model_of, parse_object, pointer
from rna_sdk.package.geometry import gltf_model as gltf
from rna_sdk.package.geometry.glb_forms import AccessorForm, accessor_forms
from rna_sdk.package.geometry.mesh import Mesh
from rna_sdk.package.geometry.quantised_mesh import QuantisedMesh, stored_normals
from rna_sdk.package.issues import Code, refuse
from rna_sdk.package.limits import MAX_GLTF_JSON_BYTES

NORMAL_TOLERANCE = 1e-3


def mesh_from_glb(data: memoryview, name: str) -> Mesh:
    """The mesh in the .glb `data`.

    Its arrays are read-only views of `data`; those of a quantised mesh are restored.

    Args:
        data: the bytes of the entry.
        name: the entry's name, for issues.

    Raises:
        PackageError: with the first GEOMETRY_* or JSON_* issue found.
    """
    document, place = split_glb(data, name)
    blob = data[place]
    forms = accessor_forms(document, name)
    arrays = {which: _array(document, blob, form, name) for which, form in forms.items()}
    indices = arrays["indices"].reshape(-1)
    if indices.size % 3:
        refuse(Code.GEOMETRY_ARRAY, name, f"{indices.size} indices", "a multiple of 3")
    position = forms["POSITION"]
    _check_range(arrays["POSITION"], document.accessors[position.index], position.where(name))
    mesh = _mesh(document, arrays, indices.astype(np.uint32, copy=False).reshape(-1, 3))
    check_mesh(mesh, name)
    return mesh


def _mesh(
    document: gltf.Gltf, arrays: dict[str, NDArray[Any]], triangles: NDArray[np.uint32]
) -> Mesh:
    positions, normals, uvs = arrays["POSITION"], arrays["NORMAL"], arrays.get("TEXCOORD_0")
    node = document.nodes[0]
    if node.scale is None or node.translation is None:
        return Mesh(positions, normals, uvs, triangles)
    translation, scale = np.array(node.translation), np.array(node.scale[:1])
    return QuantisedMesh(translation, scale, positions, normals, uvs, triangles).restored()


def split_glb(data: memoryview, name: str) -> tuple[gltf.Gltf, slice]:
    """The JSON of a package's mesh, and the bytes of its buffer in `data`.

    Raises PackageError, as `mesh_from_glb` does.
    """
    if len(data) < HEADER.size + 2 * CHUNK.size:
        refuse(Code.GEOMETRY_CONTAINER, name, f"{len(data)} bytes", "a header and two chunks")
    header = HEADER.unpack_from(data)
    if header != (MAGIC, 2, len(data)):
        refuse(Code.GEOMETRY_CONTAINER, name, header, (MAGIC, 2, len(data)))
    json_size, json_type = CHUNK.unpack_from(data, HEADER.size)
    json_start = HEADER.size + CHUNK.size
    bin_start = json_start + json_size + CHUNK.size
    if json_type != CHUNK_JSON or json_size > MAX_GLTF_JSON_BYTES or bin_start > len(data):
        expected = f"a JSON chunk of at most {MAX_GLTF_JSON_BYTES} bytes"
        refuse(Code.GEOMETRY_CONTAINER, name, f"{json_type!r} of {json_size} bytes", expected)
    bin_size, bin_type = CHUNK.unpack_from(data, bin_start - CHUNK.size)
    if bin_type != CHUNK_BIN or bin_start + bin_size != len(data) or (bin_start | bin_size) % 4:
        expected = f"a BIN chunk of {len(data) - bin_start} bytes, from and to a multiple of 4"
        refuse(Code.GEOMETRY_CONTAINER, name, f"{bin_type!r} of {bin_size} bytes", expected)
    document = _document(bytes(data[json_start : json_start + json_size]), name)
    declared = document.buffers[0].byte_length
    if not declared <= bin_size <= declared + 3:
        where = f"{name}#/buffers/0/byteLength"
        refuse(Code.GEOMETRY_RANGE, where, declared, f"{bin_size} less at most 3 of padding")
    return document, slice(bin_start, bin_start + declared)


def _document(data: bytes, name: str) -> gltf.Gltf:
    document = parse_object(data, name, Code.GEOMETRY_CONTAINER)
    _refuse_null(document, name)
    try:
        return model_of(gltf.Gltf, document)
    except ValidationError as error:
        first = error.errors()[0]
        where = f"{name}#{pointer(*first['loc'])}"
        refuse(Code.GEOMETRY_PROFILE, where, repr(first["input"]), first["msg"])


def _refuse_null(value: Any, name: str, *path: str | int) -> None:
    """glTF omits members without a value; only `extras` are free."""
    if value is None:
        refuse(Code.GEOMETRY_PROFILE, f"{name}#{pointer(*path)}", "null", "a value, or no member")
    is_list = isinstance(value, list)
    children = enumerate(value) if is_list else value.items() if isinstance(value, dict) else ()
    for key, child in children:
        if key != "extras":
            _refuse_null(child, name, *path, key)


def _array(document: gltf.Gltf, blob: memoryview, form: AccessorForm, name: str) -> NDArray[Any]:
    """The accessor's values, (count, width); a view of `blob`."""
    where = form.where(name)
    accessor = document.accessors[form.index]
    view = document.buffer_views[accessor.buffer_view]
    size = form.width * form.dtype.itemsize
    stride = view.byte_stride or size
    start = view.byte_offset + accessor.byte_offset
    end = start + stride * (accessor.count - 1) + size
    view_end = view.byte_offset + view.byte_length
    if end > view_end or view_end > len(blob) or start % 4:
        found = f"bytes {start} to {end}, view to {view_end}, buffer of {len(blob)}"
        refuse(Code.GEOMETRY_RANGE, where, found, "aligned bytes inside both")
    strides = (stride, form.dtype.itemsize)
    return np.ndarray((accessor.count, form.width), form.dtype, blob, start, strides)


def check_mesh(mesh: Mesh, name: str) -> None:
    """Raises PackageError for values that the mesh of a package has not.

    GEOMETRY_NOT_FINITE, GEOMETRY_INDEX, GEOMETRY_NORMAL; name: of its file, for the issue.
    """
    attributes: dict[str, NDArray[np.float32] | None] = {
        "POSITION": mesh.positions,
        "NORMAL": mesh.normals,
        "TEXCOORD_0": mesh.uvs,
    }
    for attribute, array in attributes.items():
        if array is not None and not np.isfinite(array).all():
            refuse(Code.GEOMETRY_NOT_FINITE, name, attribute, "finite values")
    largest = int(mesh.triangles.max())
    if largest >= len(mesh.positions):
        refuse(Code.GEOMETRY_INDEX, name, largest, f"below {len(mesh.positions)}")
    stored = mesh.quantised
    normals = mesh.normals if stored is None else stored_normals(stored.normals)
    lengths = np.linalg.norm(normals.astype(np.float64), axis=1)
    worst = float(lengths[np.argmax(np.abs(lengths - 1))])
    if abs(worst - 1) > NORMAL_TOLERANCE:
        refuse(Code.GEOMETRY_NORMAL, name, f"length {worst:.6g}", f"1 within {NORMAL_TOLERANCE}")


def _check_range(positions: NDArray[Any], accessor: gltf.Accessor, where: str) -> None:
    """POSITION's min and max must match its values, as stored."""
    low, high = positions.min(axis=0), positions.max(axis=0)
    for found, actual in ((accessor.min, low), (accessor.max, high)):
        with np.errstate(over="ignore"):
            same = found is not None and np.array_equal(np.asarray(found, np.float32), actual)
        if not same:
            refuse(Code.GEOMETRY_BOUNDS, where, found, actual.tolist())

"""Forms of the accessors of the package's glTF: float32 throughout, or quantised throughout."""

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from rna_sdk.package.geometry import gltf_model as gltf
from rna_sdk.package.issues import Code, refuse

_DTYPES: Final[dict[int, str]] = {
    gltf.FLOAT: "<f4",
    gltf.UNSIGNED_INT: "<u4",
    gltf.UNSIGNED_SHORT: "<u2",
    gltf.SHORT: "<i2",
}

# (component type, normalized, byteStride of its view)
_Stored = tuple[int, bool, int | None]
_FLOAT: Final[_Stored] = (gltf.FLOAT, False, None)
_EXACT: Final[dict[str, list[_Stored]]] = {
    "POSITION": [_FLOAT],
    "NORMAL": [_FLOAT],
    "TEXCOORD_0": [_FLOAT],
    "indices": [(gltf.UNSIGNED_INT, False, None)],
}
_QUANTISED: Final[dict[str, list[_Stored]]] = {
    "POSITION": [(gltf.UNSIGNED_SHORT, False, gltf.QUANTISED_STRIDE)],
    "NORMAL": [(gltf.SHORT, True, gltf.QUANTISED_STRIDE)],
    "TEXCOORD_0": [_FLOAT, (gltf.UNSIGNED_SHORT, True, 4)],
    "indices": [(gltf.UNSIGNED_INT, False, None), (gltf.UNSIGNED_SHORT, False, None)],
}
_SHAPES: Final[dict[str, gltf.Shape]] = {
    "POSITION": "VEC3",
    "NORMAL": "VEC3",
    "TEXCOORD_0": "VEC2",
    "indices": "SCALAR",
}


@dataclass(frozen=True)
class AccessorForm:
    """An accessor that is as it must be: its number, dtype and numbers a row."""

    index: int
    dtype: np.dtype[Any]
    width: int

    def where(self, name: str) -> str:
        """Its JSON pointer in the entry `name`."""
        return f"{name}#/accessors/{self.index}"


def accessor_forms(document: gltf.Gltf, name: str) -> dict[str, AccessorForm]:
    """The accessors of the attributes and of `indices`.

    Raises:
        PackageError: GEOMETRY_PROFILE, GEOMETRY_RANGE (an index of nothing).
    """
    _check_extension(document, name)
    primitive = document.meshes[0].primitives[0]
    indices = {
        "POSITION": primitive.attributes.POSITION,
        "NORMAL": primitive.attributes.NORMAL,
        "TEXCOORD_0": primitive.attributes.TEXCOORD_0,
        "indices": primitive.indices,
    }
    return {
        which: _form(document, which, index, name)
        for which, index in indices.items()
        if index is not None
    }


def _check_extension(document: gltf.Gltf, name: str) -> None:
    """The extension is used and required, and has its transform; or nothing of it is there."""
    node, quantised = document.nodes[0], document.is_quantised
    members = {
        "/extensionsRequired": document.extensions_required,
        "/nodes/0/translation": node.translation,
        "/nodes/0/scale": node.scale,
    }
    for where, value in members.items():
        if (value is not None) != quantised:
            expected = f"one, with {gltf.QUANTIZATION}" if quantised else "no such member"
            refuse(Code.GEOMETRY_PROFILE, f"{name}#{where}", value, expected)
    if quantised:
        return
    for i, accessor in enumerate(document.accessors):
        if accessor.normalized or accessor.component_type not in (gltf.FLOAT, gltf.UNSIGNED_INT):
            found = f"normalized {accessor.normalized}, of {accessor.component_type}"
            expected = f"not normalized, of {gltf.UNSIGNED_INT} or {gltf.FLOAT}"
            refuse(Code.GEOMETRY_PROFILE, f"{name}#/accessors/{i}", found, expected)
    for i, view in enumerate(document.buffer_views):
        if view.byte_stride is not None:
            where = f"{name}#/bufferViews/{i}/byteStride"
            refuse(Code.GEOMETRY_PROFILE, where, view.byte_stride, "no such member")


def _form(document: gltf.Gltf, which: str, index: int, name: str) -> AccessorForm:
    where = f"{name}#/accessors/{index}"
    if index >= len(document.accessors):
        refuse(Code.GEOMETRY_RANGE, where, "no such accessor", f"{len(document.accessors)} of them")
    accessor = document.accessors[index]
    if accessor.buffer_view >= len(document.buffer_views):
        refuse(Code.GEOMETRY_RANGE, where, f"view {accessor.buffer_view}", "an existing one")
    stride = document.buffer_views[accessor.buffer_view].byte_stride
    shape, allowed = _SHAPES[which], (_QUANTISED if document.is_quantised else _EXACT)[which]
    stored = (accessor.component_type, accessor.normalized, stride)
    if accessor.type != shape or stored not in allowed:
        found = f"{accessor.type} of {_shown(stored)}"
        expected = f"{shape} of {' or '.join(map(_shown, allowed))}"
        refuse(Code.GEOMETRY_PROFILE, where, found, expected)
    if which == "indices" and accessor.component_type == gltf.UNSIGNED_SHORT:
        _check_short_indices(document, name)
    return AccessorForm(index, np.dtype(_DTYPES[accessor.component_type]), gltf.WIDTHS[shape])


def _check_short_indices(document: gltf.Gltf, name: str) -> None:
    position = document.meshes[0].primitives[0].attributes.POSITION
    vertices = document.accessors[position].count
    if vertices >= gltf.MAX_SHORT_INDICES:
        expected = f"{gltf.UNSIGNED_SHORT} for fewer than {gltf.MAX_SHORT_INDICES} vertices"
        refuse(Code.GEOMETRY_PROFILE, f"{name}#/accessors", f"indices to {vertices}", expected)


def _shown(stored: _Stored) -> str:
    component, normalized, stride = stored
    text = f"{component}{' normalized' if normalized else ''}"
    return text if stride is None else f"{text} every {stride} bytes"

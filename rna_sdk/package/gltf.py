"""The subset of glTF 2.0 that RNA geometry uses, as models of its JSON.

Names and meanings: glTF 2.0 specification, chapter 5. Members that are not here (materials,
transforms, extensions, sparse accessors, ...) are refused.
"""

from __future__ import annotations

from typing import Annotated, Final, Literal

from pydantic import AfterValidator, Field, JsonValue

from rna_sdk.package.manifest_fields import Record

FLOAT: Final = 5126
UNSIGNED_INT: Final = 5125
ARRAY_BUFFER: Final = 34962
ELEMENT_ARRAY_BUFFER: Final = 34963

Shape = Literal["SCALAR", "VEC2", "VEC3"]
WIDTHS: dict[Shape, int] = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}

Count = Annotated[int, Field(ge=1, lt=2**32)]
Offset = Annotated[int, Field(ge=0, lt=2**32)]
Index = Offset
# Not Literal[0] and Literal[False], which each take the other's value.
Zero = Annotated[int, Field(ge=0, le=0)]


def _is_false(value: bool) -> bool:
    if value:
        raise ValueError("expected false")
    return value


False_ = Annotated[bool, AfterValidator(_is_false)]


class Asset(Record):
    version: Literal["2.0"]
    generator: str | None = None
    copyright: str | None = None


class Scene(Record):
    nodes: tuple[Zero]
    name: str | None = None


class Node(Record):
    mesh: Zero
    name: str | None = None


class Attributes(Record):
    POSITION: Index = Field(alias="POSITION")
    NORMAL: Index = Field(alias="NORMAL")
    TEXCOORD_0: Index | None = Field(default=None, alias="TEXCOORD_0")


class Primitive(Record):
    attributes: Attributes
    indices: Index
    mode: Literal[4] = 4


class GltfMesh(Record):
    primitives: tuple[Primitive]
    name: str | None = None


class Accessor(Record):
    buffer_view: Index
    byte_offset: Offset = 0
    component_type: Literal[5125, 5126]
    normalized: False_ = False
    count: Count
    type: Shape
    min: tuple[float, ...] | None = None
    max: tuple[float, ...] | None = None
    name: str | None = None


class BufferView(Record):
    buffer: Zero
    byte_offset: Offset = 0
    byte_length: Count
    target: Literal[34962, 34963] | None = None
    name: str | None = None


class Buffer(Record):
    byte_length: Count
    name: str | None = None


class Gltf(Record):
    """The whole document: one scene, one node, one mesh, one primitive, one buffer."""

    asset: Asset
    scene: Zero = 0
    scenes: tuple[Scene]
    nodes: tuple[Node]
    meshes: tuple[GltfMesh]
    accessors: tuple[Accessor, ...] = Field(min_length=3, max_length=4)
    buffer_views: tuple[BufferView, ...] = Field(min_length=1, max_length=4)
    buffers: tuple[Buffer]
    extras: JsonValue = None

"""The subset of glTF 2.0 that RNA geometry uses, as models of its JSON.

Names and meanings: glTF 2.0 specification, chapter 5, and KHR_mesh_quantization. Members that are
not here (materials, rotations, other extensions, sparse accessors, ...) are refused.
"""

from typing import Annotated, Final, Literal

from pydantic import AfterValidator, Field, JsonValue

from rna_sdk.package.manifest.manifest_fields import Record

FLOAT: Final = 5126
UNSIGNED_INT: Final = 5125
UNSIGNED_SHORT: Final = 5123
SHORT: Final = 5122
ARRAY_BUFFER: Final = 34962
ELEMENT_ARRAY_BUFFER: Final = 34963

Shape = Literal["SCALAR", "VEC2", "VEC3"]
WIDTHS: dict[Shape, int] = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}

QUANTISED_STRIDE: Final = 8
"""Bytes from a quantised position or normal to the next: 6, aligned to 4."""
MAX_SHORT_INDICES: Final = 65535
"""Meshes of fewer vertices may have indices of 16 bits; 65535 itself would restart a primitive."""

Quantization = Literal["KHR_mesh_quantization"]
QUANTIZATION: Final[Quantization] = "KHR_mesh_quantization"
ComponentType = Literal[5122, 5123, 5125, 5126]
Stride = Literal[4, 8]
Count = Annotated[int, Field(ge=1, lt=2**32)]
Offset = Annotated[int, Field(ge=0, lt=2**32)]
Index = Offset
# Not Literal[0], which takes False.
Zero = Annotated[int, Field(ge=0, le=0)]
Positive = Annotated[float, Field(gt=0)]


def _is_uniform(value: tuple[float, float, float]) -> tuple[float, float, float]:
    if len(set(value)) > 1:
        raise ValueError("expected three equal numbers")
    return value


class Asset(Record):
    version: Literal["2.0"]
    generator: str | None = None
    copyright: str | None = None


class Scene(Record):
    nodes: tuple[Zero]
    name: str | None = None


class Node(Record):
    """`translation` and `scale`, in float64, are those of quantised positions."""

    mesh: Zero
    translation: tuple[float, float, float] | None = None
    scale: Annotated[tuple[Positive, Positive, Positive], AfterValidator(_is_uniform)] | None = None
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
    component_type: ComponentType
    normalized: bool = False
    count: Count
    type: Shape
    min: tuple[int | float, ...] | None = None
    max: tuple[int | float, ...] | None = None
    name: str | None = None


class BufferView(Record):
    buffer: Zero
    byte_offset: Offset = 0
    byte_length: Count
    byte_stride: Stride | None = None
    target: Literal[34962, 34963] | None = None
    name: str | None = None


class Buffer(Record):
    byte_length: Count
    name: str | None = None


class Gltf(Record):
    """The whole document: one scene, one node, one mesh, one primitive, one buffer."""

    asset: Asset
    extensions_used: tuple[Quantization] | None = None
    extensions_required: tuple[Quantization] | None = None
    scene: Zero = 0
    scenes: tuple[Scene]
    nodes: tuple[Node]
    meshes: tuple[GltfMesh]
    accessors: tuple[Accessor, ...] = Field(min_length=3, max_length=4)
    buffer_views: tuple[BufferView, ...] = Field(min_length=1, max_length=4)
    buffers: tuple[Buffer]
    extras: JsonValue = None

    @property
    def is_quantised(self) -> bool:
        """Whether it says so, in which case it must be so throughout."""
        return self.extensions_used is not None

"""Types of the manifest's members, and the objects that are for the whole asset or each part.

Fields are snake_case here and camelCase in the file. Everything not said otherwise is in
object space (right-handed, +Y up), metres, linear.
"""

import math
from collections.abc import Iterator
from typing import Annotated, Any, Literal, cast, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Discriminator,
    Field,
    GetCoreSchemaHandler,
    SerializerFunctionWrapHandler,
    Tag,
    field_validator,
    model_serializer,
)
from pydantic.alias_generators import to_camel
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from rna_sdk.package.blocks import INPUT_BLOCKS
from rna_sdk.package.container.zip_container import NAME_PATTERN
from rna_sdk.package.limits import (
    MAX_CONES,
    MAX_COORDINATE,
    MAX_INTEGER,
    MAX_NAME_BYTES,
    MIN_EXTENT,
)


class Entry(str):
    """The name of an entry, which `references` knows from other texts."""

    __slots__ = ()


Vector = tuple[float, float, float]
Coordinate = Annotated[float, Field(ge=-MAX_COORDINATE, le=MAX_COORDINATE)]
Point = tuple[Coordinate, Coordinate, Coordinate]
EntryPath = Annotated[
    str,
    Field(pattern=f"^{NAME_PATTERN}$", max_length=MAX_NAME_BYTES),
    AfterValidator(Entry),
]
Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$", max_length=64)]
Measure = Annotated[float, Field(ge=0)]
Count = Annotated[int, Field(ge=0, le=MAX_INTEGER)]
Positive = Annotated[int, Field(ge=1, le=MAX_INTEGER)]
Kind = Literal["surface", "fiber"]
PlanePrecision = Literal["int8", "float16", "float32"]
DecoderPrecision = Literal["float32", "int8"]

KINDS: tuple[str, ...] = get_args(Kind)
GEOMETRY_ENTRIES: dict[Kind, str] = {
    "surface": "geometry/mesh.glb",
    "fiber": "geometry/curves.safetensors",
}
"""The usual name of the geometry's entry, of an asset of one part."""

_UNIT_TOLERANCE = 1e-3


class Record(BaseModel):
    """Base of every object: immutable, no unknown members, finite numbers only."""

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        alias_generator=to_camel,
        validate_by_name=True,
        validate_by_alias=True,
        serialize_by_alias=True,
        allow_inf_nan=False,
    )


class SparseRecord(Record):
    """A Record whose members that are None, or hold nothing, are left out of the file."""

    @model_serializer(mode="wrap")
    def _what_is_there(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        members: dict[str, Any] = handler(self)
        return {name: value for name, value in members.items() if value not in (None, [], ())}


def references(value: object, *path: str | int) -> Iterator[tuple[tuple[str | int, ...], str]]:
    """(path, entry) of every entry that a record or a tuple of records names, as in the file.

    path: to the value.
    """
    if isinstance(value, Entry):
        yield path, value
    elif isinstance(value, Record):
        for name, member in value:
            yield from references(member, *path, to_camel(name))
    elif isinstance(value, tuple):
        for i, item in enumerate(value):
            yield from references(item, *path, i)
    elif isinstance(value, dict):
        for key in value:
            yield from references(key, *path, key)


class Bounds(Record):
    """The box the triplane spans; readers round its numbers to float32."""

    min: Point = Field(description="Smallest x, y, z.")
    max: Point = Field(description="Largest x, y, z; each greater than that of min.")

    @field_validator("max")
    @classmethod
    def _has_extent(cls, value: Point, info: Any) -> Point:
        low = info.data.get("min")
        if low is not None and (_extent(low, value) < MIN_EXTENT).any():
            raise PydanticCustomError("BOUNDS_EMPTY", f"max - min >= {MIN_EXTENT} in float32")
        return value

    def corners(self) -> NDArray[np.float32]:
        """(2, 3) float32: min and max as every reader uses them."""
        return np.array([self.min, self.max], np.float32)


def _extent(low: Point, high: Point) -> NDArray[np.float64]:
    """(3,) from `low` to `high`, once both are rounded to float32."""
    corners = np.array([low, high], np.float32).astype(np.float64)
    return np.asarray(corners[1] - corners[0])


class Cone(Record):
    """Directions near an axis."""

    axis: Vector = Field(description="Its middle, a unit vector.")
    half_angle: float = Field(ge=0, le=math.pi, description="From the axis to its edge, radians.")

    @field_validator("axis")
    @classmethod
    def _is_unit(cls, value: Vector) -> Vector:
        if abs(math.hypot(*value) - 1.0) > _UNIT_TOLERANCE:
            raise PydanticCustomError("FIELD_VALUE", "a unit vector")
        return value


Cones = Annotated[tuple[Cone, ...], Field(min_length=1, max_length=MAX_CONES)]
Region = Annotated[
    Annotated[Literal["sphere", "hemisphere"], Tag("[name]")] | Annotated[Cones, Tag("[cones]")],
    Discriminator(lambda value: "[cones]" if isinstance(value, list | tuple) else "[name]"),
]
"""All directions, their +Y half, or those in any of some cones."""


class Domain(Record):
    """Trained directions, object space."""

    wo: Region = Field(description="View directions, from the surface to the eye.")
    wi: Region = Field(description="Light directions, from the surface to the light.")


class Units(Record):
    """Units of the package."""

    length: Literal["metre"]


def _known_once(value: tuple[str, ...]) -> tuple[str, ...]:
    if len(set(value)) < len(value) or not set(value) <= set(INPUT_BLOCKS):
        raise PydanticCustomError("INPUT_UNKNOWN", "each once, of " + ", ".join(INPUT_BLOCKS))
    return value


_Input = Annotated[str, Field(json_schema_extra={"enum": list(INPUT_BLOCKS)})]
Inputs = Annotated[
    tuple[_Input, ...],
    Field(
        min_length=1,
        description="Input blocks, in the order of the columns of `queries`.",
        json_schema_extra={"uniqueItems": True},
    ),
    AfterValidator(_known_once),
]


class NotNull:
    """Marks an optional member: None if absent, never null in a file."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        in_file = handler(get_args(source)[0])
        in_python = core_schema.nullable_schema(in_file)
        return core_schema.json_or_python_schema(in_file, in_python)


class NotEmpty:
    """Marks an optional array: empty if absent, never empty in a file."""

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        in_python = handler(source)
        in_file = cast(CoreSchema, {**in_python, "min_length": 1})
        return core_schema.json_or_python_schema(in_file, in_python)

"""The model of manifest.json: one class an object, one field a member.

Fields are snake_case here and camelCase in the file. Everything not said otherwise is in
object space (right-handed, +Y up), metres, linear.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Annotated, Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray
from pydantic import (
    BaseModel,
    ConfigDict,
    Discriminator,
    Field,
    JsonValue,
    Tag,
    field_validator,
)
from pydantic.alias_generators import to_camel
from pydantic_core import PydanticCustomError

from rna_sdk.package.blocks import INPUT_BLOCKS, query_width
from rna_sdk.package.container import MANIFEST_NAME, NAME_PATTERN
from rna_sdk.package.limits import (
    MAX_CHANNELS,
    MAX_CONES,
    MAX_COORDINATE,
    MAX_INTEGER,
    MAX_NAME_BYTES,
    MAX_RESOLUTION,
    MAX_TIERS,
    MIN_EXTENT,
)

Vector = tuple[float, float, float]
Coordinate = Annotated[float, Field(ge=-MAX_COORDINATE, le=MAX_COORDINATE)]
Point = tuple[Coordinate, Coordinate, Coordinate]
EntryPath = Annotated[str, Field(pattern=f"^{NAME_PATTERN}$", max_length=MAX_NAME_BYTES)]
VERSION_PATTERN = r"[1-9][0-9]{0,3}\.(0|[1-9][0-9]{0,3})"
Version = Annotated[str, Field(pattern=f"^{VERSION_PATTERN}$")]
Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]*$", max_length=64)]
InputName = Annotated[str, Field(json_schema_extra={"enum": list(INPUT_BLOCKS)})]
Measure = Annotated[float, Field(ge=0)]
Count = Annotated[int, Field(ge=0, le=MAX_INTEGER)]
Positive = Annotated[int, Field(ge=1, le=MAX_INTEGER)]
Kind = Literal["surface", "fiber"]
PlanePrecision = Literal["int8", "float16", "float32"]
DecoderPrecision = Literal["float32", "int8"]

_UNIT_TOLERANCE = 1e-3

KINDS: tuple[str, ...] = get_args(Kind)
GEOMETRY_ENTRIES: dict[Kind, str] = {
    "surface": "geometry/mesh.glb",
    "fiber": "geometry/curves.safetensors",
}
"""The usual name of the geometry's entry."""

REQUIRED_IN_FILE = (
    "format",
    "version",
    "minReaderVersion",
    "kind",
    "units",
    "geometry",
    "entries",
)
"""Members with a default for whoever makes a Manifest; a file must have them all the same."""


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
    """Where directions were trained, object space."""

    wo: Region = Field(description="View directions, from the surface to the eye.")
    wi: Region = Field(description="Light directions, from the surface to the light.")


class Units(Record):
    """Units of the package."""

    length: Literal["metre"]


class FlipAtHeight(Record):
    """Error of an asset that is seen small."""

    height: Positive = Field(description="Height of the validation images, pixels.")
    flip: Measure = Field(description="Mean FLIP at that height.")


class Validation(Record):
    """Error against reference images the training never saw."""

    psnr: float = Field(description="Peak signal-to-noise ratio, dB.")
    flip: Measure = Field(description="Mean FLIP.")
    relative_mse: Measure = Field(description="Mean relative squared error.")
    images: Positive = Field(description="Number of images compared.")
    definition: str = Field(description="What exactly was compared, for a person.")
    flip_at_height: tuple[FlipAtHeight, ...] = Field(
        default=(),
        description="`flip` of the images reduced to other heights, which the bounds fill; "
        "from the largest.",
    )

    @field_validator("flip_at_height")
    @classmethod
    def _descends(cls, value: tuple[FlipAtHeight, ...]) -> tuple[FlipAtHeight, ...]:
        if any(a.height <= b.height for a, b in pairwise(value)):
            raise PydanticCustomError("FIELD_VALUE", "each height below the one before")
        return value


class Cost(Record):
    """What a query costs."""

    multiply_adds: Count = Field(description="Multiply-adds of the decoder a query.")
    ns_per_query: Measure = Field(description="Nanoseconds a query, everything included.")
    threads: Positive = Field(description="Threads used in the measurement.")
    machine: str = Field(description="What it was measured on.")


class Agreement(Record):
    """Largest difference between the exported decoder and the trained model."""

    max_absolute: Measure
    max_relative: Measure


class Tier(Record):
    """One choice of speed and accuracy: planes and a decoder."""

    name: Name = Field(description="What hosts call the tier; unique in the package.")
    planes: EntryPath = Field(description="Entry with the triplane.")
    decoder: EntryPath = Field(description="Entry with the ONNX decoder.")
    inputs: tuple[InputName, ...] = Field(
        min_length=1,
        description="Input blocks, in the order of the columns of `queries`.",
        json_schema_extra={"uniqueItems": True},
    )
    resolution: int = Field(ge=1, le=MAX_RESOLUTION, description="R, texels along a plane's side.")
    channels: int = Field(ge=1, le=MAX_CHANNELS, description="C, features a texel.")
    plane_precision: PlanePrecision = Field(description="dtype of the planes.")
    decoder_precision: DecoderPrecision = Field(
        description="Arithmetic of the decoder; int8 means quantised by QDQ nodes."
    )
    validation: Validation | None = None
    cost: Cost | None = None
    agreement: Agreement | None = None

    @field_validator("inputs")
    @classmethod
    def _known_once(cls, value: tuple[str, ...]) -> tuple[str, ...]:
        if len(set(value)) < len(value) or not set(value) <= set(INPUT_BLOCKS):
            raise PydanticCustomError("INPUT_UNKNOWN", "each once, of " + ", ".join(INPUT_BLOCKS))
        return value

    @property
    def query_width(self) -> int:
        """K, the number of columns of `queries`."""
        return query_width(self.inputs, self.channels)


class EntryRecord(Record):
    """Size and hash of one entry."""

    size: Count = Field(description="Bytes.")
    sha256: str = Field(pattern="^[0-9a-f]{64}$", description="SHA-256, lower-case hex.")


class Provenance(Record):
    """Where the asset comes from."""

    source: str = Field(description="The original model: name, author, address.")
    tool: str = Field(description="What made the training data, with its version.")
    capture: dict[str, JsonValue] = Field(default={}, description="Capture settings.")
    training: dict[str, JsonValue] = Field(default={}, description="Training settings.")


class Manifest(Record):
    """manifest.json. `write_package` computes `entries`; leave it out before that."""

    format: Literal["rna"] = "rna"
    version: Version = Field(default="1.0", description="Version of the format it follows.")
    min_reader_version: Version = Field(default="1.0", description="Oldest reader that can.")
    generator: str = Field(description="What wrote the package, with its version.")
    name: str = Field(min_length=1, description="The asset's name, for a person.")
    kind: Kind = Field(default="surface", description="What the geometry is: a mesh, or curves.")
    bounds: Bounds
    domain: Domain
    units: Units = Units(length="metre")
    geometry: EntryPath = Field(
        default_factory=lambda data: GEOMETRY_ENTRIES[data.get("kind", "surface")],
        description="Entry with the mesh or the curves.",
    )
    tiers: tuple[Tier, ...] = Field(min_length=1, max_length=MAX_TIERS)
    entries: dict[EntryPath, EntryRecord] = Field(
        default={}, description=f"Every entry of the archive except {MANIFEST_NAME}."
    )
    provenance: Provenance
    license: str = Field(min_length=1, description="SPDX expression, or the terms.")
    extensions_used: tuple[Name, ...] = ()
    extensions_required: tuple[Name, ...] = ()
    extensions: dict[Name, JsonValue] = Field(
        default={}, description="Data of extensions, by name; each in extensionsUsed."
    )
    extras: dict[str, JsonValue] = Field(default={}, description="Anything; readers ignore it.")

    @field_validator("tiers")
    @classmethod
    def _unique_names(cls, value: tuple[Tier, ...]) -> tuple[Tier, ...]:
        names = [tier.name for tier in value]
        if len(set(names)) < len(names):
            raise PydanticCustomError("TIER_DUPLICATE", "each tier name once")
        return value

"""The model of manifest.json: one class an object, one field a member."""

from typing import Annotated, Literal

from pydantic import Field, JsonValue, field_validator

from rna_sdk.package.container.zip_container import MANIFEST_NAME
from rna_sdk.package.limits import MAX_PARTS, MAX_TEXTURE_RECORDS, MAX_TIERS
from rna_sdk.package.manifest.manifest_fields import (
    Bounds,
    Coordinate,
    Count,
    Domain,
    EntryPath,
    Kind,
    Name,
    NotEmpty,
    NotNull,
    Positive,
    Record,
    SparseRecord,
    Units,
)
from rna_sdk.package.manifest.manifest_tiers import Tier, check_unique

REQUIRED_IN_FILE = ("format", "version", "units", "entries")
"""Members with a default for whoever makes a Manifest; a file must have them all the same."""

Cutoff = Annotated[float, Field(gt=0, lt=1)]
Index = Annotated[float, Field(ge=0.01, le=100)]


class TriangleRange(SparseRecord):
    """Triangles with a texture: base of the records of each sort."""

    triangles: tuple[Count, Positive] = Field(description="The first, and how many.")


class TransmittanceRecord(TriangleRange):
    """Triangles that let light through, and how much of it."""

    texture: EntryPath = Field(description="Entry with the texture.")
    cutoff: Annotated[Cutoff | None, NotNull()] = Field(
        default=None, description="A hole where the texture is greater than this, else none."
    )
    ior: Annotated[tuple[Index, Index] | None, NotNull()] = Field(
        default=None, description="Relative indices of refraction, from the front and the back."
    )


class NormalMapRecord(TriangleRange):
    """Triangles with relief, and the map of it."""

    texture: EntryPath = Field(description="Entry with the map.")


Unit = Annotated[float, Field(ge=0, le=1)]
Wrap = Literal["repeat", "clamp", "mirror"]
ColorSpace = Literal["srgb", "linear"]
Affine = tuple[Coordinate, Coordinate, Coordinate, Coordinate, Coordinate, Coordinate]


class BaseColorFields(SparseRecord):
    """A base colour: a factor, times an image."""

    image: Annotated[EntryPath | None, NotNull()] = Field(
        default=None, description="Entry with a PNG, JPEG or WebP; white without one."
    )
    color_space: Annotated[ColorSpace | None, NotNull()] = Field(
        default=None, description="Of the image; srgb without one."
    )
    factor: Annotated[tuple[Unit, Unit, Unit] | None, NotNull()] = Field(
        default=None, description="Linear RGB; white without one."
    )
    wrap: Annotated[tuple[Wrap, Wrap] | None, NotNull()] = Field(
        default=None, description="Beyond the image's edges, along u and v; repeat without one."
    )
    transform: Annotated[Affine | None, NotNull()] = Field(
        default=None, description="From texture coordinates to the image's: (a, b, c, d, e, f)."
    )


class BaseColorRecord(BaseColorFields, TriangleRange):
    """Triangles with a base colour."""


class Part(SparseRecord):
    """One geometry with planes and decoders of its own."""

    name: Name = Field(description="Unique in the package.")
    kind: Kind = Field(description="What the geometry is: a mesh, or curves.")
    bounds: Bounds
    geometry: EntryPath = Field(description="Entry with the mesh or the curves.")
    transmittance: Annotated[
        tuple[TransmittanceRecord, ...], Field(max_length=MAX_TEXTURE_RECORDS), NotEmpty()
    ] = Field(default=(), description="Holes and thin glass of a surface.")
    normal_maps: Annotated[
        tuple[NormalMapRecord, ...], Field(max_length=MAX_TEXTURE_RECORDS), NotEmpty()
    ] = Field(default=(), description="Relief of a surface.")
    base_color: Annotated[
        tuple[BaseColorRecord, ...], Field(max_length=MAX_TEXTURE_RECORDS), NotEmpty()
    ] = Field(default=(), description="Base colour of a surface.")

    @property
    def ranges(self) -> dict[str, tuple[TriangleRange, ...]]:
        """Its records of ranges of triangles, by the member that they are in."""
        return {
            "transmittance": self.transmittance,
            "normalMaps": self.normal_maps,
            "baseColor": self.base_color,
        }


class EntryRecord(Record):
    """Size and hash of one entry."""

    size: Count = Field(description="Bytes.")
    sha256: str = Field(pattern="^[0-9a-f]{64}$", description="SHA-256, lower-case hex.")


REST_FRAME, POSES = "restFrame", "poses"
"""Members of `Provenance.capture`: frames of the source."""


class Provenance(Record):
    """Origin of the asset."""

    source: str = Field(description="The original model: name, author, address.")
    tool: str = Field(description="What made the training data, with its version.")
    capture: dict[str, JsonValue] = Field(default={}, description="Capture settings.")
    training: dict[str, JsonValue] = Field(default={}, description="Training settings.")

    @property
    def rest_frame(self) -> int | None:
        """Frame of the source that the geometry is of; None where it is not recorded."""
        frame = self.capture.get(REST_FRAME)
        return frame if isinstance(frame, int) else None


VERSION: Literal["2.0"] = "2.0"
"""Version of the format that this package reads and writes."""


class Manifest(Record):
    """manifest.json. `write_package` computes `entries`; leave them out."""

    format: Literal["rna"] = "rna"
    version: Literal["2.0"] = Field(default=VERSION, description="Version of the format.")
    generator: str = Field(description="What wrote the package, with its version.")
    name: str = Field(min_length=1, description="The asset's name, for a person.")
    parts: tuple[Part, ...] = Field(
        min_length=1, max_length=MAX_PARTS, description="What the asset is made of."
    )
    domain: Domain
    units: Units = Units(length="metre")
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

    @field_validator("parts")
    @classmethod
    def _unique_parts(cls, value: tuple[Part, ...]) -> tuple[Part, ...]:
        check_unique((part.name for part in value), "PART_DUPLICATE", "part")
        return value

    @field_validator("tiers")
    @classmethod
    def _unique_tiers(cls, value: tuple[Tier, ...]) -> tuple[Tier, ...]:
        check_unique((tier.name for tier in value), "TIER_DUPLICATE", "tier")
        return value

"""The manifest's tiers: choices of speed and accuracy, each with one tier part for every part."""

from collections.abc import Iterable
from itertools import pairwise
from typing import Annotated

from pydantic import Field, field_validator
from pydantic_core import PydanticCustomError

from rna_sdk.package.blocks import query_width
from rna_sdk.package.decoder.decoder_form import (
    EMISSION,
    SHADOWED,
    TRANSPORT,
    VISIBLE,
    DecoderForm,
    PartDecoder,
)
from rna_sdk.package.limits import (
    MAX_CHANNELS,
    MAX_COORDINATE,
    MAX_PARTS,
    MAX_RESOLUTION,
    MIN_EXTENT,
)
from rna_sdk.package.manifest.manifest_fields import (
    Count,
    DecoderPrecision,
    EntryPath,
    Inputs,
    Measure,
    Name,
    NotNull,
    PlanePrecision,
    Positive,
    Record,
    SparseRecord,
)

Length = Annotated[float, Field(ge=MIN_EXTENT, le=MAX_COORDINATE)]
Lengths = tuple[Length, Length, Length]
Share = Annotated[float, Field(ge=0, le=1)]
Shares = tuple[Share, Share, Share]


class FlipAtHeight(Record):
    """Error of an asset that is seen small."""

    height: Positive = Field(description="Height of the validation images, pixels.")
    flip: Measure = Field(description="Mean FLIP at that height.")


class Albedo(SparseRecord):
    """Reflected light of a uniform white world, over the reference's; 1 is all of it."""

    ratio: Measure = Field(description="Of rays from all sides.")
    facing: Annotated[Measure | None, NotNull()] = Field(
        default=None, description="Of those less than 50 degrees from the normal."
    )
    at60: Annotated[Measure | None, NotNull()] = Field(
        default=None, description="Of those 50 to 70 degrees from the normal."
    )
    at80: Annotated[Measure | None, NotNull()] = Field(
        default=None, description="Of those more than 70 degrees from the normal."
    )


class Validation(SparseRecord):
    """Error against reference images the training never saw."""

    psnr: float = Field(description="Peak signal-to-noise ratio, dB.")
    flip: Measure = Field(description="Mean FLIP of the asset's pixels.")
    flip_p95: Annotated[Measure | None, NotNull()] = Field(
        default=None, description="95th percentile of the FLIP of the asset's pixels."
    )
    relative_mse: Measure = Field(description="Mean relative squared error.")
    images: Positive = Field(description="Number of images compared.")
    definition: str = Field(description="What exactly was compared, for a person.")
    flip_at_height: tuple[FlipAtHeight, ...] = Field(
        default=(),
        description="`flip` of the images reduced to other heights, which the bounds fill; "
        "from the largest.",
    )
    albedo: Annotated[Albedo | None, NotNull()] = Field(
        default=None, description="Light returned from a uniform white world."
    )

    @field_validator("flip_at_height")
    @classmethod
    def _descends(cls, value: tuple[FlipAtHeight, ...]) -> tuple[FlipAtHeight, ...]:
        if any(a.height <= b.height for a, b in pairwise(value)):
            raise PydanticCustomError("FIELD_VALUE", "each height below the one before")
        return value


class Cost(Record):
    """Cost of a query."""

    multiply_adds: Count = Field(description="Multiply-adds of the decoder per query.")
    ns_per_query: Measure = Field(description="Nanoseconds per query, everything included.")
    threads: Positive = Field(description="Threads used in the measurement.")
    machine: str = Field(description="What it was measured on.")


class Agreement(Record):
    """Largest difference between the exported decoder and the trained model."""

    max_absolute: Measure
    max_relative: Measure


class TierDecoder(SparseRecord):
    """A separate decoder on features of the planes of transport; base of those of each form."""

    decoder: EntryPath = Field(description="Entry with the ONNX decoder of emission.")
    inputs: Inputs
    decoder_precision: DecoderPrecision = Field(description="Arithmetic of the decoder.")
    agreement: Agreement | None = None


class TierEmission(TierDecoder):
    """Emission of a part: a separate decoder on features of the same planes."""


class TierShadowed(TierDecoder):
    """Shadowed light of a part, where its decoder of transport gives visible light alone."""


class TierNearby(Record):
    """Nearby light that the transport of a part counts linearly."""

    lengths: Lengths = Field(description="How far it reaches, metres, ascending.")
    visible: Shares = Field(description="Its mean where the asset does not block the light.")
    shadowed: Shares = Field(description="Its mean where the asset blocks the light.")

    @field_validator("lengths")
    @classmethod
    def _ascend(cls, value: tuple[float, ...]) -> tuple[float, ...]:
        if any(a >= b for a, b in pairwise(value)):
            raise PydanticCustomError("FIELD_VALUE", "each length above the one before")
        return value


class TierPartFields(Record):
    """Fields that a tier part and a record of lobes share."""

    planes: EntryPath = Field(description="Entry with the triplane.")
    decoder: EntryPath = Field(description="Entry with the ONNX decoder.")
    inputs: Inputs
    resolution: int = Field(ge=1, le=MAX_RESOLUTION, description="R, texels along a plane's side.")
    channels: int = Field(ge=1, le=MAX_CHANNELS, description="C, features a texel.")
    plane_precision: PlanePrecision = Field(description="dtype of the planes.")
    decoder_precision: DecoderPrecision = Field(
        description="Arithmetic of the decoder; int8 means quantised by QDQ nodes."
    )
    agreement: Agreement | None = None


class TierPart(TierPartFields, SparseRecord):
    """Planes and decoders of one part: of transport, and optionally of emission."""

    uses_base_color: Annotated[bool | None, NotNull()] = Field(
        default=None, description="Whether transport has a factor of the part's base colour."
    )
    nearby: Annotated[TierNearby | None, NotNull()] = None
    shadowed: Annotated[TierShadowed | None, NotNull()] = None
    emission: Annotated[TierEmission | None, NotNull()] = None

    @property
    def decoders(self) -> tuple[PartDecoder, ...]:
        """Its decoders: transport or visible light first, then the others."""
        records: tuple[tuple[DecoderForm, TierPart | TierDecoder | None], ...] = (
            (TRANSPORT if self.shadowed is None else VISIBLE, self),
            (SHADOWED, self.shadowed),
            (EMISSION, self.emission),
        )
        uses_base_color, with_nearby = bool(self.uses_base_color), self.nearby is not None
        return tuple(
            part_decoder(
                form,
                record,
                query_width(record.inputs, self.channels),
                uses_base_color,
                with_nearby,
            )
            for form, record in records
            if record is not None
        )

    @property
    def query_width(self) -> int:
        """K, the number of columns of `queries`, of transport."""
        return query_width(self.inputs, self.channels)


def part_decoder(
    form: DecoderForm,
    record: TierPartFields | TierDecoder,
    columns: int,
    uses_base_color: bool = False,
    nearby: bool = False,
) -> PartDecoder:
    """The decoder that a record declares, with so many columns of `queries`."""
    width = form.width(record, uses_base_color, nearby)
    return PartDecoder(
        form, record.decoder, columns, width, record.decoder_precision, record.inputs
    )


class Tier(Record):
    """One choice of speed and accuracy: planes and decoders of every part."""

    name: Name = Field(description="What hosts call the tier; unique in the package.")
    parts: tuple[TierPart, ...] = Field(
        min_length=1, max_length=MAX_PARTS, description="One for each part, in their order."
    )
    validation: Validation | None = None
    cost: Cost | None = None


def check_unique(names: Iterable[str], code: str, what: str) -> None:
    """Raises PydanticCustomError of the code, where a name is there twice."""
    names = list(names)
    if len(set(names)) < len(names):
        raise PydanticCustomError(code, f"each {what} name once")

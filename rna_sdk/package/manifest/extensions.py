"""The extensions that the specification defines: models of their data in the manifest."""

from itertools import pairwise
from typing import Annotated, Any, ClassVar, Protocol, TypeVar, cast

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from rna_sdk.package.blocks import query_width
from rna_sdk.package.container.strict_json import model_of
from rna_sdk.package.decoder.decoder_form import ENVIRONMENT, PartDecoder
from rna_sdk.package.limits import (
    MAX_FILE_BYTES,
    MAX_INTEGER,
    MAX_LOBES,
    MAX_MIXTURES,
    MAX_NARROW_LOBES,
    MAX_PARTS,
    MAX_PROXIES,
    MAX_TEXTURE_RECORDS,
    MAX_VALIDATIONS,
    MAX_VARIANTS,
)
from rna_sdk.package.manifest.manifest_fields import (
    Count,
    EntryPath,
    Kind,
    Measure,
    Name,
    NotEmpty,
    NotNull,
    Positive,
    Record,
    SparseRecord,
)
from rna_sdk.package.manifest.manifest_model import BaseColorFields, BaseColorRecord, Manifest
from rna_sdk.package.manifest.manifest_tiers import TierPartFields, part_decoder


def _is_element_size(value: int) -> int:
    if value not in (1, 2, 4):
        raise PydanticCustomError("FIELD_VALUE", "1, 2 or 4")
    return value


ElementSize = Annotated[int, AfterValidator(_is_element_size)]
Share = Annotated[float, Field(ge=0, le=1)]


class Extension(Record):
    """Base of the data of an extension."""

    NAME: ClassVar[str]


class Coding(Record):
    """Coding of an entry, and size and hash of the decoded bytes."""

    element_size: ElementSize = Field(description="Bytes.")
    distance: int = Field(ge=0, le=MAX_INTEGER, description="Elements, to the one taken away.")
    size: int = Field(ge=0, le=MAX_FILE_BYTES, description="Bytes when decoded.")
    sha256: str = Field(pattern="^[0-9a-f]{64}$", description="Of the decoded bytes.")


class Deflate(Extension):
    """Entries that are stored in coded form."""

    NAME: ClassVar[str] = "RNA_deflate"
    entries: dict[EntryPath, Coding]


class Poster(Extension):
    """A picture of the asset."""

    NAME: ClassVar[str] = "RNA_poster"
    image: EntryPath = Field(description="Entry with a PNG, sRGB with alpha.")
    width: Positive = Field(description="Pixels.")
    height: Positive = Field(description="Pixels.")


class StandinMaterial(Record):
    """A simple material for a part, as in glTF; linear."""

    base_color: tuple[Share, Share, Share]
    roughness: Share
    metallic: Share


class Standin(Extension):
    """Materials for viewports and the albedo of denoisers."""

    NAME: ClassVar[str] = "RNA_standin"
    parts: tuple[StandinMaterial, ...] = Field(min_length=1, max_length=MAX_PARTS)


class PartTextures(Record):
    """Textures of a part's stand-in material, as in glTF, over the mesh's texture coordinates."""

    base_color: EntryPath = Field(description="Entry with a PNG: sRGB.")
    metallic_roughness: EntryPath = Field(description="PNG: roughness in green, metallic in blue.")
    normal: EntryPath = Field(description="PNG: normal in the tangent frame.")


class ProxyLevel(Record):
    """Coarser geometry of a part, for an asset that is small in the image."""

    geometry: EntryPath = Field(description="Entry with the mesh or the curves.")
    height: Positive = Field(description="Largest height of the bounding sphere, pixels.")


P = TypeVar("P")
_ByPart = Annotated[tuple[P | None, ...], Field(min_length=1, max_length=MAX_PARTS)]


def _not_all_null(expected: str) -> AfterValidator:
    """Refuses a member by part that has nothing of any part."""

    def check(value: tuple[object, ...]) -> tuple[object, ...]:
        if not any(value):
            raise PydanticCustomError("FIELD_VALUE", expected)
        return value

    return AfterValidator(check)


def _descends(value: tuple[ProxyLevel, ...]) -> tuple[ProxyLevel, ...]:
    if any(a.height <= b.height for a, b in pairwise(value)):
        raise PydanticCustomError("FIELD_VALUE", "each height below the one before")
    return value


ProxyLevels = Annotated[
    tuple[ProxyLevel, ...], Field(min_length=1, max_length=MAX_PROXIES), AfterValidator(_descends)
]


class StandinTextures(Extension):
    """Textures in the place of RNA_standin's constants; null for a part that has none."""

    NAME: ClassVar[str] = "RNA_standin_textures"
    parts: Annotated[_ByPart[PartTextures], _not_all_null("textures of some part")]


class Proxy(Extension):
    """Coarser geometry of the parts; null for a part that has none."""

    NAME: ClassVar[str] = "RNA_proxy"
    parts: Annotated[_ByPart[ProxyLevels], _not_all_null("a proxy of some part")]


HARMONICS = 16
"""Real spherical harmonics of degree 0 to 3."""


class EnvironmentPart(TierPartFields, SparseRecord):
    """Lobes of a part: its radiance to a viewer under light from all sides."""

    lobes: int = Field(ge=2, le=MAX_LOBES, multiple_of=2, description="How many.")
    visibility: Annotated[EntryPath | None, NotNull()] = Field(
        default=None, description="Entry with the visibility about the vertices."
    )

    @property
    def optional_decoder(self) -> PartDecoder:
        """Its decoder, whose queries are the input blocks and, behind them, the visibility."""
        more = HARMONICS if self.visibility else 0
        columns = query_width(self.inputs, self.channels) + more
        return part_decoder(ENVIRONMENT, self, columns)


class EnvironmentValidation(Record):
    """Error of the lobes of all parts under an environment that they were not trained on."""

    environment: Name
    psnr: float = Field(description="dB, of the lobes alone.")
    psnr_with_lights: float = Field(description="dB, with what is bright split off as lights.")
    flip: Measure = Field(description="Mean FLIP, with lights.")
    brightness: tuple[Measure, Measure, Measure] = Field(
        description="Sum of the channel over that of the reference, with lights."
    )


class Environment(Extension):
    """Light from all sides in one query a point; null for a part that has none."""

    NAME: ClassVar[str] = "RNA_environment"
    parts: Annotated[_ByPart[EnvironmentPart], _not_all_null("lobes of some part")]
    validation: tuple[EnvironmentValidation, ...] = Field(default=(), max_length=MAX_VALIDATIONS)


class RayLobe(Record):
    """One of the lobes in which rays leave an asset."""

    share: Share = Field(description="Of all rays.")
    width: float


class MirrorLobe(RayLobe):
    """Half vectors of GGX."""

    width: float = Field(ge=1e-4, le=1, description="The distribution's alpha.")


class FiberLobe(RayLobe):
    """Directions about the cone of specular reflection from a fiber, or about -wo."""

    width: float = Field(ge=0.01, le=4, description="Of the cone the sine's scale, else radians.")


LARGEST_SHARE = 0.99
"""Largest share of all lobes of a mixture; uniform directions have the rest."""


class Mixture(SparseRecord):
    """Mixture of lobes for rays that leave triangles, or strands, fitted to their transport."""

    first: Count = Field(default=0, description="Number of the first triangle; 0 for strands.")
    cosine: Annotated[Share | None, NotNull()] = Field(
        default=None, description="Share of the cosine lobe of a surface."
    )
    mirror: Annotated[tuple[MirrorLobe, ...], Field(max_length=MAX_NARROW_LOBES), NotEmpty()] = (
        Field(default=(), description="About the mirror direction of a surface.")
    )
    forward: Annotated[FiberLobe | None, NotNull()] = Field(
        default=None, description="Straight through a fiber."
    )
    cone: Annotated[tuple[FiberLobe, ...], Field(max_length=MAX_NARROW_LOBES), NotEmpty()] = Field(
        default=(), description="About the cones of a fiber."
    )

    @property
    def lobes(self) -> list[tuple[float, float]]:
        """Shares and widths: of the cosine lobe, or the forward one, then of the narrow ones.

        A lobe that is not there has no share; there is always one, and MAX_NARROW_LOBES behind it.
        """
        broad = self.forward or FiberLobe(share=self.cosine or 0.0, width=1.0)
        every: tuple[RayLobe, ...] = (broad, *self.mirror, *self.cone)
        lobes = [(lobe.share, lobe.width) for lobe in every]
        return [*lobes, *[(0.0, 1.0)] * (1 + MAX_NARROW_LOBES - len(lobes))]


def _covers(value: tuple[Mixture, ...]) -> tuple[Mixture, ...]:
    firsts = [mixture.first for mixture in value]
    if firsts[0] or any(a >= b for a, b in pairwise(firsts)):
        raise PydanticCustomError("FIELD_VALUE", "first: 0, then each above the one before")
    return value


Mixtures = Annotated[
    tuple[Mixture, ...], Field(min_length=1, max_length=MAX_MIXTURES), AfterValidator(_covers)
]
USUAL_SAMPLING: dict[Kind, Mixture] = {
    "surface": Mixture(
        cosine=0.5,
        mirror=(
            MirrorLobe(share=0.22, width=0.1),
            MirrorLobe(share=0.07, width=0.025),
            MirrorLobe(share=0.04, width=0.004),
        ),
    ),
    "fiber": Mixture(
        forward=FiberLobe(share=0.25, width=0.45), cone=(FiberLobe(share=0.45, width=0.06),)
    ),
}
"""Mixtures for parts without their own: docs/decisions/renderer.md, "Rays leave assets in a
mixture of lobes"."""


class Sampling(Extension):
    """Lobes that rays leave the parts in; null for a part that has none."""

    NAME: ClassVar[str] = "RNA_sampling"
    parts: Annotated[_ByPart[Mixtures], _not_all_null("lobes of some part")]


class Source(Extension):
    """Vertices of the source, for hosts that move the asset with it; null for a part without."""

    NAME: ClassVar[str] = "RNA_source"
    vertices: int = Field(ge=1, le=MAX_INTEGER, description="That the source's meshes have.")
    parts: Annotated[_ByPart[EntryPath], _not_all_null("an entry of some part")]


Changes = Annotated[
    tuple[BaseColorFields | None, ...], Field(min_length=1, max_length=MAX_TEXTURE_RECORDS)
]
"""In the place of each record of base colour of a part; None where it stays as it is."""


class Variant(Record):
    """A print of the asset, by name; null for a part that stays as it is."""

    name: str = Field(min_length=1, description="Unique in the package.")
    parts: _ByPart[Changes]


def _differ(value: tuple[Variant, ...]) -> tuple[Variant, ...]:
    if len({variant.name for variant in value}) < len(value):
        raise PydanticCustomError("FIELD_VALUE", "names that differ")
    return value


class Variants(Extension):
    """Prints that a host may choose in the place of the asset's own."""

    NAME: ClassVar[str] = "RNA_variants"
    variants: Annotated[
        tuple[Variant, ...], Field(min_length=1, max_length=MAX_VARIANTS), AfterValidator(_differ)
    ]


def variant_records(manifest: Manifest, part: int) -> list[BaseColorFields]:
    """The records of all variants in the place of a part's own records."""
    data = extension(manifest, Variants)
    changes = [variant.parts[part] or () for variant in data.variants] if data else []
    return [change for of_variant in changes for change in of_variant if change is not None]


def changed_record(record: BaseColorRecord, change: BaseColorFields | None) -> BaseColorRecord:
    """The record of the same triangles in a variant."""
    if change is None:
        return record
    return BaseColorRecord(triangles=record.triangles, **dict(change))


T = TypeVar("T", bound=Extension)
Item = TypeVar("Item", covariant=True)
EXTENSIONS: tuple[type[Extension], ...] = (
    Deflate,
    Poster,
    Standin,
    Proxy,
    Environment,
    Source,
    StandinTextures,
    Variants,
    Sampling,
)


def extension(manifest: Manifest, of: type[T]) -> T | None:
    """The data of the extension in a manifest that was checked; None if it is not used."""
    data = manifest.extensions.get(of.NAME)
    return None if data is None else model_of(of, data)


def part_sampling(manifest: Manifest, part: int) -> tuple[Mixture, ...]:
    """Mixtures of lobes for rays that leave a part: its own, or the usual one of its kind."""
    return of_part(manifest, Sampling, part) or (USUAL_SAMPLING[manifest.parts[part].kind],)


class _ByPartExtension(Protocol[Item]):
    @property
    def parts(self) -> tuple[Item | None, ...]: ...


def of_part(manifest: Manifest, of: type[_ByPartExtension[Item]], part: int) -> Item | None:
    """An extension's data about this part, if it has members by part; None without."""
    data: Any = extension(manifest, cast(type[Extension], of))
    item: Item | None = data.parts[part] if data else None
    return item

"""The short form of a manifest, that of 1.0: one part, whose members stand beside the others."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pydantic import Field, field_validator

from rna_sdk.package.container.strict_json import pointer
from rna_sdk.package.limits import MAX_TIERS
from rna_sdk.package.manifest.manifest_fields import Bounds, EntryPath, Kind, Name
from rna_sdk.package.manifest.manifest_model import Manifest, ManifestFields, Part
from rna_sdk.package.manifest.manifest_tiers import (
    Cost,
    Tier,
    TierPart,
    TierPartFields,
    Validation,
    check_unique,
)

PART_NAME = "asset"
"""Name of the only part of a file in the short form."""


class ShortTier(TierPartFields):
    """A tier of one part, planes and decoder in it."""

    name: Name = Field(description="What hosts call the tier; unique in the package.")
    validation: Validation | None = None
    cost: Cost | None = None


class ShortManifest(ManifestFields):
    """manifest.json of one part that has nothing new since 1.0."""

    kind: Kind = Field(description="What the geometry is: a mesh, or curves.")
    bounds: Bounds
    geometry: EntryPath = Field(description="Entry with the mesh or the curves.")
    tiers: tuple[ShortTier, ...] = Field(min_length=1, max_length=MAX_TIERS)

    @field_validator("tiers")
    @classmethod
    def _unique_tiers(cls, value: tuple[ShortTier, ...]) -> tuple[ShortTier, ...]:
        check_unique((tier.name for tier in value), "TIER_DUPLICATE", "tier")
        return value


def in_parts(short: ShortManifest) -> Manifest:
    """The manifest with its part and tier parts as such."""
    part = Part(name=PART_NAME, kind=short.kind, bounds=short.bounds, geometry=short.geometry)
    tiers = tuple(
        Tier(
            name=tier.name,
            parts=(TierPart(**_members(tier, TierPartFields)),),
            validation=tier.validation,
            cost=tier.cost,
        )
        for tier in short.tiers
    )
    return Manifest(**_members(short, ManifestFields), parts=(part,), tiers=tiers)


def in_short(manifest: Manifest) -> ShortManifest:
    """The short form of a manifest of one part that `has_short_form`; the part's name is lost."""
    (part,) = manifest.parts
    tiers = tuple(
        ShortTier(
            name=tier.name,
            **_members(tier.parts[0], TierPartFields),
            validation=tier.validation,
            cost=tier.cost,
        )
        for tier in manifest.tiers
    )
    return ShortManifest(
        **_members(manifest, ManifestFields),
        kind=part.kind,
        bounds=part.bounds,
        geometry=part.geometry,
        tiers=tiers,
    )


def has_short_form(manifest: Manifest) -> bool:
    """Whether the manifest has one part, and no member that is new since 1.0."""
    if len(manifest.parts) != 1 or manifest.parts[0].transmittance or manifest.parts[0].normal_maps:
        return False
    return all(len(part.decoders) == 1 for tier in manifest.tiers for part in tier.parts)


def _members(record: Any, of: Any) -> dict[str, Any]:
    return {name: getattr(record, name) for name in of.model_fields}


@dataclass(frozen=True)
class Places:
    """JSON pointers into a manifest, in the form that its file has.

    Attributes:
        short: whether that is the short form.
    """

    short: bool

    def part(self, part: int, *path: str | int) -> str:
        """Pointer to a part, or to a member of it."""
        return pointer(*(() if self.short else ("parts", part)), *path)

    def tier_part(self, tier: int, part: int, *path: str | int) -> str:
        """Pointer to a part of a tier, or to a member of it."""
        return pointer("tiers", tier, *(() if self.short else ("parts", part)), *path)

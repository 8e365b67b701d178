"""Order of a package's entries."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from rna_sdk.package.manifest.manifest_model import Manifest, Part
from rna_sdk.package.manifest.manifest_tiers import Tier


def _shared_names(parts: tuple[Part, ...]) -> Iterator[str]:
    """Entries of all tiers, some perhaps twice: geometry and textures of the parts."""
    for part in parts:
        yield part.geometry
        yield from (entry for _, entry in part.texture_paths)


def _tier_names(tier: Tier) -> Iterator[str]:
    """Entries of the tier, some perhaps twice: planes and decoders of its parts."""
    for part in tier.parts:
        yield part.planes
        yield from (decoder.entry for decoder in part.decoders)


def ordered(manifest: Manifest, entries: Iterable[str]) -> list[str]:
    """The entries behind the manifest: those that every tier needs first.

    Geometry and textures; what several tiers share; what each tier has alone, tier after tier; the
    others, which are those of extensions, in their own order. A reader then finds all of one tier
    in two ranges of bytes.
    """
    tier_names = [dict.fromkeys(_tier_names(tier)) for tier in manifest.tiers]
    users = Counter(name for names in tier_names for name in names)
    of_tiers = [name for names in tier_names for name in names]
    first = dict.fromkeys(_shared_names(manifest.parts))
    order = [*first, *(name for name in of_tiers if users[name] > 1), *of_tiers, *entries]
    return list(dict.fromkeys(order))

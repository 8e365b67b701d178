"""In which order the entries of a package are stored."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from rna_sdk.package.manifest.manifest_model import Manifest
from rna_sdk.package.manifest.tier_ranges import shared_names, tier_names


def ordered(manifest: Manifest, entries: Iterable[str]) -> list[str]:
    """The entries behind the manifest: those that every tier needs first.

    Geometry and textures; what several tiers share; what each tier has alone, tier after tier; the
    others, which are those of extensions, in their own order. A reader then finds all of one tier
    in two ranges of bytes.
    """
    own = [dict.fromkeys(tier_names(tier)) for tier in manifest.tiers]
    users = Counter(name for names in own for name in names)
    of_tiers = [name for names in own for name in names]
    first = dict.fromkeys(shared_names(manifest.parts))
    order = [*first, *(name for name in of_tiers if users[name] > 1), *of_tiers, *entries]
    return list(dict.fromkeys(order))

"""Order of a package's entries, and the byte ranges that one tier needs: for readers of parts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from rna_sdk.package.container.zip_container import MANIFEST_NAME
from rna_sdk.package.manifest.manifest_model import Manifest, Part
from rna_sdk.package.manifest.manifest_tiers import Tier


def tier_ranges(layout: Mapping[str, range], manifest: Manifest, tier: Tier) -> list[range]:
    """Byte ranges of everything that the tier needs, the manifest included, ascending.

    Adjacent entries are merged. Packages of `write_package` have at most two ranges: the manifest
    with shared entries, and the tier's own entries.

    layout: byte range of each entry that the tier needs, its header included, by name: from
        `Package.layout`, or from the central directory of a remote file.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     ranges = tier_ranges(package.layout(), package.manifest, package.tier("small"))
        >>> ranges[0].start
        0
    """
    needed = {MANIFEST_NAME, *_shared_names(manifest.parts), *_tier_names(tier)}
    ranges: list[range] = []
    for entry in sorted((layout[name] for name in needed), key=lambda entry: entry.start):
        if ranges and ranges[-1].stop == entry.start:
            ranges[-1] = range(ranges[-1].start, entry.stop)
        else:
            ranges.append(entry)
    return ranges


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

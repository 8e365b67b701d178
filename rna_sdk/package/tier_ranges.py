"""Which bytes of a package one tier needs: for readers that fetch ranges of a file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from rna_sdk.package.container import MANIFEST_NAME
from rna_sdk.package.manifest import Manifest, Part
from rna_sdk.package.manifest_tiers import Tier


def tier_ranges(layout: Mapping[str, range], manifest: Manifest, tier: Tier) -> list[range]:
    """The bytes with everything that the tier needs, the manifest included: ascending ranges.

    Entries next to each other make one range. In a package of `write_package` there are two at
    most: the manifest and what tiers share, then the tier's own.

    layout: name -> bytes of the entry with its header, of every entry that the tier needs, as
        `Package.layout` has it, or the central directory of a file somewhere else.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     ranges = tier_ranges(package.layout(), package.manifest, package.tier("small"))
        >>> ranges[0].start
        0
    """
    needed = {MANIFEST_NAME, *shared_names(manifest.parts), *tier_names(tier)}
    ranges: list[range] = []
    for entry in sorted((layout[name] for name in needed), key=lambda entry: entry.start):
        if ranges and ranges[-1].stop == entry.start:
            ranges[-1] = range(ranges[-1].start, entry.stop)
        else:
            ranges.append(entry)
    return ranges


def shared_names(parts: tuple[Part, ...]) -> Iterator[str]:
    """Entries of all tiers, some perhaps twice: geometry and textures of the parts."""
    for part in parts:
        yield part.geometry
        yield from (record.texture for record in part.transmittance)
        yield from (record.texture for record in part.normal_maps)


def tier_names(tier: Tier) -> Iterator[str]:
    """Entries of the tier, some perhaps twice: planes and decoders of its parts."""
    for part in tier.parts:
        yield from (part.planes, part.decoder)
        if part.emission:
            yield part.emission.decoder

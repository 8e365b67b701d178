"""Rules that span members of a manifest: names, blocks, ranges and references."""

from collections.abc import Iterator
from itertools import pairwise

from rna_sdk.package.container.strict_json import pointer
from rna_sdk.package.decoder.decoder_form import FORMS
from rna_sdk.package.issues import Code, Issue
from rna_sdk.package.manifest.extension_checks import (
    KNOWN_EXTENSIONS,
    extension_issues,
    input_issues,
)
from rna_sdk.package.manifest.manifest_fields import references
from rna_sdk.package.manifest.manifest_model import Manifest

RANGE_CODES = {
    "transmittance": Code.TRANSMITTANCE_RANGE,
    "normalMaps": Code.NORMAL_MAP_RANGE,
    "baseColor": Code.BASE_COLOR_RANGE,
}
"""By member of a part."""


def manifest_issues(manifest: Manifest) -> list[Issue]:
    """Errors in the relations between members that are each valid."""
    differing = list(_differing_parts(manifest))
    return differing or [
        *_extension_issues(manifest),
        *extension_issues(manifest),
        *_input_issues(manifest),
        *_texture_issues(manifest),
        *_reference_issues(manifest),
    ]


def manifest_warnings(manifest: Manifest) -> list[Issue]:
    """Warnings about an accepted manifest."""
    return [
        Issue.of(Code.EXTENSION_UNKNOWN, pointer("extensionsUsed", i), name, "a known extension")
        for i, name in enumerate(manifest.extensions_used)
        if name not in KNOWN_EXTENSIONS
    ]


def _differing_parts(manifest: Manifest) -> Iterator[Issue]:
    """Every tier is of all parts, and each part has decoders of the same forms in all tiers."""
    first = manifest.tiers[0].parts
    for i, tier in enumerate(manifest.tiers):
        if len(tier.parts) != len(manifest.parts):
            where, expected = pointer("tiers", i, "parts"), f"{len(manifest.parts)}, as /parts"
            yield Issue.of(Code.PARTS_DIFFER, where, f"{len(tier.parts)} parts", expected)
            return
        for k, (part, other) in enumerate(zip(tier.parts, first, strict=True)):
            for form in FORMS:
                if (has := form.record(part) is not None) != (form.record(other) is not None):
                    found = form.name if has else f"no {form.name}"
                    expected, where = f"as in /tiers/0/parts/{k}", pointer("tiers", i, "parts", k)
                    yield Issue.of(Code.PARTS_DIFFER, where, found, expected)


def _extension_issues(manifest: Manifest) -> list[Issue]:
    places = [(pointer("extensions", name), name) for name in manifest.extensions]
    places += [
        (pointer("extensionsRequired", i), name)
        for i, name in enumerate(manifest.extensions_required)
    ]
    return [
        Issue.of(Code.EXTENSION_UNDECLARED, where, name, "a name in extensionsUsed")
        for where, name in places
        if name not in manifest.extensions_used
    ]


def _input_issues(manifest: Manifest) -> list[Issue]:
    """Every block is one that the kind of part can fill, of the arrays of the decoder's form."""
    issues: list[Issue] = []
    for i, tier in enumerate(manifest.tiers):
        for k, part in enumerate(tier.parts):
            kind = manifest.parts[k].kind
            for decoder in part.decoders:
                what = f"{decoder.form.name} of {kind}" if decoder.form.member else kind
                where = pointer("tiers", i, "parts", k, *decoder.form.path, "inputs")
                issues += input_issues(decoder, kind, what, where)
            if part.uses_base_color and not manifest.parts[k].base_color:
                where = pointer("tiers", i, "parts", k, "usesBaseColor")
                expected = f"false, or baseColor in /parts/{k}"
                issues.append(Issue.of(Code.FIELD_VALUE, where, "true", expected))
    return issues


def _texture_issues(manifest: Manifest) -> Iterator[Issue]:
    """Surfaces alone have records with textures, of ranges of triangles that ascend."""
    for k, part in enumerate(manifest.parts):
        for name, records in part.ranges.items():
            if part.kind != "surface" and records:
                where = pointer("parts", k, name)
                yield Issue.of(Code.FIELD_VALUE, where, f"of a {part.kind}", "of a surface")
            ranges = [record.triangles for record in records]
            for j, ((first, count), (second, _)) in enumerate(pairwise(ranges)):
                if second < first + count:
                    where = pointer("parts", k, name, j + 1, "triangles")
                    expected = f"{first + count} or more, behind those of the record before"
                    yield Issue.of(RANGE_CODES[name], where, second, expected)


def _reference_issues(manifest: Manifest) -> list[Issue]:
    """Every path names a declared entry, and every declared entry is named by a path."""
    paths = [*references(manifest.parts, "parts"), *references(manifest.tiers, "tiers")]
    named = {entry for _, entry in paths}
    issues = [
        Issue.of(Code.REFERENCE_MISSING, pointer(*path), entry, "a key of /entries")
        for path, entry in paths
        if entry not in manifest.entries
    ]
    folders = tuple(f"extensions/{name}/" for name in manifest.extensions_used)
    issues += [
        Issue.of(Code.ENTRY_UNREFERENCED, pointer("entries", path), path, "a path that is used")
        for path in manifest.entries
        if path not in named and not path.startswith(folders)
    ]
    return issues

"""What spans the members of a manifest: names, versions, blocks, ranges and references."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from rna_sdk.package.container.strict_json import pointer
from rna_sdk.package.decoder.decoder_form import FORMS
from rna_sdk.package.issues import Code, Issue
from rna_sdk.package.manifest.extension_checks import KNOWN_EXTENSIONS, extension_issues
from rna_sdk.package.manifest.input_checks import input_issues
from rna_sdk.package.manifest.manifest_fields import FIRST_WITH_PARTS, version_number
from rna_sdk.package.manifest.manifest_model import Manifest
from rna_sdk.package.manifest.manifest_short import Places


def manifest_issues(manifest: Manifest, places: Places) -> list[Issue]:
    """Errors in the relations between members that are each valid."""
    differing = list(_differing_parts(manifest, places))
    return differing or [
        *_version_issues(manifest, places),
        *_extension_issues(manifest),
        *extension_issues(manifest),
        *_input_issues(manifest, places),
        *_texture_issues(manifest, places),
        *_reference_issues(manifest, places),
    ]


def manifest_warnings(manifest: Manifest) -> list[Issue]:
    """Warnings about an accepted manifest."""
    return [
        Issue.of(Code.EXTENSION_UNKNOWN, pointer("extensionsUsed", i), name, "a known extension")
        for i, name in enumerate(manifest.extensions_used)
        if name not in KNOWN_EXTENSIONS
    ]


def references(manifest: Manifest, places: Places) -> Iterator[tuple[str, str]]:
    """(JSON pointer, entry) of every path in the manifest."""
    for k, part in enumerate(manifest.parts):
        yield places.part(k, "geometry"), part.geometry
        for j, record in enumerate(part.transmittance):
            yield places.part(k, "transmittance", j, "texture"), record.texture
        for j, mapped in enumerate(part.normal_maps):
            yield places.part(k, "normalMaps", j, "texture"), mapped.texture
    for i, tier in enumerate(manifest.tiers):
        for k, tier_part in enumerate(tier.parts):
            yield places.tier_part(i, k, "planes"), tier_part.planes
            for own in tier_part.decoders:
                yield places.tier_part(i, k, *own.form.path, "decoder"), own.entry


def _version_issues(manifest: Manifest, places: Places) -> list[Issue]:
    if places.short or version_number(manifest.min_reader_version) >= FIRST_WITH_PARTS:
        return []
    found = f"{manifest.min_reader_version}, with `parts`"
    return [Issue.of(Code.VERSION_TOO_OLD, "/minReaderVersion", found, "1.1 at least")]


def _differing_parts(manifest: Manifest, places: Places) -> Iterator[Issue]:
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
                    expected = f"as in {places.tier_part(0, k)}"
                    yield Issue.of(Code.PARTS_DIFFER, places.tier_part(i, k), found, expected)


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


def _input_issues(manifest: Manifest, places: Places) -> list[Issue]:
    """Every block is one that the kind of part can fill, of the arrays of the decoder's form."""
    issues: list[Issue] = []
    for i, tier in enumerate(manifest.tiers):
        for k, part in enumerate(tier.parts):
            kind = manifest.parts[k].kind
            for own in part.decoders:
                what = f"{own.form.name} of {kind}" if own.form.member else kind
                where = places.tier_part(i, k, *own.form.path, "inputs")
                issues += input_issues(own, kind, what, where)
    return issues


def _texture_issues(manifest: Manifest, places: Places) -> Iterator[Issue]:
    """Surfaces alone have records with textures, of ranges of triangles that ascend."""
    for k, part in enumerate(manifest.parts):
        for name, code, records in (
            ("transmittance", Code.TRANSMITTANCE_RANGE, part.transmittance),
            ("normalMaps", Code.NORMAL_MAP_RANGE, part.normal_maps),
        ):
            if part.kind != "surface" and records:
                where = places.part(k, name)
                yield Issue.of(Code.FIELD_VALUE, where, f"of a {part.kind}", "of a surface")
            ranges = [record.triangles for record in records]
            for j, ((first, count), (second, _)) in enumerate(pairwise(ranges)):
                if second < first + count:
                    where = places.part(k, name, j + 1, "triangles")
                    expected = f"{first + count} or more, behind those of the record before"
                    yield Issue.of(code, where, second, expected)


def _reference_issues(manifest: Manifest, places: Places) -> list[Issue]:
    """Every path names a declared entry, and every declared entry is named by a path."""
    paths = list(references(manifest, places))
    named = {path for _, path in paths}
    issues = [
        Issue.of(Code.REFERENCE_MISSING, where, path, "a key of /entries")
        for where, path in paths
        if path not in manifest.entries
    ]
    folders = tuple(f"extensions/{name}/" for name in manifest.extensions_used)
    issues += [
        Issue.of(Code.ENTRY_UNREFERENCED, pointer("entries", path), path, "a path that is used")
        for path in manifest.entries
        if path not in named and not path.startswith(folders)
    ]
    return issues

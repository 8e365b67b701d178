"""Checks of the extensions that the specification defines."""

from collections.abc import Iterator

from pydantic import ValidationError

from rna_sdk.package.container.strict_json import model_of, pointer
from rna_sdk.package.decoder.decoder_form import PartDecoder
from rna_sdk.package.issues import Code, Issue
from rna_sdk.package.limits import MAX_FILE_BYTES
from rna_sdk.package.manifest.deflate import largest_decoded
from rna_sdk.package.manifest.extensions import (
    EXTENSIONS,
    LARGEST_SHARE,
    Deflate,
    Environment,
    EnvironmentPart,
    Extension,
    Mixture,
    Proxy,
    Sampling,
    Source,
    Standin,
    StandinTextures,
    Variants,
)
from rna_sdk.package.manifest.manifest_fields import Kind, references
from rna_sdk.package.manifest.manifest_model import Manifest, Part
from rna_sdk.package.manifest.schema_issues import schema_issues

KNOWN_EXTENSIONS = frozenset(extension.NAME for extension in EXTENSIONS)


def extension_issues(manifest: Manifest) -> list[Issue]:
    """The errors in the data of known extensions."""
    issues: list[Issue] = []
    for known in EXTENSIONS:
        if known.NAME in manifest.extensions:
            try:
                data = model_of(known, manifest.extensions[known.NAME])
            except ValidationError as error:
                issues += schema_issues(error, "extensions", known.NAME)
            else:
                issues += _data_issues(data, manifest)
        elif known.NAME in manifest.extensions_used:
            found = f"{known.NAME} in extensionsUsed"
            issues.append(
                Issue.of(Code.FIELD_MISSING, pointer("extensions", known.NAME), found, "its data")
            )
    return issues


def input_issues(decoder: PartDecoder, kind: Kind, what: str, where: str) -> Iterator[Issue]:
    """INPUT_KIND of each block that the kind of part cannot fill, or the decoder's form does not.

    what: it is for, for the message. where: JSON pointer of the decoder's `inputs`.
    """
    known = decoder.form.blocks(kind)
    for j, name in enumerate(decoder.inputs):
        if name not in known:
            yield Issue.of(Code.INPUT_KIND, f"{where}/{j}", name, f"for {what}: {', '.join(known)}")


def _data_issues(data: Extension, manifest: Manifest) -> Iterator[Issue]:
    if isinstance(data, Deflate):
        yield from _deflate_issues(data, manifest)
    by_part = Standin | StandinTextures | Proxy | Environment | Source | Sampling
    if isinstance(data, by_part) and len(data.parts) != len(manifest.parts):
        where, expected = pointer("extensions", data.NAME, "parts"), f"{len(manifest.parts)}"
        yield Issue.of(Code.PARTS_DIFFER, where, f"{len(data.parts)} parts", expected)
        return
    if isinstance(data, Variants):
        yield from _variant_issues(data, manifest)
    for path, entry in references(data):
        if entry not in manifest.entries:
            where = pointer("extensions", data.NAME, *path)
            yield Issue.of(Code.REFERENCE_MISSING, where, entry, "a key of /entries")
    if isinstance(data, by_part):
        for k, (part, item) in enumerate(zip(manifest.parts, data.parts, strict=True)):
            if item is not None:
                yield from _part_issues(
                    data, part, k, item, pointer("extensions", data.NAME, "parts", k)
                )


def _part_issues(
    data: Extension, part: Part, index: int, item: object, where: str
) -> Iterator[Issue]:
    """Whether an extension may have this item of a part, by its index; where: its JSON pointer."""
    if isinstance(item, EnvironmentPart):
        what = f"environment of {part.kind}"
        yield from input_issues(item.optional_decoder, part.kind, what, f"{where}/inputs")
    if isinstance(data, Sampling):
        for j, mixture in enumerate(data.parts[index] or ()):
            yield from _mixture_issues(mixture, part.kind, f"{where}/{j}")
    textured = part.transmittance or part.normal_maps
    if (isinstance(data, Proxy) and (textured or part.base_color)) or (
        isinstance(data, StandinTextures) and textured
    ):
        found = f"{data.NAME} of a part with textures"
        yield Issue.of(Code.FIELD_VALUE, where, found, "null")
    if isinstance(data, Source | StandinTextures) and part.kind != "surface":
        yield Issue.of(Code.FIELD_VALUE, where, f"{data.NAME} of a {part.kind}", "null")


def _mixture_issues(item: Mixture, kind: Kind, where: str) -> Iterator[Issue]:
    """Whether the lobes fit a kind of part, and leave a share to all directions."""
    known = ("cosine", "mirror") if kind == "surface" else ("forward", "cone")
    for name in sorted(item.model_fields_set - {"first", *known}):
        expected = f"of a {kind}: {' and '.join(known)}"
        yield Issue.of(Code.FIELD_VALUE, f"{where}/{name}", name, expected)
    if kind == "fiber" and item.first:
        yield Issue.of(Code.FIELD_VALUE, f"{where}/first", f"{item.first} of strands", "0")
    total = sum(share for share, _ in item.lobes)
    if total > LARGEST_SHARE:
        found = f"shares that add up to {total:.6g}"
        yield Issue.of(Code.FIELD_VALUE, where, found, f"at most {LARGEST_SHARE}")


def _variant_issues(data: Variants, manifest: Manifest) -> Iterator[Issue]:
    """Each variant is of all parts, and of all records of base colour of those that it changes."""
    for j, variant in enumerate(data.variants):
        if len(variant.parts) != len(manifest.parts):
            found, expected = f"{len(variant.parts)} parts", f"{len(manifest.parts)}"
            yield Issue.of(
                Code.PARTS_DIFFER,
                pointer("extensions", data.NAME, "variants", j, "parts"),
                found,
                expected,
            )
            continue
        for k, (part, changes) in enumerate(zip(manifest.parts, variant.parts, strict=True)):
            if changes is not None and len(changes) != len(part.base_color):
                found, expected = f"{len(changes)} records", f"{len(part.base_color)}, as baseColor"
                yield Issue.of(
                    Code.FIELD_VALUE,
                    pointer("extensions", data.NAME, "variants", j, "parts", k),
                    found,
                    expected,
                )


def _deflate_issues(data: Deflate, manifest: Manifest) -> Iterator[Issue]:
    where = pointer("extensions", data.NAME)
    if data.NAME not in manifest.extensions_required:
        yield Issue.of(Code.EXTENSION_UNDECLARED, where, data.NAME, "a name in extensionsRequired")
    total = sum(coding.size for coding in data.entries.values())
    if total > MAX_FILE_BYTES:
        found, expected = f"{total} decoded bytes", f"at most {MAX_FILE_BYTES}"
        yield Issue.of(Code.FIELD_VALUE, f"{where}/entries", found, expected)
        return
    for name, coding in data.entries.items():
        stored = manifest.entries[name].size if name in manifest.entries else 0
        if name in manifest.entries and coding.size > largest_decoded(stored):
            place = pointer("extensions", data.NAME, "entries", name, "size")
            expected = f"at most {largest_decoded(stored)}, for {stored} bytes stored"
            yield Issue.of(Code.DEFLATE_SIZE, place, f"{coding.size} bytes", expected)

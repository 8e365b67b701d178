"""Packages whose manifest is wrong, or does not fit the entries."""

from __future__ import annotations

import json

from rna_sdk.package.container.zip_container import MANIFEST_NAME
from tests.package.builders import pack
from tests.package.corpus.registry import (
    DECODER,
    MESH,
    PLANES,
    Entries,
    case,
    part,
    tier_part,
    with_manifest,
)


def with_text(entries: Entries, old: str, new: str) -> bytes:
    """The package with a replacement in the text of the manifest."""
    text = entries[MANIFEST_NAME].decode()
    assert old in text
    return pack({**entries, MANIFEST_NAME: text.replace(old, new, 1).encode()}.items())


@case("MANIFEST_TOO_LARGE")
def huge_manifest(entries: Entries) -> bytes:
    return pack({**entries, MANIFEST_NAME: entries[MANIFEST_NAME] + b" " * 2**20}.items())


@case("MANIFEST_NOT_JSON")
def manifest_cut_short(entries: Entries) -> bytes:
    return pack({**entries, MANIFEST_NAME: entries[MANIFEST_NAME][:200]}.items())


@case("MANIFEST_NOT_JSON")
def manifest_not_utf8(entries: Entries) -> bytes:
    return with_manifest_bytes(entries, "utf-16")


@case("MANIFEST_NOT_JSON")
def manifest_with_byte_order_mark(entries: Entries) -> bytes:
    return with_manifest_bytes(entries, "utf-8-sig")


def with_manifest_bytes(entries: Entries, encoding: str) -> bytes:
    text = entries[MANIFEST_NAME].decode()
    return pack({**entries, MANIFEST_NAME: text.encode(encoding)}.items())


@case("MANIFEST_NOT_JSON")
def manifest_not_an_object(entries: Entries) -> bytes:
    return pack({**entries, MANIFEST_NAME: b"[]"}.items())


@case("MANIFEST_NOT_JSON")
def manifest_deeply_nested(entries: Entries) -> bytes:
    return with_text(entries, '"extras": {}', '"extras": {"x": ' + "[" * 90 + "]" * 90 + "}")


@case("MANIFEST_NOT_JSON")
def manifest_nested_past_the_stack(entries: Entries) -> bytes:
    return with_text(entries, '"extras": {}', '"extras": ' + "[" * 200_000 + "]" * 200_000)


@case("JSON_DUPLICATE_KEY")
def duplicate_key(entries: Entries) -> bytes:
    return with_text(entries, '"kind": "surface"', '"kind": "surface", "kind": "surface"')


@case("JSON_DUPLICATE_KEY")
def duplicate_key_in_other_words(entries: Entries) -> bytes:
    return with_text(entries, '"extras": {}', '"extras": {"a": 1, "\\u0061": 2}')


@case("JSON_NOT_FINITE")
def nan_in_the_manifest(entries: Entries) -> bytes:
    return with_text(entries, "-1.0", "NaN")


@case("JSON_NOT_FINITE")
def number_too_large(entries: Entries) -> bytes:
    return with_text(entries, '"extras": {}', '"extras": {"x": 1e999}')


@case("JSON_NOT_FINITE")
def integer_of_400_digits(entries: Entries) -> bytes:
    return with_text(entries, '"extras": {}', f'"extras": {{"x": {"9" * 400}}}')


@case("JSON_NOT_FINITE")
def integer_of_5000_digits(entries: Entries) -> bytes:
    return with_text(entries, '"extras": {}', f'"extras": {{"x": -{"9" * 5000}}}')


@case("FORMAT_UNKNOWN")
def other_format(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(format="gltf"))


@case("VERSION_TOO_NEW")
def next_major_version(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(version="3.0", novel=1))


@case("VERSION_TOO_NEW")
def next_minor_version(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(version="2.1"))


@case("VERSION_TOO_OLD")
def version_before(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(version="1.1", minReaderVersion="1.0"))


@case("KIND_UNSUPPORTED")
def unknown_kind(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: part(m).update(kind="volume"))


@case("KIND_UNSUPPORTED")
def kind_of_another_type(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: part(m).update(kind=["surface"]))


@case("KIND_UNSUPPORTED")
def kind_that_is_null(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: part(m).update(kind=None))


@case("EXTENSION_REQUIRED")
def unknown_required_extension(entries: Entries) -> bytes:
    names = ["EXT_novel"]
    return with_manifest(
        entries, lambda m: m.update(extensionsUsed=names, extensionsRequired=names)
    )


@case("EXTENSION_UNKNOWN")
def unknown_used_extension(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(extensionsUsed=["EXT_novel"]))


@case("EXTENSION_UNDECLARED")
def undeclared_extension(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(extensions={"EXT_novel": {}}))


@case("FIELD_UNKNOWN")
def unknown_field(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["tiers"][0].update(colour="red"))


@case("FIELD_UNKNOWN")
def python_name_of_a_field(entries: Entries) -> bytes:
    return with_text(entries, '"extensionsUsed"', '"extensions_used"')


@case("FIELD_MISSING")
def missing_field(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.pop("license"))


@case("FIELD_MISSING")
def missing_version(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.pop("version"))


@case("FIELD_VALUE")
def number_as_text(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m).update(resolution="8"))


@case("FIELD_VALUE")
def list_for_an_extension(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(extensionsRequired=[["rna_x"]]))


@case("FIELD_VALUE")
def malformed_version(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(version="two"))


@case("FIELD_VALUE")
def no_tiers(entries: Entries) -> bytes:
    manifest = json.loads(entries[MANIFEST_NAME])
    only_mesh = {MESH: manifest["entries"][MESH]}
    remaining = {name: entries[name] for name in (MANIFEST_NAME, MESH)}
    return with_manifest(remaining, lambda m: m.update(tiers=[], entries=only_mesh))


@case("FIELD_VALUE")
def resolution_over_the_limit(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m).update(resolution=10**9))


@case("MANIFEST_NOT_JSON")
def unpaired_surrogate(entries: Entries) -> bytes:
    return with_text(entries, '"tetrahedron"', '"\\ud800"')


def validation(*heights: int) -> dict[str, object]:
    """A tier's, with errors at these heights."""
    table = [{"height": height, "flip": 0.1} for height in heights]
    measures = {"psnr": 30.0, "flip": 0.1, "relativeMse": 0.1, "images": 1, "definition": "-"}
    return {**measures, "flipAtHeight": table}


@case("FIELD_VALUE")
def heights_that_grow(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["tiers"][0].update(validation=validation(20, 40)))


@case("FIELD_VALUE")
def unknown_region(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["domain"].update(wo="disk"))


@case("FIELD_VALUE")
def no_cones(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["domain"].update(wi=[]))


@case("FIELD_VALUE")
def too_many_cones(entries: Entries) -> bytes:
    cones = [{"axis": [0, 1, 0], "halfAngle": 0.1}] * 17
    return with_manifest(entries, lambda m: m["domain"].update(wi=cones))


@case("FIELD_VALUE")
def axis_that_is_not_unit(entries: Entries) -> bytes:
    cone = {"axis": [0, 0, 2], "halfAngle": 0.1}
    return with_manifest(entries, lambda m: m["domain"].update(wi=[cone]))


@case("BOUNDS_EMPTY")
def bounds_alike_in_float32(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: part(m)["bounds"]["max"].__setitem__(1, -1 + 2.0**-26))


@case("BOUNDS_EMPTY")
def bounds_of_a_tiny_extent(entries: Entries) -> bytes:
    box = {"min": [-1, -1, 0], "max": [1, 1, 9e-19]}
    return with_manifest(entries, lambda m: part(m).update(bounds=box))


@case("FIELD_VALUE")
def bounds_beyond_the_limit(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: part(m)["bounds"]["max"].__setitem__(1, 1.1e18))


@case("FIELD_MISSING")
def units_without_a_length(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(units={}))


@case("FIELD_VALUE")
def tier_without_input_blocks(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m).update(inputs=[]))


@case("FIELD_VALUE")
def version_with_a_leading_zero(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(version="02.0"))


@case("FIELD_VALUE")
def version_with_a_line_break(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(version="2.0\n"))


@case("FIELD_VALUE")
def version_that_is_a_number(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(version=2.0))


@case("VERSION_TOO_NEW")
def minor_version_of_two_digits(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(version="2.10"))


@case("FIELD_VALUE")
def extras_that_are_null(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m.update(extras=None))


@case("FIELD_VALUE")
def size_past_every_integer(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["entries"][PLANES].update(size=2**53))


@case("BOUNDS_EMPTY")
def bounds_inverted(entries: Entries) -> bytes:
    return with_manifest(
        entries, lambda m: part(m).update(bounds={"min": [1, 1, 1], "max": [0, 2, 2]})
    )


@case("BOUNDS_EMPTY")
def bounds_flat(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: part(m)["bounds"]["max"].__setitem__(1, -1.0))


@case("TIER_DUPLICATE")
def duplicate_tier_names(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["tiers"].append(m["tiers"][0]))


@case("INPUT_UNKNOWN")
def unknown_input_block(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m)["inputs"].append("albedo"))


@case("INPUT_UNKNOWN")
def input_block_twice(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m)["inputs"].append("wo"))


@case("INPUT_KIND")
def surface_with_a_tangent(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m)["inputs"].__setitem__(1, "tangent"))


@case("INPUT_KIND", "fiber")
def fiber_with_a_normal(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m)["inputs"].__setitem__(1, "normal"))


@case("REFERENCE_MISSING")
def path_to_nowhere(entries: Entries) -> bytes:
    remaining = {name: data for name, data in entries.items() if name != DECODER}
    return with_manifest(remaining, lambda m: m["entries"].pop(DECODER))


@case("ENTRY_UNDECLARED")
def undeclared_entry(entries: Entries) -> bytes:
    return pack([*entries.items(), ("notes.txt", b"hello")])


@case("ENTRY_MISSING")
def missing_entry(entries: Entries) -> bytes:
    return pack((name, data) for name, data in entries.items() if name != PLANES)


@case("ENTRY_UNREFERENCED")
def unreferenced_entry(entries: Entries) -> bytes:
    record = json.loads(entries[MANIFEST_NAME])["entries"][MESH]
    copied = {**entries, "geometry/copy.glb": entries[MESH]}
    return with_manifest(copied, lambda m: m["entries"].update({"geometry/copy.glb": record}))


@case("ENTRY_SIZE")
def wrong_size(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["entries"][PLANES].update(size=10**12))


@case("ENTRY_HASH")
def wrong_hash(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["entries"][PLANES].update(sha256="0" * 64))

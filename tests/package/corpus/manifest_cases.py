"""Packages whose manifest is wrong, or does not fit the entries."""

import json

from rna_sdk.package.container.zip_container import MANIFEST_NAME
from tests.package.builders import pack
from tests.package.corpus.registry import (
    DECODER,
    MESH,
    PLANES,
    Corpus,
    Entries,
    in_manifest,
    part,
    tier_part,
    with_manifest,
    without,
)

CASES = Corpus("surface")


def with_text(entries: Entries, old: str, new: str) -> bytes:
    """The package with a replacement in the text of the manifest."""
    text = entries[MANIFEST_NAME].decode()
    assert old in text
    return pack({**entries, MANIFEST_NAME: text.replace(old, new, 1).encode()}.items())


CASES.add(
    "MANIFEST_TOO_LARGE",
    huge_manifest=lambda e: pack({**e, MANIFEST_NAME: e[MANIFEST_NAME] + b" " * 2**20}.items()),
)
CASES.add(
    "MANIFEST_NOT_JSON",
    manifest_cut_short=lambda e: pack({**e, MANIFEST_NAME: e[MANIFEST_NAME][:200]}.items()),
    manifest_not_utf8=lambda e: with_manifest_bytes(e, "utf-16"),
    manifest_with_byte_order_mark=lambda e: with_manifest_bytes(e, "utf-8-sig"),
    manifest_not_an_object=lambda e: pack({**e, MANIFEST_NAME: b"[]"}.items()),
    manifest_deeply_nested=lambda e: with_text(
        e, '"extras": {}', '"extras": {"x": ' + "[" * 90 + "]" * 90 + "}"
    ),
    manifest_nested_past_the_stack=lambda e: with_text(
        e, '"extras": {}', '"extras": ' + "[" * 200_000 + "]" * 200_000
    ),
    unpaired_surrogate=lambda e: with_text(e, '"tetrahedron"', '"\\ud800"'),
)


def with_manifest_bytes(entries: Entries, encoding: str) -> bytes:
    text = entries[MANIFEST_NAME].decode()
    return pack({**entries, MANIFEST_NAME: text.encode(encoding)}.items())


CASES.add(
    "JSON_DUPLICATE_KEY",
    duplicate_key=lambda e: with_text(
        e, '"kind": "surface"', '"kind": "surface", "kind": "surface"'
    ),
    duplicate_key_in_other_words=lambda e: with_text(
        e, '"extras": {}', '"extras": {"a": 1, "\\u0061": 2}'
    ),
)
CASES.add(
    "JSON_NOT_FINITE",
    nan_in_the_manifest=lambda e: with_text(e, "-1.0", "NaN"),
    number_too_large=lambda e: with_text(e, '"extras": {}', '"extras": {"x": 1e999}'),
    integer_of_400_digits=lambda e: with_text(e, '"extras": {}', f'"extras": {{"x": {"9" * 400}}}'),
    integer_of_5000_digits=lambda e: with_text(
        e, '"extras": {}', f'"extras": {{"x": -{"9" * 5000}}}'
    ),
)
CASES.add("FORMAT_UNKNOWN", other_format=in_manifest(lambda m: m.update(format="gltf")))
CASES.add(
    "VERSION_TOO_NEW",
    next_major_version=in_manifest(lambda m: m.update(version="3.0", novel=1)),
    next_minor_version=in_manifest(lambda m: m.update(version="2.1")),
    minor_version_of_two_digits=in_manifest(lambda m: m.update(version="2.10")),
)
CASES.add(
    "VERSION_TOO_OLD",
    version_before=in_manifest(lambda m: m.update(version="1.1", minReaderVersion="1.0")),
)
CASES.add(
    "KIND_UNSUPPORTED",
    unknown_kind=in_manifest(lambda m: part(m).update(kind="volume")),
    kind_of_another_type=in_manifest(lambda m: part(m).update(kind=["surface"])),
    kind_that_is_null=in_manifest(lambda m: part(m).update(kind=None)),
)


@CASES.case("EXTENSION_REQUIRED")
def unknown_required_extension(entries: Entries) -> bytes:
    names = ["EXT_novel"]
    return with_manifest(
        entries, lambda m: m.update(extensionsUsed=names, extensionsRequired=names)
    )


CASES.add(
    "EXTENSION_UNKNOWN",
    unknown_used_extension=in_manifest(lambda m: m.update(extensionsUsed=["EXT_novel"])),
)
CASES.add(
    "EXTENSION_UNDECLARED",
    undeclared_extension=in_manifest(lambda m: m.update(extensions={"EXT_novel": {}})),
)
CASES.add(
    "FIELD_UNKNOWN",
    albedo_at_another_angle=in_manifest(
        lambda m: m["tiers"][0].update(validation=returning(ratio=1.0, at45=1.0))
    ),
    unknown_field=in_manifest(lambda m: m["tiers"][0].update(colour="red")),
    python_name_of_a_field=lambda e: with_text(e, '"extensionsUsed"', '"extensions_used"'),
)
CASES.add(
    "FIELD_MISSING",
    albedo_of_no_ratio=in_manifest(
        lambda m: m["tiers"][0].update(validation=returning(facing=1.0))
    ),
    missing_field=in_manifest(lambda m: m.pop("license")),
    missing_version=in_manifest(lambda m: m.pop("version")),
    units_without_a_length=in_manifest(lambda m: m.update(units={})),
)
CASES.add(
    "FIELD_VALUE",
    number_as_text=in_manifest(lambda m: tier_part(m).update(resolution="8")),
    list_for_an_extension=in_manifest(lambda m: m.update(extensionsRequired=[["rna_x"]])),
    malformed_version=in_manifest(lambda m: m.update(version="two")),
    resolution_over_the_limit=in_manifest(lambda m: tier_part(m).update(resolution=10**9)),
    heights_that_grow=in_manifest(lambda m: m["tiers"][0].update(validation=validation(20, 40))),
    albedo_below_black=in_manifest(lambda m: m["tiers"][0].update(validation=returning(ratio=-1))),
    albedo_that_is_null=in_manifest(
        lambda m: m["tiers"][0].update(validation={**validation(40), "albedo": None})
    ),
    unknown_region=in_manifest(lambda m: m["domain"].update(wo="disk")),
    no_cones=in_manifest(lambda m: m["domain"].update(wi=[])),
    too_many_cones=in_manifest(
        lambda m: m["domain"].update(wi=[{"axis": [0, 1, 0], "halfAngle": 0.1}] * 17)
    ),
    axis_that_is_not_unit=in_manifest(
        lambda m: m["domain"].update(wi=[{"axis": [0, 0, 2], "halfAngle": 0.1}])
    ),
    bounds_beyond_the_limit=in_manifest(lambda m: part(m)["bounds"]["max"].__setitem__(1, 1.1e18)),
    tier_without_input_blocks=in_manifest(lambda m: tier_part(m).update(inputs=[])),
    version_with_a_leading_zero=in_manifest(lambda m: m.update(version="02.0")),
    version_with_a_line_break=in_manifest(lambda m: m.update(version="2.0\n")),
    version_that_is_a_number=in_manifest(lambda m: m.update(version=2.0)),
    extras_that_are_null=in_manifest(lambda m: m.update(extras=None)),
    size_past_every_integer=in_manifest(lambda m: m["entries"][PLANES].update(size=2**53)),
)


@CASES.case("FIELD_VALUE")
def no_tiers(entries: Entries) -> bytes:
    manifest = json.loads(entries[MANIFEST_NAME])
    only_mesh = {MESH: manifest["entries"][MESH]}
    remaining = {name: entries[name] for name in (MANIFEST_NAME, MESH)}
    return with_manifest(remaining, lambda m: m.update(tiers=[], entries=only_mesh))


def validation(*heights: int) -> dict[str, object]:
    """A tier's, with errors at these heights."""
    table = [{"height": height, "flip": 0.1} for height in heights]
    measures = {"psnr": 30.0, "flip": 0.1, "relativeMse": 0.1, "images": 1, "definition": "-"}
    return {**measures, "flipAtHeight": table}


def returning(**albedo: float) -> dict[str, object]:
    """A tier's, with this albedo."""
    return {**validation(40), "albedo": albedo}


CASES.add(
    "BOUNDS_EMPTY",
    bounds_alike_in_float32=in_manifest(
        lambda m: part(m)["bounds"]["max"].__setitem__(1, -1 + 2.0**-26)
    ),
    bounds_of_a_tiny_extent=in_manifest(
        lambda m: part(m).update(bounds={"min": [-1, -1, 0], "max": [1, 1, 9e-19]})
    ),
    bounds_inverted=in_manifest(
        lambda m: part(m).update(bounds={"min": [1, 1, 1], "max": [0, 2, 2]})
    ),
    bounds_flat=in_manifest(lambda m: part(m)["bounds"]["max"].__setitem__(1, -1.0)),
)
CASES.add(
    "TIER_DUPLICATE", duplicate_tier_names=in_manifest(lambda m: m["tiers"].append(m["tiers"][0]))
)
CASES.add(
    "INPUT_UNKNOWN",
    unknown_input_block=in_manifest(lambda m: tier_part(m)["inputs"].append("albedo")),
    input_block_twice=in_manifest(lambda m: tier_part(m)["inputs"].append("wo")),
)
CASES.add(
    "INPUT_KIND",
    surface_with_a_tangent=in_manifest(lambda m: tier_part(m)["inputs"].__setitem__(1, "tangent")),
)


@CASES.case("INPUT_KIND", "fiber")
def fiber_with_a_normal(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: tier_part(m)["inputs"].__setitem__(1, "normal"))


CASES.add(
    "REFERENCE_MISSING",
    path_to_nowhere=lambda e: without(e, DECODER),
)
CASES.add(
    "ENTRY_UNDECLARED", undeclared_entry=lambda e: pack([*e.items(), ("notes.txt", b"hello")])
)
CASES.add(
    "ENTRY_MISSING",
    missing_entry=lambda e: pack((name, data) for name, data in e.items() if name != PLANES),
)


@CASES.case("ENTRY_UNREFERENCED")
def unreferenced_entry(entries: Entries) -> bytes:
    record = json.loads(entries[MANIFEST_NAME])["entries"][MESH]
    copied = {**entries, "geometry/copy.glb": entries[MESH]}
    return with_manifest(copied, lambda m: m["entries"].update({"geometry/copy.glb": record}))


CASES.add("ENTRY_SIZE", wrong_size=in_manifest(lambda m: m["entries"][PLANES].update(size=10**12)))


@CASES.case("ENTRY_HASH")
def wrong_hash(entries: Entries) -> bytes:
    return with_manifest(entries, lambda m: m["entries"][PLANES].update(sha256="0" * 64))

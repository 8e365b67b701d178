"""One table of values: reader, schema and text of the spec agree on each."""

import json
import re
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from rna_sdk.errors import PackageError
from rna_sdk.package import validate
from rna_sdk.package.manifest.manifest_reader import parse_manifest
from rna_sdk.package.manifest.schema import manifest_schema
from tests.package.corpus.content_cases import with_gltf
from tests.package.corpus.curve_cases import with_header
from tests.package.corpus.registry import tier_part

SPEC = Path(__file__).parents[2] / "spec" / "RNA.md"
TEXT = re.sub(r"\s+", " ", SPEC.read_text(encoding="utf-8"))

PLANES_SIZE = "/entries/features~1small.safetensors/size"
VALIDATION = '{"psnr": 30, "flip": 0.1, "relativeMse": 0.1, "images": 1, "definition": ""'
COST = '{"nsPerQuery": 1, "threads": 1, "machine": "", "multiplyAdds": '
CONE = '[{"axis": [0, 1, 0], "halfAngle": '

REQUIRED = 'Members of the manifest are required unless marked "optional".'
LISTED = "An unlisted member is an error."
WHOLE = "`8`, `8.0` and `8e0` are the same."
LARGEST = "from -(2^53 - 1) to 2^53 - 1"
CONVERTED = '`"8"`, `true` and `null` are not numbers.'
NULL = '`null` is a value only where a table lists "null"'
NOT_RECORDED = "an absent member and null mean the same: not recorded."
FINITE = "It must be finite: `1e400`, `NaN` and `Infinity` are errors."
PATTERN = 'A pattern matches the whole string: `"2.0\\n"` does not match'
VERSION = 'but not `"02.0"`, `"2.00"` or `"2"`'
COORDINATE = "each number from -1e18 to 1e18"
BOX = '`{"min": [x, y, z], "max": [x, y, z]}`'
EXTENT = "On every axis `max - min` is at least 1e-18"
ROUNDED = "A reader rounds the six numbers to binary32"
BLOCKS = "one block at least, each at most once"
TWICE = "may be empty; a repeated name counts once"
NAMES = "matches `[A-Za-z0-9][A-Za-z0-9._-]*` with at most 64 characters"
EMPTY = "A string may be empty unless a rule excludes it"
HALF_ANGLE = "`halfAngle` from 0 to the binary64 3.141592653589793"
AXIS = "`axis` of length 1 within 0.001"
ENTRY = "`digest` the SHA-256 (FIPS 180-4) of the data as 64 lower-case hex digits"
HEIGHTS = "each height below the one before"
ALBEDO = "`ratio`, and optionally `facing`, `at60` and `at80`, numbers of 0 or more"
TABLE_OF_ERRORS = "Where the array is absent or empty, `flip` of `validation` is the error"
FREE = "and within `extras`, `extensions` and the two free objects"
CHARACTERS = "and may contain any character, including U+0000"

# Where, the JSON put there, the code of the reader, the sentence; a "*" before the code marks what
# spans values, which no schema sees.
VALUES = [
    ("/units", "{}", "FIELD_MISSING", REQUIRED),
    ("/units", "null", "FIELD_VALUE", NULL),
    ("/units", '{"length": "metre", "mass": "kilogram"}', "FIELD_UNKNOWN", LISTED),
    ("/tiers/0/parts/0/resolution", "8.0", "", WHOLE),
    ("/tiers/0/parts/0/resolution", "0.8e1", "", WHOLE),
    ("/tiers/0/parts/0/resolution", "8.5", "FIELD_VALUE", WHOLE),
    ("/tiers/0/parts/0/resolution", '"8"', "FIELD_VALUE", CONVERTED),
    ("/tiers/0/parts/0/resolution", "true", "FIELD_VALUE", CONVERTED),
    ("/tiers/0/parts/0/resolution", "-0", "FIELD_VALUE", "`-0` is 0"),
    (PLANES_SIZE, "1536.0", "", WHOLE),
    (PLANES_SIZE, "1e3", "", WHOLE),
    (PLANES_SIZE, "-0.0", "", "`-0` is 0"),
    (PLANES_SIZE, "-1", "FIELD_VALUE", "`size` is an integer of at least 0"),
    (PLANES_SIZE, "9007199254740991", "", LARGEST),
    (PLANES_SIZE, "9007199254740992", "FIELD_VALUE", LARGEST),
    (PLANES_SIZE, "9007199254740993.0", "FIELD_VALUE", LARGEST),
    (PLANES_SIZE, "1e30", "FIELD_VALUE", LARGEST),
    ("/tiers/0/cost", COST + "1e3}", "", WHOLE),
    ("/tiers/0/cost", COST + "1e16}", "FIELD_VALUE", LARGEST),
    ("/tiers/0/parts/0/inputs", "[]", "FIELD_VALUE", BLOCKS),
    ("/tiers/0/parts/0/inputs", '["wo", "wo"]', "INPUT_UNKNOWN", BLOCKS),
    ("/tiers/0/parts/0/inputs", '["h"]', "*INPUT_KIND", "only blocks for the part's `kind`"),
    ("/tiers/0/name", '"a\\n"', "FIELD_VALUE", PATTERN),
    ("/tiers/0/validation", "null", "", NOT_RECORDED),
    ("/tiers/0/cost", "null", "", NOT_RECORDED),
    ("/tiers/0/parts/0/agreement", "null", "", NOT_RECORDED),
    ("/tiers/0/validation", VALIDATION + "}", "", EMPTY),
    ("/tiers/0/validation", VALIDATION + ', "flipAtHeight": []}', "", TABLE_OF_ERRORS),
    ("/tiers/0/validation", VALIDATION + ', "flipAtHeight": null}', "FIELD_VALUE", NULL),
    (
        "/tiers/0/validation",
        VALIDATION + ', "flipAtHeight": [{"height": 8, "flip": 1}, {"height": 8, "flip": 1}]}',
        "*FIELD_VALUE",
        HEIGHTS,
    ),
    ("/tiers/0/validation", VALIDATION + ', "albedo": {"ratio": 0}}', "", ALBEDO),
    ("/tiers/0/validation", VALIDATION + ', "albedo": {"ratio": 1, "at80": 2.5}}', "", ALBEDO),
    ("/tiers/0/validation", VALIDATION + ', "albedo": {"at80": 1}}', "FIELD_MISSING", ALBEDO),
    ("/tiers/0/validation", VALIDATION + ', "albedo": {"ratio": -1}}', "FIELD_VALUE", ALBEDO),
    ("/version", '"2.0"', "", "This is version 2.0."),
    ("/version", '"2.10"', "VERSION_TOO_NEW", "2.10 is greater than 2.9"),
    ("/version", '"10.0"', "VERSION_TOO_NEW", "Versions compare as two integers"),
    ("/version", '"1.1"', "VERSION_TOO_OLD", "A reader refuses a package of another version"),
    ("/version", '"02.0"', "FIELD_VALUE", VERSION),
    ("/version", '"2.00"', "FIELD_VALUE", VERSION),
    ("/version", '"2"', "FIELD_VALUE", VERSION),
    ("/version", '" 2.0"', "FIELD_VALUE", PATTERN),
    ("/version", '"2.0\\n"', "FIELD_VALUE", PATTERN),
    ("/version", "2.0", "FIELD_VALUE", "A **version** is a string"),
    ("/extensionsUsed", "[]", "", TWICE),
    ("/extensionsUsed", '["A", "A"]', "", TWICE),
    ("/extensionsUsed", '["A\\n"]', "FIELD_VALUE", PATTERN),
    ("/extensionsUsed", '[""]', "FIELD_VALUE", NAMES),
    ("/extensionsUsed", json.dumps(["A" * 65]), "FIELD_VALUE", NAMES),
    ("/extensionsUsed", "null", "FIELD_VALUE", NULL),
    ("/extensionsRequired", "null", "FIELD_VALUE", NULL),
    ("/extensionsRequired", "[1]", "FIELD_VALUE", NAMES),
    ("/extensionsRequired", "[]", "", TWICE),
    ("/extensions", "null", "FIELD_VALUE", NULL),
    ("/extensions", '{"a b": 1}', "FIELD_VALUE", NAMES),
    ("/extras", "null", "FIELD_VALUE", NULL),
    ("/extras", '{"a": [null, 1e300, 12345678901234567890]}', "", FREE),
    ("/name", '""', "FIELD_VALUE", "string, not empty"),
    ("/name", '"a\\u0000b"', "", CHARACTERS),
    ("/generator", '""', "", EMPTY),
    ("/provenance/source", '""', "", EMPTY),
    ("/provenance/capture", "null", "FIELD_VALUE", NULL),
    ("/parts/0/bounds/min", "[-1, -1]", "FIELD_VALUE", BOX),
    (
        "/parts/0/bounds/min",
        "[-1, -1, -1, -1]",
        "FIELD_VALUE",
        '`{"min": [x, y, z], "max": [x, y, z]}`',
    ),
    ("/parts/0/bounds/min/0", "-0", "", "`-0` is 0"),
    ("/parts/0/bounds/min/0", "-1e-400", "", "A number is the binary64 nearest to its text"),
    ("/parts/0/bounds/min/0", "-1e18", "", COORDINATE),
    ("/parts/0/bounds/min/0", "-1.1e18", "FIELD_VALUE", COORDINATE),
    ("/extras", '{"a": 1e400}', "*JSON_NOT_FINITE", FINITE),
    ("/parts/0/bounds/min/0", "1", "*BOUNDS_EMPTY", EXTENT),
    ("/parts/0/bounds/min/0", "0.9999999999", "*BOUNDS_EMPTY", ROUNDED),
    ("/parts/0/bounds/min/0", "0.9999999", "", ROUNDED),
    ("/domain/wo", CONE + "3.14159265358979323846}]", "", HALF_ANGLE),
    ("/domain/wo", CONE + "3.1415927}]", "FIELD_VALUE", HALF_ANGLE),
    ("/domain/wo", CONE + "0}]", "", HALF_ANGLE),
    ("/domain/wo", '[{"axis": [0, 1.0009, 0], "halfAngle": 1}]', "", AXIS),
    ("/domain/wo", '[{"axis": [0, 1.0011, 0], "halfAngle": 1}]', "*FIELD_VALUE", AXIS),
    ("/entries/features~1small.safetensors/sha256", json.dumps("A" * 64), "FIELD_VALUE", ENTRY),
    ("/entries/features~1small.safetensors/sha256", json.dumps("a" * 65), "FIELD_VALUE", ENTRY),
    (
        "/entries/a b",
        '{"size": 1, "sha256": ""}',
        "FIELD_VALUE",
        "**Names** are ASCII, have at most 200 bytes and match",
    ),
    ("/parts/0/geometry", '"geometry/mesh.glb\\n"', "FIELD_VALUE", PATTERN),
]


PARTS_NAME = "`[A-Za-z0-9][A-Za-z0-9._-]*`, at most 64"
RECORDS = "array of 1 to 64 records, optional, only of a `surface`"
CUTOFF = "greater than 0 and less than 1: a hole or none, with a sharp outline"
IOR = "two numbers from 0.01 to 100: light is also reflected by Fresnel's law"
TRIANGLES = "integers, `count` at least 1; ranges ascend, do not overlap, and lie inside the mesh"
TIER_PARTS = "array of one tier part for each part, in their order"
EMITS = "A part that has `emission` in one tier has it in all of them."
GLOW = "/tiers/0/parts/0/emission"
LEAF = "/parts/0/transmittance/0"

VALUES_OF_PARTS = [
    ("/parts", "[]", "FIELD_VALUE", "array of 1 to 16 [parts](#parts)"),
    ("/parts", "null", "FIELD_VALUE", NULL),
    ("/parts/0/name", '""', "FIELD_VALUE", PARTS_NAME),
    ("/parts/0/name", '"tuft"', "*PART_DUPLICATE", "unique in the package"),
    ("/parts/0/bounds/min/0", "1", "*BOUNDS_EMPTY", EXTENT),
    ("/parts/0/transmittance", "null", "FIELD_VALUE", NULL),
    ("/parts/0/transmittance", "{}", "FIELD_VALUE", RECORDS),
    (f"{LEAF}/cutoff", "0", "FIELD_VALUE", CUTOFF),
    (f"{LEAF}/cutoff", "1", "FIELD_VALUE", CUTOFF),
    (f"{LEAF}/cutoff", "1e-300", "", CUTOFF),
    (f"{LEAF}/cutoff", "null", "FIELD_VALUE", NULL),
    (f"{LEAF}/ior", "[1, 0]", "FIELD_VALUE", IOR),
    (f"{LEAF}/ior", "[101, 1]", "FIELD_VALUE", IOR),
    (f"{LEAF}/ior", "[0.01, 100]", "", IOR),
    (f"{LEAF}/ior", "[1]", "FIELD_VALUE", IOR),
    (f"{LEAF}/ior", "[1.5, 0.5]", "", IOR),
    (f"{LEAF}/ior", "null", "FIELD_VALUE", NULL),
    (f"{LEAF}/triangles", "[0, 0]", "FIELD_VALUE", TRIANGLES),
    (f"{LEAF}/triangles", "[-1, 1]", "FIELD_VALUE", TRIANGLES),
    (f"{LEAF}/triangles", "[0.0, 3e0]", "", WHOLE),
    (f"{LEAF}/triangles", "[0, 4]", "*TRANSMITTANCE_RANGE", TRIANGLES),
    (f"{LEAF}/triangles", "[3, 1]", "*TRANSMITTANCE_RANGE", TRIANGLES),
    ("/parts/1/transmittance", "[]", "FIELD_VALUE", RECORDS),
    (
        "/parts/1/transmittance",
        '[{"triangles": [0, 1], "texture": "transmittance/leaf.safetensors"}]',
        "*FIELD_VALUE",
        RECORDS,
    ),
    ("/kind", '"surface"', "FIELD_UNKNOWN", LISTED),
    ("/tiers/0/resolution", "8", "FIELD_UNKNOWN", LISTED),
    ("/tiers/0/parts", "[]", "FIELD_VALUE", TIER_PARTS),
    ("/tiers/0/parts/0/agreement", "null", "", NOT_RECORDED),
    ("/tiers/0/parts/1/emission", "null", "FIELD_VALUE", NULL),
    ("/tiers/0/validation", "null", "", NOT_RECORDED),
    (f"{GLOW}/agreement", "null", "", NOT_RECORDED),
    (f"{GLOW}/inputs", '["wi"]', "*INPUT_KIND", "of these blocks: `features`, `position`"),
    (f"{GLOW}/inputs", "[]", "FIELD_VALUE", BLOCKS),
    (f"{GLOW}/planes", '"features/body.safetensors"', "FIELD_UNKNOWN", LISTED),
]


def with_value(manifest: bytes, where: str, value: str) -> str:
    """The manifest's text with the JSON `value` at a pointer."""
    *path, last = (part.replace("~1", "/") for part in where[1:].split("/"))
    document = node = json.loads(manifest)
    for part in path:
        node = node[int(part) if isinstance(node, list) else part]
    node[int(last) if isinstance(node, list) else last] = "@"
    return json.dumps(document).replace('"@"', value)


def codes_of(text: str) -> set[str]:
    try:
        parse_manifest(text.encode())
    except PackageError as error:
        return {issue.code for issue in error.issues}
    return set()


@pytest.fixture(scope="module")
def schema():
    return jsonschema.Draft202012Validator(json.loads(manifest_schema()))


@pytest.mark.parametrize(("where", "value", "code", "sentence"), VALUES)
def test_reader_schema_and_text_agree(where, value, code, sentence, entries, schema):
    text = with_value(entries["manifest.json"], where, value)
    check(text, code, sentence, schema)


@pytest.mark.parametrize(("where", "value", "code", "sentence"), VALUES_OF_PARTS)
def test_reader_schema_and_text_agree_on_parts(where, value, code, sentence, good, schema):
    text = with_value(good["parts"]["manifest.json"], where, value)
    check(text, code, sentence, schema)


def check(text: str, code: str, sentence: str, schema: Any) -> None:
    """What reader and schema say of the manifest, and that the spec has the sentence."""
    is_valid, codes = code == "", codes_of(text)
    assert codes == (set() if is_valid else {code.removeprefix("*")})
    assert schema.is_valid(json.loads(text)) == (is_valid or code.startswith("*"))
    assert sentence in TEXT


def test_spelling_of_a_number_changes_nothing(entries):
    plain, spelt = (
        parse_manifest(with_value(entries["manifest.json"], PLANES_SIZE, size).encode())
        for size in ("1500", "1.5e3")
    )
    assert plain == spelt
    assert type(spelt.entries["features/small.safetensors"].size) is int


def test_integers_of_other_files_follow_the_same_rule(entries, fiber_entries, tmp_path):
    path = tmp_path / "spelt.rna"
    for data in (
        with_gltf(entries, lambda g: g["accessors"][0].update(count=12.0, componentType=5126.0)),
        with_gltf(entries, lambda g: g["nodes"][0].update(mesh=0.0)),
        with_header(fiber_entries, lambda h: h["radii"].update(shape=[9.0])),
    ):
        path.write_bytes(data)
        assert validate(path) == []


def test_false_is_no_zero_in_a_mesh(entries, tmp_path):
    path = tmp_path / "converted.rna"
    for data in (
        with_gltf(entries, lambda g: g["bufferViews"][1].update(buffer=False)),
        with_gltf(entries, lambda g: g.update(scene=False)),
        with_gltf(entries, lambda g: g["accessors"][0].update(normalized=0)),
        with_gltf(entries, lambda g: g["accessors"][0].update(normalized=True)),
    ):
        path.write_bytes(data)
        assert [issue.code for issue in validate(path)] == ["GEOMETRY_PROFILE"]


def test_bounds_are_rounded_for_every_reader(entries):
    text = with_value(entries["manifest.json"], "/parts/0/bounds/min/0", "0.1")
    manifest = parse_manifest(text.encode())
    corners = manifest.parts[0].bounds.corners()
    assert (corners.dtype, corners.shape) == ("float32", (2, 3))
    assert corners[0, 0] == 0.100000001490116119384765625


SPANNING = {
    *("BOUNDS_EMPTY", "INPUT_KIND", "EXTENSION_REQUIRED", "EXTENSION_UNDECLARED"),
    *("REFERENCE_MISSING", "ENTRY_UNREFERENCED"),
    *("PARTS_DIFFER", "PART_DUPLICATE", "TRANSMITTANCE_RANGE"),
}
"""Codes about more than one value, which no schema gives."""

SWAPS = [
    *("null", "true", "0", "-0.0", "1", "1.0", "1.5", "-1", "1e3", "2e18", "-1e300", "1e16"),
    *('""', '"a"', '"A_b.c-1"', '"a\\n"', '"1.0"', '"\\u0000"', '"geometry/mesh.glb"', '"metre"'),
    *("[]", "[0]", "[1, 2, 3]", '["a"]', '["wi"]', "[null]", "[[]]"),
    *("{}", '{"a": 1}', '{"wo": "sphere", "wi": "sphere"}', '{"length": "metre"}'),
]


def places(value: Any, where: str = "") -> list[str]:
    """Pointers to all values inside `value`."""
    if not isinstance(value, dict | list):
        return [where] if where else []
    children = value.items() if isinstance(value, dict) else enumerate(value)
    inside = [
        place
        for key, child in children
        for place in places(child, f"{where}/{str(key).replace('/', '~1')}")
    ]
    return [where, *inside] if where else inside


def measured(manifest: dict[str, Any]) -> dict[str, Any]:
    """The manifest with everything that may be recorded."""
    heights = [{"height": 8, "flip": 0.5}]
    manifest["tiers"][0] |= {
        "validation": json.loads(VALIDATION + "}") | {"flipAtHeight": heights},
        "cost": json.loads(COST + "1}"),
    }
    tier_part(manifest)["agreement"] = {"maxAbsolute": 0, "maxRelative": 0}
    manifest["domain"]["wi"] = json.loads(CONE + "1}]")
    return manifest


@pytest.mark.parametrize(("base", "below"), [("surface", ""), ("parts", ("/parts", "/tiers/0"))])
def test_reader_and_schema_agree_wherever_a_value_stands(base, below, good, schema):
    manifest = json.loads(good[base]["manifest.json"])
    manifest = measured(manifest)
    data = json.dumps(manifest).encode()
    assert codes_of(data.decode()) == set()
    for where in filter(lambda where: where.startswith(below), places(manifest)):
        for value in SWAPS:
            text = with_value(data, where, value)
            codes = codes_of(text)
            of_the_axis = where.startswith("/domain/wi/0/axis") and codes == {"FIELD_VALUE"}
            if not of_the_axis:
                expected = codes <= SPANNING
                assert schema.is_valid(json.loads(text)) == expected, (where, value, codes)

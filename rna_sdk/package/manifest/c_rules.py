"""The JSON Schema of the manifest as tables of C: `python -m rna_sdk.package.manifest.c_rules`."""

import json
import re
import sys
import textwrap
from typing import Any

from rna_sdk.package.generated import generate, note
from rna_sdk.package.manifest.schema import manifest_schema

_MODULE = "rna_sdk.package.manifest.c_rules"
_CHECKS = {
    "Part": "is_a_surface",
    "Part.bounds": "bounds_have_an_extent",
    "Cone.axis": "axis_is_unit",
    "Validation.flipAtHeight": "heights_descend",
    "TierNearby.lengths": "lengths_ascend",
    "Manifest.tiers": "tiers_are_unique",
    "Manifest.parts": "parts_are_unique",
    "inputs": "blocks_are_known",  # of any object
    "triangles": "counts_triangles",
}
"""Object, or a member of it -> the function of member_checks.h that checks more."""


def c_rules() -> str:
    """The text of the file: an array of rules for each object, those it needs before it."""
    schema = json.loads(manifest_schema())
    tables: dict[str, str] = {}
    _add_object("Manifest", schema, schema["$defs"], tables)
    return "\n".join(
        [
            f"/* The members of the manifest (section 3). {note(_MODULE)} */",
            "#ifndef RNA_MANIFEST_RULES_H\n#define RNA_MANIFEST_RULES_H\n",
            '#include "member_checks.h"\n',
            *tables.values(),
            "\n#endif\n",
        ]
    )


def _add_object(
    name: str, schema: dict[str, Any], defs: dict[str, Any], tables: dict[str, str]
) -> None:
    """Adds the array of an object's members to `tables`, and the arrays that it names."""
    rules = []
    for member, value in schema["properties"].items():
        for of in re.findall(r"#/\$defs/(\w+)", json.dumps(value)):
            if of not in tables and "properties" in defs[of]:
                _add_object(of, defs[of], defs, tables)
        flag = "REQUIRED" if member in schema.get("required", ()) else "0"
        if "oneOf" in value:  # a word, or the list which is_of_kind knows
            tables["regions"] = f"static const Rule CONES = {_rule('', value['oneOf'][1], '0')};"
            rules.append(f'{{"{member}", REGION, {flag}}}')
            continue
        check = _CHECKS.get(f"{name}.{member}", _CHECKS.get(member))
        rules.append(_rule(member, value, flag, check))
    unbroken = ", ".join(rule.replace(" ", "\N{NO-BREAK SPACE}") for rule in [*rules, "{0}"])
    text = f"static const Rule {_constant(name)}[] = {{ {unbroken}}};"
    lines = textwrap.wrap(text, 120, subsequent_indent="    ", break_long_words=False)
    tables[name] = "\n".join(lines).replace("\N{NO-BREAK SPACE}", " ")


def _constant(name: str) -> str:
    """The array's name: BASE_COLOR_RECORD of BaseColorRecord."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).upper()


def _rule(member: str, schema: dict[str, Any], flag: str, check: str | None = None) -> str:
    """An initializer of a rule."""
    if "anyOf" in schema:
        schema, flag = schema["anyOf"][0], "NULLABLE"
    parts = [f'"{member}"', *_kind(schema, flag, check)]
    return f"{{{', '.join(parts)}{f', .also = {check}' if check else ''}}}"


def _kind(schema: dict[str, Any], flag: str, check: str | None) -> list[str]:
    """Members of a rule from `kind` on."""
    if "$ref" in schema:
        name = schema["$ref"].split("/")[-1]
        return ["ANYTHING"] if name == "JsonValue" else ["OBJECT", flag, f".of = {_constant(name)}"]
    if "enum" in schema or "const" in schema:
        words = " ".join(schema.get("enum") or [schema["const"]])
        return ["CHOICE", flag, f'.choices = "{words}"']
    match schema["type"]:
        case "string" if "pattern" in schema:
            return [_text(schema), flag]
        case "string":
            return ["TEXT", flag, str(schema.get("minLength", 0))]
        case "boolean":
            return ["BOOLEAN", flag]
        case "object":
            key = _text(schema.get("propertyNames", {}))
            of = _item(schema["additionalProperties"])
            return ["MAP", flag, f".key = {key}", f".of = {of}"]
        case "array":
            items = schema.get("prefixItems") or [schema["items"]]
            if check is None and any(item != items[0] for item in items):
                raise ValueError(f"{schema}: expected equal items, or a check")
            item = {"type": "string"} if check == "blocks_are_known" else items[0]
            low, high = schema.get("minItems", 0), schema.get("maxItems", "HUGE_VAL")
            return ["LIST", flag, str(low), str(high), _item(item)]
    low = "DBL_TRUE_MIN" if schema.get("exclusiveMinimum") == 0 else None
    high = "1 - DBL_EPSILON / 2" if schema.get("exclusiveMaximum") == 1 else None
    low = low or repr(schema.get("minimum", "-HUGE_VAL")).strip("'")
    high = high or repr(schema.get("maximum", "HUGE_VAL")).strip("'")
    return [schema["type"].upper(), flag, low, high]


def _item(schema: dict[str, Any]) -> str:
    """A pointer to the rule of an item."""
    name = schema.get("$ref", "").split("/")[-1]
    return f"&(const Rule){_rule('', schema, '0', _CHECKS.get(name))}"


def _text(schema: dict[str, Any]) -> str:
    """The kind of text that has the schema's pattern."""
    pattern = schema.get("pattern", "")
    kinds = {"/": "PATH", "{64}": "SHA256", "^": "NAME", "": "ANYTHING"}
    return next(kind for part, kind in kinds.items() if part in pattern)


if __name__ == "__main__":
    sys.exit(generate({"examples/hosts/c/rna/manifest_rules.h": c_rules()}, _MODULE))

"""The constraints of a JSON Schema: which a value breaks, and values that break one each."""

import json
import re
from collections.abc import Callable, Iterator
from functools import cache
from typing import Any, NamedTuple

from rna_sdk.package.manifest.extensions import EXTENSIONS
from rna_sdk.package.manifest.schema import manifest_schema, model_schema

Json = dict[str, Any]


class Constraint(NamedTuple):
    """A keyword of a schema, at its place: names from the definition on; member: of `required`."""

    place: tuple[str, ...]
    keyword: str
    member: str = ""


class Node(NamedTuple):
    """A value in a document, and a schema that it has to fit."""

    schema: Json
    place: tuple[str, ...]
    value: Any
    path: tuple[str | int, ...]


_TYPES: dict[str, Callable[[Any], bool]] = {
    "object": lambda v: isinstance(v, dict),
    "array": lambda v: isinstance(v, list),
    "string": lambda v: isinstance(v, str),
    "boolean": lambda v: isinstance(v, bool),
    "number": lambda v: isinstance(v, int | float) and not isinstance(v, bool),
    "integer": lambda v: isinstance(v, int) and not isinstance(v, bool),
    "null": lambda v: v is None,
}
_LIMITS: dict[str, Callable[[Any, Any], bool]] = {
    "minimum": lambda v, limit: v >= limit,
    "maximum": lambda v, limit: v <= limit,
    "exclusiveMinimum": lambda v, limit: v > limit,
    "exclusiveMaximum": lambda v, limit: v < limit,
    "multipleOf": lambda v, limit: v % limit == 0,
    "pattern": lambda v, limit: re.search(limit, v) is not None,
    "not": lambda v, limit: re.search(limit["pattern"], v) is None,
    "minLength": lambda v, limit: len(v) >= limit,
    "maxLength": lambda v, limit: len(v) <= limit,
    "minItems": lambda v, limit: len(v) >= limit,
    "maxItems": lambda v, limit: len(v) <= limit,
    "enum": lambda v, limit: v in limit,
    "const": lambda v, limit: v == limit,
    "uniqueItems": lambda v, limit: len({json.dumps(item) for item in v}) == len(v),
}


@cache
def schemas() -> dict[str, Json]:
    """The manifest's, and those of the data of the extensions, by name."""
    of_extensions = {known.NAME: model_schema(known) for known in EXTENSIONS}
    return {"manifest": json.loads(manifest_schema()), **of_extensions}


def nodes(manifest: Json) -> Iterator[Node]:
    """Every value in a manifest that a schema speaks of, with that schema."""
    every = schemas()
    yield from _below(every["manifest"], Node(every["manifest"], ("manifest",), manifest, ()))
    data_of = manifest.get("extensions")
    for name, data in data_of.items() if isinstance(data_of, dict) else ():
        if name in every:
            at = Node(every[name], (name,), data, ("extensions", name))
            yield from _below(every[name], at)


def _below(root: Json, node: Node) -> Iterator[Node]:
    schema = node.schema
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        if name != "JsonValue":
            place = node.place[0], name
            yield from _below(root, node._replace(schema=root["$defs"][name], place=place))
        return
    if "anyOf" in schema:  # of the rest and null
        if node.value is not None:
            yield from _below(root, node._replace(schema=schema["anyOf"][0]))
        return
    if "oneOf" in schema:  # of schemas of different types
        for number, one in enumerate(schema["oneOf"]):
            if _TYPES[one["type"]](node.value):
                at = node._replace(schema=one, place=(*node.place, str(number)))
                yield from _below(root, at)
        return
    yield node
    for key, inner, part, value in _parts(schema, node.value):
        yield from _below(root, Node(inner, (*node.place, part), value, (*node.path, key)))


def _parts(schema: Json, value: Any) -> Iterator[tuple[str | int, Json, str, Any]]:
    """(key, schema, name in places, value) of the values in an object or an array."""
    if isinstance(value, dict) and "object" in schema.get("type", ""):
        known, others = schema.get("properties", {}), schema.get("additionalProperties", {})
        for key, item in value.items():
            if key in known:
                yield key, known[key], key, item
            elif isinstance(others, dict):
                yield key, others, "*", item
    elif isinstance(value, list):
        fixed = schema.get("prefixItems", [])
        alike = all(one == fixed[0] for one in fixed)
        for k, item in enumerate(value):
            if k < len(fixed):
                yield k, fixed[k], "*" if alike else str(k), item
            elif "items" in schema:
                yield k, schema["items"], "*", item


def constraints(node: Node) -> Iterator[tuple[Constraint, bool]]:
    """The constraints of a node's own schema, and whether its value breaks each."""
    schema, place, value = node.schema, node.place, node.value
    if "type" in schema:
        fits = _TYPES[schema["type"]](value)
        yield Constraint(place, "type"), not fits
        if not fits:
            return
    for keyword, holds in _LIMITS.items():
        if keyword in schema:
            yield Constraint(place, keyword), not holds(value, schema[keyword])
    for member in schema.get("required", []):
        yield Constraint(place, "required", member), member not in value
    if schema.get("additionalProperties") is False:
        unknown = value.keys() - schema.get("properties", {}).keys()
        yield Constraint(place, "additionalProperties"), bool(unknown)
    if "propertyNames" in schema:
        pattern = schema["propertyNames"].get("pattern", "")
        yield Constraint(place, "propertyNames"), not all(re.search(pattern, k) for k in value)


def broken_constraints(manifest: Json) -> set[Constraint]:
    """Those that a manifest breaks."""
    return {c for node in nodes(manifest) for c, breaks in constraints(node) if breaks}


def breaking(node: Node, constraint: Constraint) -> Iterator[Any]:
    """Values in the place of a node's that may break this constraint alone."""
    value, keyword, limit = node.value, constraint.keyword, node.schema.get(constraint.keyword)
    if keyword == "type":
        yield from {"integer": [1.5], "array": [{}], "object": [[]], "boolean": [1]}.get(
            limit, ["1", 1]
        )
    elif keyword == "required":
        yield {key: item for key, item in value.items() if key != constraint.member}
    elif keyword == "additionalProperties":
        yield {**value, "novel": 1}
    elif keyword == "propertyNames":
        yield from ({**value, name: next(iter(value.values()), {})} for name in ("a//b", "A B", ""))
    elif keyword in ("minimum", "exclusiveMinimum"):
        yield from (limit - step for step in (0, 1, 0.5, abs(limit)))
    elif keyword in ("maximum", "exclusiveMaximum"):
        yield from (limit + step for step in (0, 1, 0.5, abs(limit)))
    elif keyword == "multipleOf":
        yield value + 1
    elif keyword == "pattern":
        yield from ("a//b", "A" * 64, value.upper(), "a b", "+1", "x")
    elif keyword == "not":
        yield value + "\n"
    elif keyword in ("enum", "const"):
        yield from ("novel", 7)
    elif keyword == "uniqueItems":
        yield [*value, value[0]]
    elif keyword in ("minItems", "minLength"):
        yield value[: limit - 1]
    elif keyword == "maxLength":
        yield (value or "a") + "a" * (limit + 1 - len(value))
    elif keyword == "maxItems":
        more = range(limit + 1 - len(value))
        yield [*value, *([value[-1]] * len(more) if value else more)]
        yield [*value, *(f"name-{k}" for k in more)]


def replaced(document: Any, path: tuple[str | int, ...], value: Any) -> Any:
    """A copy with another value at the path."""
    if not path:
        return value
    key, *rest = path
    copy = dict(document) if isinstance(document, dict) else list(document)
    copy[key] = replaced(copy[key], tuple(rest), value)
    return copy


def all_constraints() -> set[Constraint]:
    """Constraints of all schemas, wherever a document may have them."""
    found: set[Constraint] = set()
    for name, root in schemas().items():
        seen: set[str] = set()
        for schema, place in _schemas_below(root, root, (name,), seen):
            found |= set(_named(schema, place))
    return found


def _named(schema: Json, place: tuple[str, ...]) -> Iterator[Constraint]:
    """The constraints of a schema itself."""
    for keyword in ("type", *_LIMITS, "propertyNames"):
        if keyword in schema:
            yield Constraint(place, keyword)
    for member in schema.get("required", []):
        yield Constraint(place, "required", member)
    if schema.get("additionalProperties") is False:
        yield Constraint(place, "additionalProperties")


def _schemas_below(
    root: Json, schema: Json, place: tuple[str, ...], seen: set[str]
) -> Iterator[tuple[Json, tuple[str, ...]]]:
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        if name != "JsonValue" and name not in seen:
            seen.add(name)
            yield from _schemas_below(root, root["$defs"][name], (place[0], name), seen)
        return
    if "anyOf" in schema:
        yield from _schemas_below(root, schema["anyOf"][0], place, seen)
        return
    for number, one in enumerate(schema.get("oneOf", [])):
        yield from _schemas_below(root, one, (*place, str(number)), seen)
    if "oneOf" in schema:
        return
    yield schema, place
    fixed, others = schema.get("prefixItems", []), schema.get("additionalProperties")
    alike = all(one == fixed[0] for one in fixed)
    inner = [*schema.get("properties", {}).items()]
    inner += [("*" if alike else str(k), one) for k, one in enumerate(fixed)]
    inner += [("*", one) for one in (schema.get("items"), others) if isinstance(one, dict)]
    for part, one in inner:
        yield from _schemas_below(root, one, (*place, part), seen)

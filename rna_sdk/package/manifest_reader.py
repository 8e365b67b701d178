"""From the bytes of manifest.json to a Manifest, or to the issues that stand against it."""

from __future__ import annotations

import json
import re
from typing import Any

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from rna_sdk.errors import PackageError
from rna_sdk.package.blocks import blocks_for
from rna_sdk.package.issues import Code, Issue, refuse
from rna_sdk.package.manifest import KINDS, REQUIRED_IN_FILE, VERSION_PATTERN, Manifest
from rna_sdk.package.strict_json import model_of, parse_object, pointer

READER_VERSION = (1, 0)
"""The format version this reader implements."""

KNOWN_EXTENSIONS: frozenset[str] = frozenset()

_SCHEMA_CODES = {"missing": Code.FIELD_MISSING, "extra_forbidden": Code.FIELD_UNKNOWN}


def parse_manifest(data: bytes) -> Manifest:
    """The manifest in `data`, once it fits this reader and the schema.

    Raises:
        PackageError: every schema issue at once; or the one that makes reading pointless.
    """
    raw = parse_object(data, "", Code.MANIFEST_NOT_JSON)
    _check_readable(raw)
    try:
        manifest = model_of(Manifest, raw)
    except ValidationError as error:
        raise PackageError(map(_schema_issue, _root_causes(error.errors()))) from None
    # The defaults of missing members would only be found guilty below.
    issues = _presence_issues(raw) or [
        *_extension_issues(manifest),
        *_input_issues(manifest),
        *_reference_issues(manifest),
    ]
    if issues:
        raise PackageError(issues)
    return manifest


def manifest_warnings(manifest: Manifest) -> list[Issue]:
    """What a reader should tell about a manifest that it accepts."""
    return [
        Issue.of(Code.EXTENSION_UNKNOWN, pointer("extensionsUsed", i), name, "a known extension")
        for i, name in enumerate(manifest.extensions_used)
        if name not in KNOWN_EXTENSIONS
    ]


def _check_readable(raw: dict[str, Any]) -> None:
    """What must hold before the fields of this version mean anything."""
    if raw.get("format") != "rna":
        refuse(Code.FORMAT_UNKNOWN, "/format", json.dumps(raw.get("format")), '"rna"')
    version = raw.get("minReaderVersion")
    if isinstance(version, str) and re.fullmatch(VERSION_PATTERN, version):
        major, minor = map(int, version.split("."))
        if (major, minor) > READER_VERSION:
            expected = "at most {}.{}".format(*READER_VERSION)
            refuse(Code.VERSION_TOO_NEW, "/minReaderVersion", version, expected)
    kind = raw.get("kind", KINDS[0])
    if kind not in KINDS:
        expected = " or ".join(map(json.dumps, KINDS))
        refuse(Code.KIND_UNSUPPORTED, "/kind", json.dumps(kind), expected)
    required = raw.get("extensionsRequired")
    for i, name in enumerate(required if isinstance(required, list) else []):
        if isinstance(name, str) and name not in KNOWN_EXTENSIONS:
            where = pointer("extensionsRequired", i)
            refuse(Code.EXTENSION_REQUIRED, where, json.dumps(name), "a known extension")


def _root_causes(details: list[ErrorDetails]) -> list[ErrorDetails]:
    """Without a list's "too short" that only says that its items failed."""
    return [
        detail
        for detail in details
        if detail["type"] != "too_short"
        or not any(other["loc"][:-1][: len(detail["loc"])] == detail["loc"] for other in details)
    ]


def _schema_issue(detail: ErrorDetails) -> Issue:
    kind = detail["type"]
    if kind == "missing" and isinstance(detail["loc"][-1], int):
        kind = "too_short"  # what an array lacks is no member
    code = _SCHEMA_CODES.get(kind, Code.FIELD_VALUE)
    if kind in Code.__members__:
        code = Code[kind]
    # Pydantic's own parts, and the tags of unions, stand in brackets.
    where = pointer(*(part for part in detail["loc"] if not str(part).startswith("[")))
    found = "nothing" if code is Code.FIELD_MISSING else repr(detail["input"])
    return Issue.of(code, where, found, detail["msg"])


def _presence_issues(raw: dict[str, Any]) -> list[Issue]:
    return [
        Issue.of(Code.FIELD_MISSING, pointer(name), "nothing", "Field required")
        for name in REQUIRED_IN_FILE
        if name not in raw
    ]


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
    """Every block is one that the kind of asset can fill."""
    known = blocks_for(manifest.kind)
    expected = f"for {manifest.kind}: {', '.join(known)}"
    return [
        Issue.of(Code.INPUT_KIND, pointer("tiers", i, "inputs", j), name, expected)
        for i, tier in enumerate(manifest.tiers)
        for j, name in enumerate(tier.inputs)
        if name not in known
    ]


def _reference_issues(manifest: Manifest) -> list[Issue]:
    """Every path names a declared entry, and every declared entry is named by a path."""
    places = [("/geometry", manifest.geometry)]
    for i, tier in enumerate(manifest.tiers):
        places.append((pointer("tiers", i, "planes"), tier.planes))
        places.append((pointer("tiers", i, "decoder"), tier.decoder))
    named = {path for _, path in places}
    issues = [
        Issue.of(Code.REFERENCE_MISSING, where, path, "a key of /entries")
        for where, path in places
        if path not in manifest.entries
    ]
    folders = tuple(f"extensions/{name}/" for name in manifest.extensions_used)
    issues += [
        Issue.of(Code.ENTRY_UNREFERENCED, pointer("entries", path), path, "a path that is used")
        for path in manifest.entries
        if path not in named and not path.startswith(folders)
    ]
    return issues

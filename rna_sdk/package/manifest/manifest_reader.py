"""From the bytes of manifest.json to a Manifest, or to the issues that stand against it."""

from __future__ import annotations

import json
import re
from typing import Any

from pydantic import ValidationError

from rna_sdk.errors import PackageError
from rna_sdk.package.container.strict_json import model_of, parse_object, pointer
from rna_sdk.package.issues import Code, Issue, refuse
from rna_sdk.package.manifest.extension_checks import KNOWN_EXTENSIONS
from rna_sdk.package.manifest.manifest_checks import manifest_issues
from rna_sdk.package.manifest.manifest_fields import KINDS, VERSION_PATTERN, version_number
from rna_sdk.package.manifest.manifest_model import REQUIRED_IN_FILE, Manifest
from rna_sdk.package.manifest.manifest_short import Places, ShortManifest, in_parts
from rna_sdk.package.manifest.schema_issues import schema_issues

READER_VERSION = "1.1"
"""The format version this reader implements."""


def parse_manifest(data: bytes) -> tuple[Manifest, Places]:
    """The manifest in `data`, once it fits this reader and the schema; and where things stand.

    Raises:
        PackageError: every schema issue at once; or the one that makes reading pointless.
    """
    raw = parse_object(data, "", Code.MANIFEST_NOT_JSON)
    _check_readable(raw)
    places = Places(short="parts" not in raw)
    try:
        manifest = (
            in_parts(model_of(ShortManifest, raw)) if places.short else model_of(Manifest, raw)
        )
    except ValidationError as error:
        raise PackageError(schema_issues(error)) from None
    # The defaults of missing members would only be found guilty below.
    issues = _presence_issues(raw) or manifest_issues(manifest, places)
    if issues:
        raise PackageError(issues)
    return manifest, places


def _check_readable(raw: dict[str, Any]) -> None:
    """Checks format and version, before any other field is read."""
    if raw.get("format") != "rna":
        refuse(Code.FORMAT_UNKNOWN, "/format", json.dumps(raw.get("format")), '"rna"')
    version = raw.get("minReaderVersion")
    if isinstance(version, str) and re.fullmatch(VERSION_PATTERN, version):
        if version_number(version) > version_number(READER_VERSION):
            where = "/minReaderVersion"
            refuse(Code.VERSION_TOO_NEW, where, version, f"at most {READER_VERSION}")
    for where, kind in _kinds(raw):
        if kind not in KINDS:
            expected = " or ".join(map(json.dumps, KINDS))
            refuse(Code.KIND_UNSUPPORTED, where, json.dumps(kind), expected)
    required = raw.get("extensionsRequired")
    for i, name in enumerate(required if isinstance(required, list) else []):
        if isinstance(name, str) and name not in KNOWN_EXTENSIONS:
            where = pointer("extensionsRequired", i)
            refuse(Code.EXTENSION_REQUIRED, where, json.dumps(name), "a known extension")


def _kinds(raw: dict[str, Any]) -> list[tuple[str, Any]]:
    """The kinds of parts, with their places, whatever they are."""
    parts = raw.get("parts")
    holders = [("", raw)] if "parts" not in raw else []
    for i, part in enumerate(parts if isinstance(parts, list) else []):
        if isinstance(part, dict):
            holders.append((pointer("parts", i), part))
    return [(f"{where}/kind", holder["kind"]) for where, holder in holders if "kind" in holder]


def _presence_issues(raw: dict[str, Any]) -> list[Issue]:
    return [
        Issue.of(Code.FIELD_MISSING, pointer(name), "nothing", "Field required")
        for name in REQUIRED_IN_FILE
        if name not in raw
    ]

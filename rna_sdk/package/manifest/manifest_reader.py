"""From the bytes of manifest.json to a Manifest, or to the issues that stand against it."""

import json
import re
from typing import Any

from pydantic import ValidationError

from rna_sdk.errors import PackageError
from rna_sdk.package.container.strict_json import model_of, parse_object, pointer
from rna_sdk.package.issues import Code, Issue, refuse
from rna_sdk.package.manifest.extension_checks import KNOWN_EXTENSIONS
from rna_sdk.package.manifest.manifest_checks import manifest_issues
from rna_sdk.package.manifest.manifest_fields import KINDS
from rna_sdk.package.manifest.manifest_model import REQUIRED_IN_FILE, VERSION, Manifest
from rna_sdk.package.manifest.schema_issues import schema_issues

_VERSION = re.compile(r"([1-9][0-9]{0,3})\.(0|[1-9][0-9]{0,3})")


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
        raise PackageError(schema_issues(error)) from None
    # The defaults of missing members would only be found guilty below.
    issues = _presence_issues(raw) or manifest_issues(manifest)
    if issues:
        raise PackageError(issues)
    return manifest


def _check_readable(raw: dict[str, Any]) -> None:
    """Checks format and version, before any other field is read."""
    if raw.get("format") != "rna":
        refuse(Code.FORMAT_UNKNOWN, "/format", json.dumps(raw.get("format")), '"rna"')
    _check_version(raw.get("version"))
    parts = raw.get("parts")
    for i, part in enumerate(parts if isinstance(parts, list) else []):
        kind = part.get("kind", KINDS[0]) if isinstance(part, dict) else KINDS[0]
        if kind not in KINDS:
            expected = " or ".join(map(json.dumps, KINDS))
            refuse(Code.KIND_UNSUPPORTED, pointer("parts", i, "kind"), json.dumps(kind), expected)
    required = raw.get("extensionsRequired")
    for i, name in enumerate(required if isinstance(required, list) else []):
        if isinstance(name, str) and name not in KNOWN_EXTENSIONS:
            where = pointer("extensionsRequired", i)
            refuse(Code.EXTENSION_REQUIRED, where, json.dumps(name), "a known extension")


def _check_version(version: object) -> None:
    """One that is no version is a wrong value like any other, which the schema finds."""
    if isinstance(version, str) and _VERSION.fullmatch(version):
        result, ours = (tuple(map(int, one.split("."))) for one in (version, VERSION))
        if result != ours:
            code = Code.VERSION_TOO_NEW if result > ours else Code.VERSION_TOO_OLD
            refuse(code, "/version", version, VERSION)


def _presence_issues(raw: dict[str, Any]) -> list[Issue]:
    return [
        Issue.of(Code.FIELD_MISSING, pointer(name), "nothing", "Field required")
        for name in REQUIRED_IN_FILE
        if name not in raw
    ]

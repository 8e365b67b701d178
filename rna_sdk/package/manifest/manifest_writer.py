"""The text of manifest.json."""

from __future__ import annotations

import json
from typing import Any

from rna_sdk.package.manifest.manifest_fields import FIRST_WITH_PARTS, version_number
from rna_sdk.package.manifest.manifest_model import Manifest
from rna_sdk.package.manifest.manifest_short import has_short_form, in_short

_ORDER = (
    *("format", "version", "minReaderVersion", "generator", "name", "kind", "parts", "bounds"),
    *("domain", "units", "geometry", "tiers", "entries", "provenance", "license"),
    *("extensionsUsed", "extensionsRequired", "extensions", "extras"),
)
_TIER_ORDER = (
    *("name", "parts", "planes", "decoder", "inputs", "resolution", "channels"),
    *("planePrecision", "decoderPrecision", "validation", "cost", "agreement"),
)


def is_written_short(manifest: Manifest) -> bool:
    """Whether `manifest_to_json` writes the short form: every 1.0 reader can read it."""
    old = version_number(manifest.min_reader_version) < FIRST_WITH_PARTS
    return old and has_short_form(manifest)


def manifest_to_json(manifest: Manifest) -> bytes:
    """manifest.json: UTF-8, two spaces of indentation, fields in a fixed order."""
    record = in_short(manifest) if is_written_short(manifest) else manifest
    fields = _sorted(record.model_dump(mode="json", by_alias=True), _ORDER)
    fields["tiers"] = [_sorted(tier, _TIER_ORDER) for tier in fields["tiers"]]
    return (json.dumps(fields, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()


def with_versions(manifest: Manifest, needs: str = "1.0") -> Manifest:
    """The manifest with the versions that it needs, not lowered.

    needs: version of the format that the data needs.
    """
    own = "1.0" if has_short_form(manifest) else "1.1"

    oldest = max(manifest.min_reader_version, own, needs, key=version_number)
    version = max(manifest.version, oldest, key=version_number)
    return manifest.model_copy(update={"version": version, "min_reader_version": oldest})


def _sorted(fields: dict[str, Any], order: tuple[str, ...]) -> dict[str, Any]:
    return {name: fields[name] for name in sorted(fields, key=order.index)}

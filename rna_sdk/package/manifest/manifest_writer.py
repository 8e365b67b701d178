"""The text of manifest.json."""

from __future__ import annotations

import json

from rna_sdk.package.manifest.manifest_model import Manifest


def manifest_to_json(manifest: Manifest) -> bytes:
    """manifest.json: UTF-8, two spaces of indentation, members in the order of the model."""
    fields = manifest.model_dump(mode="json", by_alias=True)
    return (json.dumps(fields, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()

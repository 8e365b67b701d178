"""A package in a form that no exporter writes, and every reader must take."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

from rna_sdk.package.container.zip_container import MANIFEST_NAME
from tests.package.builders import pack, read_entries

EXTENSION = "ACME_wetness"


def make_odd(path: Path) -> None:
    """Rewrite the package in place.

    Its manifest is one line with escapes, has no member that may be missing, in reverse order, and
    has `extras` and an extension with an entry; planes have `__metadata__`; entries but the
    manifest are in reverse order.
    """
    entries = read_entries(path)
    manifest = json.loads(entries.pop(MANIFEST_NAME))
    for name in entries:
        if name.startswith("features/"):
            entries[name] = _with_metadata(entries[name])
    entries[f"extensions/{EXTENSION}/drops.bin"] = b"\0drops"
    manifest = _plain(manifest) | {
        "extensionsUsed": [EXTENSION],
        "extensions": {EXTENSION: {"amount": 1e-3}},
        "extras": {"n\u00e4ch\u00adstes": [None, True, -0.0, {"deep": [[[]]]}, "\U0001f9f6\u0000"]},
        "entries": {
            name: {"sha256": hashlib.sha256(data).hexdigest(), "size": len(data)}
            for name, data in entries.items()
        },
    }
    text = json.dumps(dict(reversed(manifest.items()))).encode()
    path.write_bytes(pack([(MANIFEST_NAME, text), *reversed(entries.items())]))


def _plain(value: Any) -> Any:
    """Without members that are null, or empty lists and objects of the manifest itself."""
    if isinstance(value, dict):
        members = {k: _plain(v) for k, v in value.items() if v is not None}
        return {k: v for k, v in members.items() if v not in ([], {})}
    return [_plain(v) for v in value] if isinstance(value, list) else value


def _with_metadata(data: bytes) -> bytes:
    """The tensor file with metadata in front of its tensors, and a header padded anew."""
    size = int.from_bytes(data[:8], "little")
    header = {"__metadata__": {"by": "hand"}, **json.loads(data[8 : 8 + size])}
    text = json.dumps(header).encode()
    text += b" " * (-(8 + len(text)) % 64)
    return len(text).to_bytes(8, "little") + text + data[8 + size :]

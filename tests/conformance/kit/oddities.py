"""A package in a form that no exporter writes, and every reader must take."""

import hashlib
import json
from pathlib import Path
from typing import Any

from rna_sdk.package.container.zip_container import MANIFEST_NAME
from tests.package.builders import pack, read_entries

EXTENSION = "ACME_wetness"


def make_odd(path: Path) -> None:
    """Rewrite the package in place.

    Its mesh has one buffer view, with offsets in accessors. Its manifest is one line with escapes,
    has no member that may be missing, in reverse order, and has `extras` and an extension with an
    entry; planes have `__metadata__`; entries but the manifest are in reverse order.
    """
    entries = read_entries(path)
    manifest = json.loads(entries.pop(MANIFEST_NAME))
    for name in entries:
        if name.startswith("features/"):
            entries[name] = _with_metadata(entries[name])
        elif name.endswith(".glb"):
            entries[name] = _with_one_view(entries[name])
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


def _with_one_view(glb: bytes) -> bytes:
    """The mesh with one view of the whole buffer, and offsets in accessors, the first left out."""
    size = int.from_bytes(glb[12:16], "little")
    document, rest = json.loads(glb[20 : 20 + size]), glb[20 + size :]
    for accessor in document["accessors"]:
        view = document["bufferViews"][accessor["bufferView"]]
        start = view.get("byteOffset", 0) + accessor.pop("byteOffset", 0)
        accessor |= {"bufferView": 0} | ({"byteOffset": start} if start else {})
    document["bufferViews"] = [{"buffer": 0, "byteLength": document["buffers"][0]["byteLength"]}]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    head = glb[:8] + (20 + len(text) + len(rest)).to_bytes(4, "little")
    return head + len(text).to_bytes(4, "little") + glb[16:20] + text + rest


def _with_metadata(data: bytes) -> bytes:
    """The tensor file with metadata in front of its tensors, and a header padded anew."""
    size = int.from_bytes(data[:8], "little")
    header = {"__metadata__": {"by": "hand"}, **json.loads(data[8 : 8 + size])}
    text = json.dumps(header).encode()
    text += b" " * (-(8 + len(text)) % 64)
    return len(text).to_bytes(8, "little") + text + data[8 + size :]

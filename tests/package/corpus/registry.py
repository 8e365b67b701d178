"""Where the cases are listed, and what they have in common."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from rna_sdk.package.container import MANIFEST_NAME
from rna_sdk.package.manifest import Kind
from tests.package.builders import pack

Entries = dict[str, bytes]
Breaker = Callable[[Entries], bytes]

MESH = "geometry/mesh.glb"
CURVES = "geometry/curves.safetensors"
PLANES = "features/small.safetensors"
DECODER = "decoders/small.onnx"


@dataclass(frozen=True)
class Case:
    """`breaker` makes the bytes of a bad file from the entries of a good package of this kind."""

    name: str
    code: str
    breaker: Breaker
    kind: Kind


CASES: list[Case] = []


def case(code: str, kind: Kind = "surface") -> Callable[[Breaker], Breaker]:
    """Register the function as a case in which `code` is the only issue."""

    def register(breaker: Breaker) -> Breaker:
        CASES.append(Case(breaker.__name__, code, breaker, kind))
        return breaker

    return register


def with_manifest(entries: Entries, edit: Callable[[dict[str, Any]], object]) -> bytes:
    """The package with an edited manifest, everything else as it is."""
    manifest = json.loads(entries[MANIFEST_NAME])
    edit(manifest)
    return pack({**entries, MANIFEST_NAME: json.dumps(manifest).encode()}.items())


def with_entry(
    entries: Entries, name: str, data: bytes, edit: Callable[[dict[str, Any]], object] | None = None
) -> bytes:
    """The package with other data for one entry, size and hash declared to fit."""

    def declare(manifest: dict[str, Any]) -> None:
        digest = hashlib.sha256(data).hexdigest()
        manifest["entries"][name] = {"size": len(data), "sha256": digest}
        if edit is not None:
            edit(manifest)

    return with_manifest({**entries, name: data}, declare)

"""Where the cases are listed, and what they have in common."""

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from rna_sdk.package.container.zip_container import MANIFEST_NAME
from tests.package.builders import make_tiny_fiber_package, make_tiny_package, pack, read_entries
from tests.package.lantern import make_lantern
from tests.package.prints import make_print
from tests.package.relief import make_relief

Entries = dict[str, bytes]
Breaker = Callable[[Entries], bytes]
Base = Literal["surface", "fiber", "parts", "relief", "print"]
"""Good packages: of one part, of two parts with light and holes, with maps or base colour."""

MESH = "geometry/mesh.glb"
CURVES = "geometry/curves.safetensors"
PLANES = "features/small.safetensors"
DECODER = "decoders/small.onnx"


@dataclass(frozen=True)
class Case:
    """`breaker` makes the bytes of a bad file from the entries of the good package `base`."""

    name: str
    code: str
    breaker: Breaker
    base: Base


class Corpus(list[Case]):
    """The cases of a module, most of which break the same good package."""

    def __init__(self, base: Base):
        self.base: Base = base

    def case(self, code: str, base: Base | None = None) -> Callable[[Breaker], Breaker]:
        """Register the function as a case in which `code` is the only issue."""

        def register(breaker: Breaker) -> Breaker:
            self.add(code, base, **{breaker.__name__: breaker})
            return breaker

        return register

    def add(self, code: str, base: Base | None = None, **breakers: Breaker) -> None:
        """Register cases by name, in each of which `code` is the only issue."""
        self.extend(
            Case(name, code, breaker, base or self.base) for name, breaker in breakers.items()
        )


def good_entries(folder: Path) -> dict[Base, Entries]:
    """The entries of the good packages; `folder` is for files on the way."""
    return {
        "surface": read_entries(make_tiny_package(folder / "tiny.rna")),
        "fiber": read_entries(make_tiny_fiber_package(folder / "tuft.rna")),
        "parts": read_entries(make_lantern(folder / "lantern.rna")),
        "relief": read_entries(make_relief(folder / "relief.rna")),
        "print": read_entries(make_print(folder / "print.rna")),
    }


def with_manifest(entries: Entries, edit: Callable[[dict[str, Any]], object]) -> bytes:
    """The package with an edited manifest, everything else as it is."""
    manifest = json.loads(entries[MANIFEST_NAME])
    edit(manifest)
    return pack({**entries, MANIFEST_NAME: json.dumps(manifest).encode()}.items())


def without(
    entries: Entries, *names: str, edit: Callable[[dict[str, Any]], object] = lambda m: None
) -> bytes:
    """The package without these entries, neither in the file nor in the manifest."""
    remaining = {name: data for name, data in entries.items() if name not in names}

    def drop(manifest: dict[str, Any]) -> None:
        edit(manifest)
        for name in names:
            manifest["entries"].pop(name)

    return with_manifest(remaining, drop)


def breaks_by(change: Callable[[Entries, Any], bytes]) -> Callable[[Callable[..., Any]], Breaker]:
    """From a change by an edit to a function that makes a breaker of an edit."""
    return lambda edit: lambda entries: change(entries, edit)


in_manifest = breaks_by(with_manifest)


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


def part(manifest: dict[str, Any]) -> dict[str, Any]:
    """The record of the first part."""
    first: dict[str, Any] = manifest["parts"][0]
    return first


def tier_part(manifest: dict[str, Any]) -> dict[str, Any]:
    """The record of the first part in the first tier."""
    first: dict[str, Any] = manifest["tiers"][0]["parts"][0]
    return first

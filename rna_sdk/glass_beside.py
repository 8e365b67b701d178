"""The smooth glass of an asset: no part of its package, an ordinary glTF mesh beside it."""

from __future__ import annotations

from pathlib import Path


def glass_of(package: Path) -> Path:
    """Where the glass of a package is, if it has any: `bottle.glass.glb` beside `bottle.rna`."""
    return package.with_name(f"{package.stem}.glass.glb")

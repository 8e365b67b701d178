"""Packages of one part, which can be evaluated as they are."""

from pathlib import Path

from rna_sdk.errors import QueryError
from rna_sdk.runtime import FiberAsset, SurfaceAsset, load

OnePart = SurfaceAsset | FiberAsset


def load_one_part(path: Path, tier: str | None = None, threads: int | None = None) -> OnePart:
    """Loads a package of one part, as `rna_sdk.runtime.load`; QueryError for several parts."""
    parts = load(path, tier, threads).parts
    if len(parts) > 1:
        raise QueryError(f"{path}: found {len(parts)} parts, expected one")
    return parts[0]

"""A small good package of one part with normal maps."""

from pathlib import Path
from typing import Any

import numpy as np

from rna_sdk.package import Manifest, NormalMapRecord, write_package
from rna_sdk.package.textures.texture_form import Texture
from tests.package.builders import make_manifest, make_mesh, make_part, make_tier, make_tier_data

BARK, DENT = "normals/bark.safetensors", "normals/dent.safetensors"


def make_maps() -> dict[str, Texture]:
    """A map of 3 rows of 4 texels, and one of one."""
    bark = np.random.default_rng(7).integers(0, 256, (3, 4, 2)).astype(np.uint8)
    return {BARK: bark, DENT: np.uint8([[[40, 160]]])}


def make_relief_manifest(**changes: Any) -> Manifest:
    """In two tiers that share their planes; `changes` are fields of the manifest."""
    records = (
        NormalMapRecord(triangles=(0, 2), texture=BARK),
        NormalMapRecord(triangles=(3, 1), texture=DENT),
    )
    size = {"planes": "features/p.safetensors", "resolution": 3, "channels": 2}
    tiers = [make_tier(name, **size) for name in ("small", "hq")]
    return make_manifest(
        *tiers, **{"name": "relief", "parts": (make_part(normal_maps=records),), **changes}
    )


def make_relief(path: str | Path, **changes: Any) -> Path:
    """Write the package to `path`; `changes` are fields of the manifest."""
    manifest = make_relief_manifest(**changes)
    data = {tier.name: make_tier_data(tier) for tier in manifest.tiers}
    write_package(path, manifest, [make_mesh()], data, make_maps())
    return Path(path)

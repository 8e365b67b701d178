"""Evaluate the neural assets of `.rna` packages in batches.

>>> asset = load("toy.rna")
>>> visible, shadowed = asset.evaluate(positions, normals, wo, wi)

and of fibers

>>> hair = load("hair.rna")
>>> h = offset_across(normals, tangents, wo)
>>> visible, shadowed = hair.evaluate(positions, tangents, h, wo, wi)
"""

from rna_sdk.errors import PackageError, QueryError
from rna_sdk.runtime.asset import Asset, FiberAsset, SurfaceAsset, load
from rna_sdk.runtime.domain import in_region
from rna_sdk.runtime.offset_across import offset_across
from rna_sdk.runtime.tiers import choose_tier, expected_error, is_no_worse
from rna_sdk.runtime.transforms import Transform

__all__ = [
    "Asset",
    "FiberAsset",
    "PackageError",
    "QueryError",
    "SurfaceAsset",
    "Transform",
    "choose_tier",
    "expected_error",
    "in_region",
    "is_no_worse",
    "load",
    "offset_across",
]

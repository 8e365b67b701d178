"""Evaluate the neural assets of `.rna` packages in batches.

Examples:
    A surface:

    >>> asset = load("toy.rna")
    >>> visible, shadowed = asset.evaluate(positions, normals, wo, wi)

    Fibers:

    >>> hair = load("hair.rna")
    >>> h = offset_across(normals, tangents, wo)
    >>> visible, shadowed = hair.evaluate(positions, tangents, h, wo, wi)

An asset of several parts is evaluated part by part: `for part in asset.parts: part.evaluate(...)`.
An asset of one part is its own only part.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rna_sdk.lazy_face import lazy_face

if TYPE_CHECKING:
    from rna_sdk.errors import PackageError, QueryError
    from rna_sdk.runtime.asset import Asset, CompositeAsset
    from rna_sdk.runtime.deformation import DeformedCurves, DeformedMesh, RestPoints
    from rna_sdk.runtime.domain import in_region
    from rna_sdk.runtime.fiber_asset import FiberAsset
    from rna_sdk.runtime.fiber_offset import offset_across
    from rna_sdk.runtime.loading import load
    from rna_sdk.runtime.normal_maps import mapped_normals
    from rna_sdk.runtime.surface_asset import SurfaceAsset
    from rna_sdk.runtime.tiers import choose_tier, expected_error, is_no_worse
    from rna_sdk.runtime.transforms import Transform
    from rna_sdk.runtime.transmittance_lookup import transmittance

__all__ = [
    "Asset",
    "CompositeAsset",
    "DeformedCurves",
    "DeformedMesh",
    "FiberAsset",
    "PackageError",
    "QueryError",
    "RestPoints",
    "SurfaceAsset",
    "Transform",
    "choose_tier",
    "expected_error",
    "in_region",
    "is_no_worse",
    "load",
    "mapped_normals",
    "offset_across",
    "transmittance",
]

__getattr__, __dir__ = lazy_face(__name__)

"""Evaluate the neural assets of `.rna` packages in batches.

>>> asset = load("toy.rna")
>>> visible, shadowed = asset.evaluate(positions, normals, wo, wi)
"""

from rna_sdk.errors import PackageError, QueryError
from rna_sdk.runtime.asset import Asset, load
from rna_sdk.runtime.transforms import Transform

__all__ = ["Asset", "PackageError", "QueryError", "Transform", "load"]

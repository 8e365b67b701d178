"""Read, write and validate `.rna` packages (format: spec/RNA.md).

>>> with Package.open("toy.rna") as package:
...     planes = package.planes("small")
"""

from rna_sdk.errors import PackageError
from rna_sdk.package.blocks import INPUT_BLOCKS, query_width
from rna_sdk.package.curves import Curves
from rna_sdk.package.geometry import quantise
from rna_sdk.package.issues import Code, Issue, Severity
from rna_sdk.package.manifest import (
    Agreement,
    Bounds,
    Cone,
    Cost,
    Domain,
    FlipAtHeight,
    Manifest,
    Provenance,
    Tier,
    Validation,
)
from rna_sdk.package.mesh import Mesh
from rna_sdk.package.package import Package
from rna_sdk.package.planes import Int8Planes, Planes
from rna_sdk.package.validator import validate
from rna_sdk.package.writer import TierData, write_package

__all__ = [
    "INPUT_BLOCKS",
    "Agreement",
    "Bounds",
    "Code",
    "Cone",
    "Cost",
    "Curves",
    "Domain",
    "FlipAtHeight",
    "Int8Planes",
    "Issue",
    "Manifest",
    "Mesh",
    "Package",
    "PackageError",
    "Planes",
    "Provenance",
    "Severity",
    "Tier",
    "TierData",
    "Validation",
    "quantise",
    "query_width",
    "validate",
    "write_package",
]

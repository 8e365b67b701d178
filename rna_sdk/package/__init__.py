"""Read, write and validate `.rna` packages (format: spec/RNA.md).

Examples:
    >>> with Package.open("toy.rna") as package:
    ...     planes = package.planes("small")
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rna_sdk.lazy_face import lazy_face

if TYPE_CHECKING:
    from rna_sdk.errors import PackageError
    from rna_sdk.package.blocks import INPUT_BLOCKS, query_width
    from rna_sdk.package.decoder.decoder_reader import decoder_from_bytes
    from rna_sdk.package.decoder.decoder_writer import decoder_to_bytes
    from rna_sdk.package.decoder.profile_decoder import ProfileDecoder, ProfileLayer
    from rna_sdk.package.geometry.curves import Curves
    from rna_sdk.package.geometry.geometry_files import quantise
    from rna_sdk.package.geometry.mesh import Mesh
    from rna_sdk.package.geometry.source_vertices import SourceVertices
    from rna_sdk.package.geometry.vertex_visibility import quantised_harmonics
    from rna_sdk.package.issues import Code, Issue, Severity
    from rna_sdk.package.manifest.extensions import EnvironmentPart, EnvironmentValidation
    from rna_sdk.package.manifest.manifest_fields import Bounds, Cone, Domain
    from rna_sdk.package.manifest.manifest_model import (
        Manifest,
        NormalMapRecord,
        Part,
        Provenance,
        TransmittanceRecord,
    )
    from rna_sdk.package.manifest.manifest_tiers import (
        Agreement,
        Cost,
        FlipAtHeight,
        Tier,
        TierEmission,
        TierPart,
        Validation,
    )
    from rna_sdk.package.manifest.tier_ranges import tier_ranges
    from rna_sdk.package.package import EnvironmentLobes, Package
    from rna_sdk.package.packing import Lobes, Unpacked
    from rna_sdk.package.textures.normal_maps import NormalMap
    from rna_sdk.package.textures.planes import Int8Planes, Planes, float_planes
    from rna_sdk.package.textures.transmittance import Transmittance
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
    "EnvironmentLobes",
    "EnvironmentPart",
    "EnvironmentValidation",
    "FlipAtHeight",
    "Int8Planes",
    "Issue",
    "Lobes",
    "Manifest",
    "Mesh",
    "NormalMap",
    "NormalMapRecord",
    "Package",
    "PackageError",
    "Part",
    "Planes",
    "ProfileDecoder",
    "ProfileLayer",
    "Provenance",
    "Severity",
    "SourceVertices",
    "Tier",
    "TierData",
    "TierEmission",
    "TierPart",
    "Transmittance",
    "TransmittanceRecord",
    "Unpacked",
    "Validation",
    "decoder_from_bytes",
    "decoder_to_bytes",
    "float_planes",
    "quantise",
    "quantised_harmonics",
    "query_width",
    "tier_ranges",
    "validate",
    "write_package",
]

__getattr__, __dir__ = lazy_face(__name__)

"""Rays against the geometry of assets and meshes: what other packages than the renderer use."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rna_sdk.lazy_face import lazy_face

if TYPE_CHECKING:
    from rna_trace.asset_parts import (
        mesh_transmittance,
        part_geometry,
        part_normal_maps,
        part_transmittance,
    )
    from rna_trace.bilinear import REPEAT
    from rna_trace.embree.instances import CAMERA_RAY, INDIRECT_RAY, SHADOW_RAY
    from rna_trace.embree.scenes import TriangleScene
    from rna_trace.embree.tracing import ClosestHits
    from rna_trace.fiber import FiberPoints, tangents
    from rna_trace.normal_maps import NormalMaps, texture_numbers
    from rna_trace.parts_scene import PartPoints, PartsScene
    from rna_trace.surface import OFFSET, SurfacePoints, geometric_normals
    from rna_trace.transmittance import TransmittanceTexture

__all__ = [
    "CAMERA_RAY",
    "INDIRECT_RAY",
    "OFFSET",
    "REPEAT",
    "SHADOW_RAY",
    "ClosestHits",
    "FiberPoints",
    "NormalMaps",
    "PartPoints",
    "PartsScene",
    "SurfacePoints",
    "TransmittanceTexture",
    "TriangleScene",
    "geometric_normals",
    "mesh_transmittance",
    "part_geometry",
    "part_normal_maps",
    "part_transmittance",
    "tangents",
    "texture_numbers",
]

__getattr__, __dir__ = lazy_face(__name__)

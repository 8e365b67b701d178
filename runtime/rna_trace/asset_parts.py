"""An asset and its parts, as rays need them, at rest and in motion."""

from collections.abc import Sequence

import numpy as np

from rna_sdk import package
from rna_sdk.package import Curves, Mesh
from rna_sdk.runtime import Asset, DeformedCurves, DeformedMesh, FiberAsset, SurfaceAsset
from rna_trace.normal_maps import NormalMaps, texture_numbers
from rna_trace.transmittance import Transmittance, TransmittanceTexture

Shape = DeformedMesh | DeformedCurves
"""The geometry of a part in motion: the result of its `deformed`."""


AssetPart = SurfaceAsset | FiberAsset


def part_geometry(part: AssetPart, shape: Shape | None = None) -> Mesh | Curves:
    """Geometry of a part for ray tracing. shape: of the part in motion; None for rest."""
    if part.kind == "fiber":
        return shape.curves if isinstance(shape, DeformedCurves) else part.curves
    return part_mesh(part, shape)


def part_mesh(part: SurfaceAsset, shape: Shape | None = None) -> Mesh:
    """The mesh of a part that has one. shape: as for `part_geometry`."""
    return shape.mesh if isinstance(shape, DeformedMesh) else part.mesh


def shaped_parts(
    asset: Asset, shapes: Sequence[Shape] | None
) -> list[tuple[AssetPart, Shape | None]]:
    """Each part, with its shape where the asset is in motion. shapes: None at rest."""
    given: Sequence[Shape | None] = shapes or [None] * len(asset.parts)
    return list(zip(asset.parts, given, strict=True))


def part_transmittance(part: AssetPart, shape: Shape | None = None) -> Transmittance | None:
    """Transmittance of a part; None if it is opaque. shape: as for `part_geometry`."""
    if part.kind == "fiber":
        return None
    return mesh_transmittance(part_mesh(part, shape), part.transmittance_records)


def part_normal_maps(part: AssetPart) -> NormalMaps | None:
    """The relief of a part at rest; None where it has none."""
    if part.kind == "fiber" or not part.normal_maps:
        return None
    return NormalMaps(part.mesh, part.normal_maps)


def mesh_transmittance(
    mesh: Mesh | Curves, records: Sequence[package.Transmittance]
) -> Transmittance | None:
    """Transmittance of a mesh with the given records; None if there are none, as of strands."""
    if not records or isinstance(mesh, Curves):
        return None
    number = texture_numbers(mesh, records)
    uvs = np.zeros((len(mesh.positions), 2), np.float32) if mesh.uvs is None else mesh.uvs
    textures = [TransmittanceTexture(r.texture, r.cutoff, ior=r.ior) for r in records]
    return Transmittance(mesh.triangles, uvs, mesh.normals, number, textures)

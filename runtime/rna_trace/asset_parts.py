"""What the renderer needs of an asset and of its parts; rna_sdk.runtime's classes have it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, Protocol

import numpy as np

from rna_sdk.package import Curves, Mesh
from rna_sdk.runtime import DeformedCurves, DeformedMesh
from rna_trace.normal_maps import NormalMaps, TextureRecord, texture_numbers
from rna_trace.transmittance import Transmittance, TransmittanceTexture

Shape = DeformedMesh | DeformedCurves
"""The geometry of a part in motion: what its `deformed` gives."""


class TransmittanceRecord(TextureRecord, Protocol):
    """Holes or thin glass; spec/RNA.md, 4.4. texture: (h, w, 1) or (h, w, 3) uint8."""

    @property
    def cutoff(self) -> float | None: ...

    @property
    def ior(self) -> tuple[float, float] | None: ...


class LobedPart(Protocol):
    """What any part knows of its lobes; its `lobes` is asked as its `evaluate` is."""

    @property
    def environment_form(self) -> object | None: ...

    def mirror(self, axes: np.ndarray, wo: np.ndarray) -> np.ndarray: ...

    def visibility_at(self, primitives: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray: ...


class SurfacePart(LobedPart, Protocol):
    """A part with a mesh: rna_sdk.runtime.SurfaceAsset."""

    @property
    def kind(self) -> Literal["surface"]: ...

    @property
    def mesh(self) -> Mesh: ...

    @property
    def emits(self) -> bool: ...

    @property
    def transmittance_records(self) -> Sequence[TransmittanceRecord]: ...

    @property
    def normal_maps(self) -> Sequence[TextureRecord]: ...

    def evaluate(
        self, positions: np.ndarray, normals: np.ndarray, wo: np.ndarray, wi: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]: ...

    def emission(
        self, positions: np.ndarray, normals: np.ndarray, wo: np.ndarray
    ) -> np.ndarray: ...

    def lobes(
        self,
        positions: np.ndarray,
        normals: np.ndarray,
        wo: np.ndarray,
        free: np.ndarray,
        visibility: np.ndarray,
    ) -> tuple[np.ndarray, np.ndarray]: ...

    def deformed(self, positions: np.ndarray) -> DeformedMesh: ...


class FiberPart(LobedPart, Protocol):
    """A part of strands: rna_sdk.runtime.FiberAsset."""

    @property
    def kind(self) -> Literal["fiber"]: ...

    @property
    def curves(self) -> Curves: ...

    @property
    def emits(self) -> bool: ...

    def evaluate(
        self,
        positions: np.ndarray,
        tangents: np.ndarray,
        h: np.ndarray,
        wo: np.ndarray,
        wi: np.ndarray,
    ) -> tuple[np.ndarray, np.ndarray]: ...

    def emission(
        self, positions: np.ndarray, tangents: np.ndarray, h: np.ndarray, wo: np.ndarray
    ) -> np.ndarray: ...

    def lobes(
        self,
        positions: np.ndarray,
        tangents: np.ndarray,
        h: np.ndarray,
        wo: np.ndarray,
        free: np.ndarray,
        visibility: np.ndarray,
    ) -> tuple[np.ndarray, np.ndarray]: ...

    def deformed(self, points: np.ndarray) -> DeformedCurves: ...


AssetPart = SurfacePart | FiberPart


class Asset(Protocol):
    """One part or several that light each other."""

    @property
    def parts(self) -> Sequence[AssetPart]: ...


def part_geometry(part: AssetPart, shape: Shape | None = None) -> Mesh | Curves:
    """Geometry of a part for ray tracing. shape: of the part in motion; None for rest."""
    if part.kind == "fiber":
        return shape.curves if isinstance(shape, DeformedCurves) else part.curves
    return part_mesh(part, shape)


def part_mesh(part: SurfacePart, shape: Shape | None = None) -> Mesh:
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


def mesh_transmittance(mesh: Mesh, records: Sequence[TransmittanceRecord]) -> Transmittance | None:
    """Transmittance of a mesh with the given records; None if there are none."""
    if not records:
        return None
    number = texture_numbers(mesh, records)
    uvs = np.zeros((len(mesh.positions), 2), np.float32) if mesh.uvs is None else mesh.uvs
    textures = [TransmittanceTexture(r.texture, r.cutoff, ior=r.ior) for r in records]
    return Transmittance(mesh.triangles, uvs, mesh.normals, number, textures)

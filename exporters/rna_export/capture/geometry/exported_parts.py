"""The exported scene as parts of an asset: geometry and transmittance."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from rna_export.capture.blender_process.blender_process import ScenePart
from rna_export.capture.blender_process.blender_worker import BlenderWorker, MaterialTextures
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.dataset.dataset_manifest import CapturedPart
from rna_export.capture.geometry.base_colors import BaseColors, Ranges
from rna_export.capture.geometry.blurred_textures import blurred_note
from rna_export.capture.geometry.glass_mesh import glass_glb
from rna_export.capture.geometry.mesh_cleanup import welded, with_last
from rna_export.capture.geometry.source_notes import doubled, size_notes, too_coarse
from rna_export.capture.preflight.material_record import Glass
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves, Mesh, SourceVertices, quantise
from rna_sdk.package.manifest.manifest_model import (
    BaseColorFields,
    BaseColorRecord,
    NormalMapRecord,
    TransmittanceRecord,
)
from rna_sdk.package.textures.normal_maps import NormalMap
from rna_sdk.package.textures.transmittance import Transmittance


@dataclass
class ExportedParts:
    """The parts of an opened source, by name, in order.

    geometries: the mesh or strands of each. exact: meshes before they were quantised. records:
    what lets light through, of each surface. maps: its normal maps. colors: its base colour.
    variants: by name, what is in the place of these records, of parts that have any. textures: of
    all, by name: the texels of the former two, and the files of images. sources: the source's
    vertices of each surface. notes: what of the materials is unknown. has_opaque_cutouts: whether
    some of it lets light through. has_learnt_relief: whether some relief is in no map. mapped,
    coloured: full names of the materials that have a normal map, and a base colour. obstacles: of
    "relief" and "colour", by material, why that is no texture. materials: of each surface, (t,)
    full names of its triangles' materials. glass: a .glb of what is left to hosts; None for
    nothing.
    """

    parts: tuple[ScenePart, ...]
    geometries: dict[str, Mesh | Curves] = field(default_factory=dict)
    exact: dict[str, Mesh] = field(default_factory=dict)
    records: dict[str, list[TransmittanceRecord]] = field(default_factory=dict)
    maps: dict[str, list[NormalMapRecord]] = field(default_factory=dict)
    colors: dict[str, list[BaseColorRecord]] = field(default_factory=dict)
    variants: dict[str, dict[str, tuple[BaseColorFields | None, ...]]] = field(default_factory=dict)
    textures: dict[str, np.ndarray | bytes] = field(default_factory=dict)
    sources: dict[str, SourceVertices] = field(default_factory=dict)
    has_opaque_cutouts: bool = False
    has_learnt_relief: bool = True
    mapped: tuple[str, ...] = ()
    coloured: tuple[str, ...] = ()
    obstacles: dict[str, dict[str, str]] = field(default_factory=dict)
    materials: dict[str, np.ndarray] = field(default_factory=dict)
    glass: bytes | None = None
    notes: list[str] = field(default_factory=list)

    def material_numbers(self, full_names: Sequence[str]) -> dict[str, np.ndarray]:
        """By surface, (t,) int16: places of its materials among these; -1 for other materials."""
        place = {name: k for k, name in enumerate(full_names)}
        return {
            part: np.array([place.get(str(name), -1) for name in names], np.int16)
            for part, names in self.materials.items()
        }

    def captured(self) -> tuple[CapturedPart, ...]:
        """The parts as records of the dataset's manifest."""
        return tuple(self._captured(part) for part in self.parts)

    def _captured(self, part: ScenePart) -> CapturedPart:
        low, high = self.geometries[part.name].box()
        return CapturedPart(
            name=part.name,
            kind=part.kind,
            bounds=(tuple(low.tolist()), tuple(high.tolist())),
            transmittance=tuple(self.records.get(part.name, ())),
            normal_maps=tuple(self.maps.get(part.name, ())),
            base_color=tuple(self.colors.get(part.name, ())),
            variants=tuple(of.get(part.name, ()) for of in self.variants.values()),
        )

    def transmittances(self) -> list[tuple[Transmittance, ...]]:
        """Transmittance records of each part, with their textures."""
        return [
            tuple(
                Transmittance(*r.triangles, self._texels(r), r.cutoff, r.ior)
                for r in self.records.get(part.name, ())
            )
            for part in self.parts
        ]

    def normal_maps(self) -> list[tuple[NormalMap, ...]]:
        """Normal maps of each part, with their textures."""
        return [
            tuple(NormalMap(*r.triangles, self._texels(r)) for r in self.maps.get(part.name, ()))
            for part in self.parts
        ]

    def _texels(self, record: TransmittanceRecord | NormalMapRecord) -> np.ndarray:
        texture = self.textures[record.texture]
        assert isinstance(texture, np.ndarray)  # only images are files
        return texture


def exported_parts(worker: BlenderWorker, settings: CaptureSettings) -> ExportedParts:
    """All parts of the source that the worker has opened."""
    textures = worker.export_textures(settings.normal_texels)
    colors = BaseColors.of(worker, textures.charts, settings.texture_size)
    exported = ExportedParts(
        worker.parts,
        has_opaque_cutouts=textures.captured_holes,
        has_learnt_relief=textures.learnt_relief,
        mapped=tuple(textures.normals),
        coloured=colors.materials,
        obstacles={"relief": textures.obstacles, "colour": colors.obstacles},
        variants={name: {} for name in colors.variants},
        notes=[*textures.notes],
    )
    for part in worker.parts:
        if part.kind == "fiber":
            exported.geometries[part.name] = worker.export_curves(part.owner)
        else:
            _add_surface(exported, worker, part, textures, colors, settings.texture_size)
    exported.notes += colors.notes
    _check_not_empty(exported, worker)
    if not settings.exact_geometry:
        _quantise(exported)
    exported.notes += size_notes(exported.geometries)
    if glass := [Glass(**each) for each in worker.opened["glass"]]:
        exported.glass = glass_glb(worker.export_corners(of_hosts=True), glass)
    return exported


def _check_not_empty(exported: ExportedParts, worker: BlenderWorker) -> None:
    """Leaves parts out whose triangles all had no area; CaptureError if none is left."""
    if not exported.geometries:
        raise CaptureError(
            f"{worker.source.path}: no triangles (only lines, points or triangles without area)"
        )
    for part in exported.parts:
        if part.name not in exported.geometries:
            note = f"part {part.name!r} has no triangle with an area and was left out"
            exported.notes.append(note)
    exported.parts = tuple(part for part in exported.parts if part.name in exported.geometries)


def _quantise(exported: ExportedParts) -> None:
    """Geometry in the package's steps, except surfaces whose details are too small for them."""
    for name, geometry in exported.geometries.items():
        if isinstance(geometry, Mesh):
            if note := too_coarse(name, geometry):
                exported.notes.append(note)
                continue
            exported.exact[name] = geometry
        exported.geometries[name] = quantise(geometry)


def _add_surface(
    exported: ExportedParts,
    worker: BlenderWorker,
    part: ScenePart,
    of: MaterialTextures,
    colors: BaseColors,
    largest: int,
) -> None:
    """Add a surface; largest: texels a side of baked images."""
    last = list(dict.fromkeys([*of.normals, *of.see_through, *colors.materials]))
    corners = with_last(worker.export_corners(part.owner, colors.charts), last)
    if not len(corners["material"]):
        return
    mesh, first = welded(corners)
    exported.geometries[part.name] = mesh
    exported.materials[part.name] = corners["material"]
    numbers = corners["vertex"][first].astype(np.uint32)
    exported.sources[part.name] = SourceVertices(numbers, int(corners["vertices"]))
    pieces: Ranges = {}
    for name in last:
        rows = np.flatnonzero(corners["material"] == name)
        if not len(rows):
            continue
        triangles = int(rows[0]), len(rows)
        for tile, at, count in zip(*_runs(corners["tile"][rows]), strict=True):
            pieces[name, int(tile)] = triangles[0] + int(at), int(count)
        if pane := of.see_through.get(name):
            texture = f"transmittance/{list(of.see_through).index(name)}.safetensors"
            exported.textures[texture] = pane.texture
            record = TransmittanceRecord(
                triangles=triangles, texture=texture, cutoff=pane.cutoff, ior=pane.ior
            )
            exported.records.setdefault(part.name, []).append(record)
        if name in of.normals:
            number = _first_equal(of.normals, name)
            texture = f"normals/{number}.safetensors"
            exported.textures[texture] = of.normals[name]
            mapped = NormalMapRecord(triangles=triangles, texture=texture)
            exported.maps.setdefault(part.name, []).append(mapped)
    _add_colors(exported, part, colors, colors.fitted(worker, largest, pieces))
    if note := doubled(part.name, mesh, corners["material"]):
        exported.notes.append(note)
    if note := blurred_note(part.name, corners, colors.others):
        exported.notes.append(note)


def _runs(sorted_: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The values of a sorted array, the place of each one's first, and how many."""
    return np.unique(sorted_, return_index=True, return_counts=True)


def _add_colors(
    exported: ExportedParts, part: ScenePart, colors: BaseColors, pieces: Ranges
) -> None:
    mesh = exported.geometries[part.name]
    assert isinstance(mesh, Mesh)  # the caller has made it
    records = colors.records(mesh, pieces)
    if not records:
        return
    exported.colors[part.name] = list(records.values())
    shown: list[BaseColorFields | None] = [*records.values()]
    for variant, parts in exported.variants.items():
        parts[part.name] = tuple(colors.changes(name, variant) for name, _ in records)
        shown += parts[part.name]
    images = {one.image for one in shown if one is not None and one.image is not None}
    exported.textures |= {name: colors.files[name] for name in images}


def _first_equal(textures: dict[str, np.ndarray], name: str) -> int:
    """Place of the first texture that is equal to this one: they are stored once."""
    return next(
        k for k, texture in enumerate(textures.values()) if np.array_equal(texture, textures[name])
    )

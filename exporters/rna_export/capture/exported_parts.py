"""What Blender shows, as parts of an asset: geometry, and what materials let through."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from rna_export.capture.manifest import CapturedPart
from rna_export.capture.weld import weld, with_last
from rna_export.capture.worker import BlenderWorker, ScenePart, SeeThrough
from rna_sdk.package import Curves, Mesh, quantise
from rna_sdk.package.manifest import TransmittanceRecord
from rna_sdk.package.transmittance import Transmittance


@dataclass
class ExportedParts:
    """The parts of an opened source, by name, in order.

    geometries: the mesh or strands of each. records: what lets light through, of each surface.
    textures: those of the records, by name. notes: of transparency that could not be told.
    """

    parts: tuple[ScenePart, ...]
    geometries: dict[str, Mesh | Curves] = field(default_factory=dict)
    records: dict[str, list[TransmittanceRecord]] = field(default_factory=dict)
    textures: dict[str, np.ndarray] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)

    def captured(self) -> tuple[CapturedPart, ...]:
        """As the dataset's manifest has them."""
        return tuple(self._captured(part) for part in self.parts)

    def _captured(self, part: ScenePart) -> CapturedPart:
        low, high = self.geometries[part.name].box()
        return CapturedPart(
            name=part.name,
            kind=part.kind,
            bounds=(tuple(low.tolist()), tuple(high.tolist())),
            transmittance=tuple(self.records.get(part.name, ())),
        )

    def transmittances(self) -> list[tuple[Transmittance, ...]]:
        """Of each part, with the textures."""
        return [
            tuple(
                Transmittance(*r.triangles, self.textures[r.texture], r.cutoff, r.ior)
                for r in self.records.get(part.name, ())
            )
            for part in self.parts
        ]


def exported_parts(worker: BlenderWorker, exact: bool) -> ExportedParts:
    """All parts of the source that the worker has opened; unless `exact`, quantised."""
    see_through, notes = worker.export_transparency()
    exported = ExportedParts(worker.parts, notes=notes)
    for part in worker.parts:
        if part.kind == "fiber":
            exported.geometries[part.name] = worker.export_curves(part.owner)
        else:
            _add_surface(exported, worker, part, see_through)
    if not exact:
        exported.geometries = {name: quantise(g) for name, g in exported.geometries.items()}
    return exported


def _add_surface(
    exported: ExportedParts,
    worker: BlenderWorker,
    part: ScenePart,
    see_through: dict[str, SeeThrough],
) -> None:
    corners = with_last(worker.export_corners(part.owner), list(see_through))
    exported.geometries[part.name] = weld(corners)
    for number, (name, found) in enumerate(see_through.items()):
        rows = np.flatnonzero(corners["material"] == name)
        if not len(rows):
            continue
        texture = f"transmittance/{number}.safetensors"
        exported.textures[texture] = found.texture
        record = TransmittanceRecord(
            triangles=(int(rows[0]), len(rows)),
            texture=texture,
            cutoff=found.cutoff,
            ior=found.ior,
        )
        exported.records.setdefault(part.name, []).append(record)

"""The surfaces of a scene, as wgsl/render/surfaces.wgsl has them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.geometry import Shape, Strands, Triangles
from rna_gpu.scene.scene_images import NONE, Images
from rna_render import MeshObject
from rna_render.materials import Material, main_texture, transmitted_by
from rna_trace import TransmittanceTexture, texture_numbers

SURFACE_SIZE = 9  # vec4f
_OF_MATERIAL, _OF_NEURAL, _OF_FIBERS = range(3)
_EMITS, _LETS_THROUGH, _IS_GLASS, _HAS_CUTOFF, _HAS_SCHLICK = 1, 2, 4, 8, 16
_TEXTURES = (
    "base_color_texture",
    "metallic_roughness_texture",
    "coat_weight_texture",
    "emission_texture",
    "clear_coat_texture",
    "clear_coat_roughness_texture",
    "transmission_texture",
    "normal_texture",
)
Record = NDArray[np.float32]


@dataclass
class Surfaces:
    """Surfaces as they are numbered: SURFACE_SIZE vec4f each.

    Attributes:
        records: of the surfaces. bodies: of each the number of its body.
        parts: of the surfaces of assets: (asset's place in World.things, number of the part), in
            the order of their numbers in the shaders.
        has_coat: whether any is more than Lambert's, so that the table of albedos is needed.
        transmits: whether any lets light through.
    """

    images: Images
    records: list[Record] = field(default_factory=list)
    bodies: list[int] = field(default_factory=list)
    parts: list[tuple[int, int]] = field(default_factory=list)
    has_coat: bool = False
    transmits: bool = False

    def add(self, thing: Any, place: int, body: int) -> list[Shape]:
        """The shapes of an asset or an object, and its surfaces.

        place: of an asset in World.things. body: the thing's number in the geometry.
        """
        first = len(self.records)
        shapes = [self._object(thing)] if isinstance(thing, MeshObject) else []
        if not isinstance(thing, MeshObject):
            shapes = [self._part(place, number, part) for number, part in enumerate(thing.parts)]
        self.bodies += [body] * (len(self.records) - first)
        return shapes

    def with_points(self, first_points: list[int]) -> Record:
        """All records, one behind the other; attributes of points begin at the bodies' first."""
        rows = np.array(self.records, np.float32)
        words = rows.view(np.uint32)
        first = np.array([first_points[body] for body in self.bodies], np.uint32)
        for column, width in ((2, 2), (3, 4)):
            places = words[:, 4, column]
            moved = places - np.uint32(width) * first  # modulo 2^32, as in the shader
            words[:, 4, column] = np.where(places == NONE, NONE, moved)
        return rows.reshape(-1, 4)

    def _object(self, mesh: MeshObject) -> Shape:
        catches = mesh.catches_shadows
        materials = mesh.materials[:1] if catches else mesh.materials
        places = [
            NONE if values is None else np.uint32(self.images.add(values.astype(np.float32)))
            for values in (mesh.second_uvs, mesh.tangents)
        ]
        numbers = np.array([self._material(material, catches, places) for material in materials])
        own = numbers[np.minimum(mesh.material_numbers, len(materials) - 1)]
        return Triangles(mesh.positions, mesh.normals, mesh.triangles, own, mesh.uvs)

    def _material(self, material: Material, catches: bool, places: list[np.uint32]) -> int:
        record = _surface(_OF_MATERIAL, 0)
        record[1] = *material.base_color, material.roughness
        coat = material.coat_f0, material.coat_weight
        record[2] = material.metallic, *coat, material.transmission
        record[3] = *material.emission, material.normal_scale
        record[4, :2] = material.clear_coat, material.clear_coat_roughness
        record[4, 2:] = np.array(places, np.uint32).view(np.float32)
        found = [getattr(material, name) for name in _TEXTURES]
        numbers = [NONE if t is None else np.uint32(self.images.add_texture(t)) for t in found]
        record[5:7] = np.array(numbers, np.uint32).view(np.float32).reshape(2, 4)
        if any(material.emission) and not catches:
            _set(record, _EMITS)
        if material.transmission > 0.0:
            _set(record, _IS_GLASS)
        through = None if catches else transmitted_by(material)
        if through is not None:
            self._let_through(record, through, main_texture(material))
        self.has_coat |= material.metallic > 0 or material.coat_f0 > 0 or material.clear_coat > 0
        return self._add(record)

    def _part(self, place: int, number: int, part: Any) -> Shape:
        self.parts.append((place, number))
        if part.kind == "fiber":
            record = _surface(_OF_FIBERS, len(self.parts) - 1)
            return Strands(part.curves, self._add(_emitting(record, part.emits)))
        mesh = part.mesh
        maps = texture_numbers(mesh, part.normal_maps)
        panes = texture_numbers(mesh, part.transmittance_records)
        pairs, own = np.unique(np.stack([maps, panes]), axis=1, return_inverse=True)
        numbers = np.array([self._part_surface(part, *pair) for pair in pairs.T.tolist()])
        arrays = mesh.positions, mesh.normals, mesh.triangles
        return Triangles(*arrays, numbers[own.reshape(-1)], mesh.uvs)

    def _part_surface(self, part: Any, normal_map: int, pane: int) -> int:
        """Number of the surface of triangles with that normal map and that pane; -1 for none."""
        record = _emitting(_surface(_OF_NEURAL, len(self.parts) - 1), part.emits)
        if normal_map >= 0:
            texture = self.images.add_texels(part.normal_maps[normal_map].texture)
            record[0, 3] = np.uint32(texture).view(np.float32)
        if pane >= 0:
            given = part.transmittance_records[pane]
            through = TransmittanceTexture(given.texture, given.cutoff, ior=given.ior)
            self._let_through(record, through, None)
        return self._add(record)

    def _let_through(self, record: Record, through: TransmittanceTexture, image: Any) -> None:
        """image: the texture that has the coordinates; None for the mesh's own."""
        form = through.wrap[0] | through.wrap[1] << 2 | (image.uv_set << 5 if image else 0)
        transform = [image.transform] if image is not None else []
        texture = self.images.add_texels(through.texels, form, *transform)
        record[7, 0] = np.uint32(texture).view(np.float32)
        _set(record, _LETS_THROUGH)
        if through.cutoff is not None:
            _set(record, _HAS_CUTOFF)
            record[7, 1] = through.cutoff
        record[7, 2:] = through.ior or (0.0, 0.0)
        if through.f0 is not None:
            _set(record, _HAS_SCHLICK)
            record[8, 0] = through.f0
        self.transmits = True

    def _add(self, record: Record) -> int:
        self.records.append(record)
        return len(self.records) - 1


def _surface(kind: int, part: int) -> Record:
    record = np.zeros((SURFACE_SIZE, 4), np.float32)
    record[0] = np.array([kind, part, 0, NONE], np.uint32).view(np.float32)
    record[4, 2:] = record[5:7] = NONE.view(np.float32)
    return record


def _set(record: Record, flag: int) -> None:
    record.view(np.uint32)[0, 2] |= flag


def _emitting(record: Record, emits: bool) -> Record:
    if emits:
        _set(record, _EMITS)
    return record

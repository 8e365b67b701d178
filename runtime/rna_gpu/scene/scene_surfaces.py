"""The surfaces of a scene, as rows of SURFACE."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.geometry import Shape, Strands, Triangles
from rna_gpu.records.tables import (
    BACK_ALONE,
    EMITS,
    FRONT_ALONE,
    HAS_CUTOFF,
    HAS_SCHLICK,
    IS_GLASS,
    IS_SOLID,
    LETS_THROUGH,
    MATERIAL_TEXTURES,
    OF_FIBERS,
    OF_MATERIAL,
    OF_NEURAL,
    SURFACE,
    lobe_fields,
)
from rna_gpu.scene.scene_images import NONE, Images
from rna_render import MeshObject
from rna_render.materials import Material, main_texture, transmitted_by
from rna_trace import TransmittanceTexture, texture_numbers

_FACTORS = (
    *("base_color", "roughness", "metallic", "coat_f0", "coat_weight", "transmission"),
    *("emission", "normal_scale", "clear_coat", "clear_coat_roughness"),
)
_BASE = list(MATERIAL_TEXTURES).index("BASE")
Row = NDArray[Any]
"""() of dtype SURFACE."""


@dataclass
class Surfaces:
    """Surfaces as they are numbered.

    Attributes:
        rows: of the surfaces. bodies: of each the number of its body.
        parts: of the surfaces of assets: (asset's place in World.objects, number of the part), in
            the order of their numbers in the shaders.
        has_coat: whether any is more than Lambert's, so that the table of albedos is needed.
        transmits: whether any lets light through.
    """

    images: Images
    rows: list[Row] = field(default_factory=list)
    bodies: list[int] = field(default_factory=list)
    parts: list[tuple[int, int]] = field(default_factory=list)
    has_coat: bool = False
    transmits: bool = False

    def add(
        self, scene_object: Any, place: int, body: int, sides: Sequence[int] = ()
    ) -> list[Shape]:
        """The shapes of an asset or an object, and its surfaces.

        place: of an asset in World.objects. body: the object's number in the geometry. sides: of
        the parts of an asset, as `PartsScene.sides`; none: all 0.
        """
        first = len(self.rows)
        shapes = [self._object(scene_object)] if isinstance(scene_object, MeshObject) else []
        if not isinstance(scene_object, MeshObject):
            parts = scene_object.parts
            every = zip(parts, sides or [0] * len(parts), strict=True)
            shapes = [self._part(place, number, *one) for number, one in enumerate(every)]
        self.bodies += [body] * (len(self.rows) - first)
        return shapes

    def with_points(self, first_points: list[int]) -> NDArray[np.float32]:
        """(n, 4): all rows; attributes of points begin at those of their bodies."""
        rows = SURFACE.stacked(self.rows)
        first = np.array([first_points[body] for body in self.bodies], np.uint32)
        for name, width in (("second_uvs", 2), ("tangents", 4), ("colors", 3)):
            places = rows[name]
            moved = places - np.uint32(width) * first  # modulo 2^32, as in the shader
            rows[name] = np.where(places == NONE, NONE, moved)
        return rows.view(np.float32).reshape(-1, 4)

    def _object(self, mesh: MeshObject) -> Shape:
        catches = mesh.catches_shadows
        materials = mesh.materials[:1] if catches else mesh.materials
        places = [
            NONE if values is None else np.uint32(self.images.add(values.astype(np.float32)))
            for values in (mesh.second_uvs, mesh.tangents, mesh.colors)
        ]
        numbers = np.array([self._material(material, catches, places) for material in materials])
        material_of_triangle = numbers[np.minimum(mesh.material_numbers, len(materials) - 1)]
        return Triangles(
            mesh.positions, mesh.normals, mesh.triangles, material_of_triangle, mesh.uvs
        )

    def _material(self, material: Material, catches: bool, places: list[np.uint32]) -> int:
        row = _surface(OF_MATERIAL, 0)
        for name in _FACTORS:
            row[name] = getattr(material, name)
        row["second_uvs"], row["tangents"], row["colors"] = places
        textures = [getattr(material, name) for name in MATERIAL_TEXTURES.values()]
        numbers = [NONE if t is None else self.images.add_texture(t) for t in textures]
        row["textures"] = np.array(numbers, np.uint32).reshape(-1, 4)
        if any(material.emission) and not catches:
            row["flags"] |= EMITS
        if material.transmission > 0.0:
            row["flags"] |= IS_GLASS
        if material.inside is not None and not catches:
            row["flags"] |= IS_SOLID
            row["ior"][0], row["absorption"] = material.inside.ior, material.inside.absorption
        through = None if catches or material.inside else transmitted_by(material)
        if through is not None:
            self._let_through(row, through, main_texture(material))
        self.has_coat |= material.metallic > 0 or material.coat_f0 > 0 or material.clear_coat > 0
        return self._add(row)

    def _part(self, place: int, number: int, part: Any, side: int) -> Shape:
        self.parts.append((place, number))
        if part.kind == "fiber":
            row = self._neural(OF_FIBERS, part, 0)
            return Strands(part.curves, self._add(row))
        mesh = part.mesh
        maps = texture_numbers(mesh, part.normal_maps)
        panes = texture_numbers(mesh, part.transmittance_records)
        colors = texture_numbers(mesh, part.base_colors)
        firsts = [mixture.first for mixture in part.sampling]
        mixtures = np.searchsorted(firsts, np.arange(len(mesh.triangles)), side="right") - 1
        numbers = np.stack([maps, panes, colors, mixtures])
        kinds, kind_of_triangle = np.unique(numbers, axis=1, return_inverse=True)
        surfaces = np.array([self._part_surface(part, side, *kind) for kind in kinds.T.tolist()])
        return Triangles(
            positions=mesh.positions,
            normals=mesh.normals,
            triangles=mesh.triangles,
            surface=surfaces[kind_of_triangle.reshape(-1)],
            uvs=mesh.uvs,
        )

    def _neural(self, kind: int, part: Any, mixture: int) -> Row:
        row = _surface(kind, len(self.parts) - 1, part.emits)
        for name, numbers in lobe_fields(part.sampling[mixture]).items():
            row[name] = numbers
        return row

    def _part_surface(
        self, part: Any, side: int, normal_map: int, pane: int, color: int, mixture: int
    ) -> int:
        """Number of the surface of triangles with these records of the part; -1 for none."""
        row = self._neural(OF_NEURAL, part, mixture)
        row["flags"] |= {1: FRONT_ALONE, -1: BACK_ALONE, 0: 0}[side]
        if normal_map >= 0:
            row["normal_map"] = self.images.add_texels(part.normal_maps[normal_map].texture)
        if pane >= 0:
            given = part.transmittance_records[pane]
            through = TransmittanceTexture(given.texture, given.cutoff, ior=given.ior)
            self._let_through(row, through, None)
        row["base_color"] = 1.0
        if color >= 0:
            record = part.base_colors[color]
            row["base_color"] = record.factor
            if record.image is not None:
                row["textures"].reshape(-1)[_BASE] = self.images.add_base_color(record)
        return self._add(row)

    def _let_through(self, row: Row, through: TransmittanceTexture, image: Any) -> None:
        """image: the texture that has the coordinates; None for the mesh's own."""
        form = through.wrap[0] | through.wrap[1] << 2 | (image.uv_set << 5 if image else 0)
        transform = [image.transform] if image is not None else []
        row["through"] = self.images.add_texels(through.texels, form, *transform)
        row["flags"] |= LETS_THROUGH
        if through.cutoff is not None:
            row["flags"] |= HAS_CUTOFF
            row["cutoff"] = through.cutoff
        row["ior"] = through.ior or (0.0, 0.0)
        if through.f0 is not None:
            row["flags"] |= HAS_SCHLICK
            row["f0"] = through.f0
        self.transmits = True

    def _add(self, row: Row) -> int:
        self.rows.append(row)
        return len(self.rows) - 1


def _surface(kind: int, part: int, emits: bool = False) -> Row:
    row = np.zeros((), SURFACE.dtype)
    row["kind"], row["part"], row["flags"] = kind, part, EMITS if emits else 0
    for name in ("normal_map", "second_uvs", "tangents", "colors", "textures"):
        row[name] = NONE
    return row

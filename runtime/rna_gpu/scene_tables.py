"""A scene as the tables of `wgsl/render/`: things, surfaces, lights, images."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.geometry import Geometry, Placed, Shape, Strands, Triangles, build_geometry
from rna_gpu.scene_support import check_material
from rna_render.embree.instances import ALL_RAYS, CAMERA_RAY
from rna_render.lights import AssetLight, EnvironmentImageLight, Light, LightSelection
from rna_render.lights.base import PlacedLight
from rna_render.lights.kinds import ROW_NUMBERS
from rna_render.materials import MeshObject
from rna_render.materials.ggx import albedo_table
from rna_render.materials.material import Material
from rna_render.materials.textures import SRGB, Texture
from rna_render.path_numbers import LIGHTS_AT_A_VERTEX
from rna_render.placements import Placement
from rna_render.surface import OFFSET
from rna_render.world import World

LIGHT_WORDS = 8  # vec4f: LIGHT_SIZE
SURFACE_SIZE = 4  # vec4f, as in wgsl/render/vertex.wgsl
_OF_MATERIAL, _OF_NEURAL, _OF_FIBERS = range(3)
_SEEN, _DELTA = 1, 2
_NONE = np.uint32(0xFFFFFFFF)


@dataclass
class SceneTables:
    """What the shaders read of a scene.

    Attributes:
        geometry: bodies and instances.
        table: (n, 4) float32, sections one behind the other, from `things`, `surfaces`, `lights`
            and `albedo` on.
        images: (m,) uint32, see Images.
        parts: of the surfaces of assets: (asset's place in World.things, number of the part), in
            the order of their numbers in the shaders.
    """

    geometry: Geometry
    table: NDArray[np.float32]
    images: NDArray[np.uint32]
    parts: list[tuple[int, int]]
    things: int = 0
    surfaces: int = 0
    lights: int = 0
    albedo: int = 0


@dataclass
class _Surfaces:
    """Surfaces as they are numbered: SURFACE_SIZE vec4f each."""

    images: Images
    records: list[NDArray[np.float32]] = field(default_factory=list)
    parts: list[tuple[int, int]] = field(default_factory=list)
    has_coat: bool = False

    def add_part(self, thing: int, number: int, part: Any) -> NDArray[np.int64] | int:
        """Number of the surface of a part; of a mesh those of its triangles, by normal map."""
        self.parts.append((thing, number))
        if part.kind == "fiber":
            return self._add(_surface(_OF_FIBERS, len(self.parts) - 1, part.emits))
        plain = self._add(_surface(_OF_NEURAL, len(self.parts) - 1, part.emits))
        numbers = np.full(len(part.mesh.triangles), plain)
        for mapped in part.normal_maps:
            record = _surface(_OF_NEURAL, len(self.parts) - 1, part.emits)
            record[3, :2] = self.images.add_texture(mapped.texture)
            numbers[mapped.first : mapped.first + mapped.count] = self._add(record)
        return numbers

    def add_material(self, material: Material) -> int:
        """Number of the surface of a material that the shaders know."""
        record = _surface(_OF_MATERIAL, 0)
        record[1] = *material.base_color, material.roughness
        textures = material.base_color_texture, material.metallic_roughness_texture
        srgb = sum(_is_srgb(texture) << k for k, texture in enumerate(textures))
        record[2] = material.metallic, material.coat_f0, material.coat_weight, srgb
        for k, texture in enumerate(textures):
            if texture is not None:
                record[3, 2 * k : 2 * k + 2] = self.images.add_texture(texture.texels)
        self.has_coat |= material.metallic > 0 or material.coat_f0 > 0
        return self._add(record)

    def _add(self, record: NDArray[np.float32]) -> int:
        self.records.append(record)
        return len(self.records) - 1


class Images:
    """Floats of skies and bytes of textures, one behind the other in uint32."""

    def __init__(self) -> None:
        self._arrays: list[NDArray[np.uint32]] = [np.zeros(4, np.uint32)]
        self._length = 4
        self._kept: dict[int, tuple[NDArray[np.float32], object]] = {}

    def add(self, values: NDArray[Any]) -> int:
        """Place of the values, 4 bytes each."""
        place = self._length
        self._arrays.append(np.ascontiguousarray(values).reshape(-1).view(np.uint32))
        self._length += len(self._arrays[-1])
        return place

    def add_texture(self, texels: NDArray[np.uint8]) -> NDArray[np.float32]:
        """Place and size, as bits, of (h, w, 2 or 3) texels; once for those added before."""
        if id(texels) not in self._kept:
            height, width, channels = texels.shape
            words = np.zeros((height, width, 4), np.uint8)
            words[..., :channels] = texels
            place = self.add(np.uint32([width]))
            self.add(words)
            record = np.array([place, height << 16 | width], np.uint32).view(np.float32)
            self._kept[id(texels)] = record, texels
        return self._kept[id(texels)][0]

    def whole(self) -> NDArray[np.uint32]:
        """All of them."""
        return np.concatenate(self._arrays)


def _is_srgb(texture: Texture | None) -> int:
    return int(texture is not None and texture.decode is SRGB)


def scene_tables(world: World, lights: Sequence[Light]) -> SceneTables:
    """The tables of a world.

    lights: all of the scene but those of assets. Raises GpuError for what the shaders do not
    know; see `scene_support`.
    """
    images = Images()
    surfaces = _Surfaces(images)
    bodies: list[list[Shape]] = []
    numbers: dict[int, int] = {}
    placed, kept = [], []
    for k, placement in enumerate(world.placements):
        if isinstance(placement.thing, PlacedLight):
            continue
        if id(placement.thing) not in numbers:
            numbers[id(placement.thing)] = len(bodies)
            bodies.append(_shapes(placement.thing, int(world.number[k]) - 1, surfaces))
        body = numbers[id(placement.thing)]
        placed.append(Placed(body, placement.world_from_object, _met_by(placement)))
        kept.append(k)
    geometry = build_geometry(bodies, placed)
    geometry.instances[:, 7, 3] = [_factor(world.placements[kept[i]]) for i in geometry.order]
    sections = [
        _things(world, [kept[i] for i in geometry.order], geometry, placed),
        np.concatenate(surfaces.records),
    ]
    light_rows = _lights(lights, world.radius, images)
    sections += [light_rows, _albedo() if surfaces.has_coat else np.zeros((1, 4), np.float32)]
    starts = np.cumsum([0, *(len(section) for section in sections)])[:-1]
    table = np.concatenate(sections).astype(np.float32)
    return SceneTables(geometry, table, images.whole(), surfaces.parts, *map(int, starts))


def _factor(placement: Placement) -> float:
    """On the light that the instance of an asset sends out."""
    return float(placement.light.factor) if isinstance(placement.light, AssetLight) else 0.0


def _met_by(placement: Placement) -> int:
    thing = placement.thing
    catches = isinstance(thing, MeshObject) and thing.catches_shadows
    return CAMERA_RAY if catches else ALL_RAYS


def _shapes(thing: Any, place: int, surfaces: _Surfaces) -> list[Shape]:
    """The shapes of an asset or an object, whose surfaces are added."""
    if isinstance(thing, MeshObject):
        materials = thing.materials if not thing.catches_shadows else thing.materials[:1]
        numbers = np.array([surfaces.add_material(check_material(m)) for m in materials])
        own = numbers[np.minimum(thing.material_numbers, len(materials) - 1)]
        return [Triangles(thing.positions, thing.normals, thing.triangles, own, thing.uvs)]
    shapes: list[Shape] = []
    for number, part in enumerate(thing.parts):
        own = surfaces.add_part(place, number, part)
        if isinstance(own, int):
            shapes.append(Strands(part.curves, own))
        else:
            mesh = part.mesh
            arrays = mesh.positions, mesh.normals, mesh.triangles
            shapes.append(Triangles(*arrays, own, mesh.uvs))
    return shapes


def _surface(kind: int, part: int, emits: bool = False) -> NDArray[np.float32]:
    record = np.zeros((SURFACE_SIZE, 4), np.float32)
    record[0, :3] = np.array([kind, part, emits], np.uint32).view(np.float32)
    return record


def _things(
    world: World, kept: Sequence[int], geometry: Geometry, placed: Sequence[Placed]
) -> NDArray[np.float32]:
    """A vec4f an instance: number, role, step off the surface, whether rays pass through."""
    rows = np.zeros((len(kept), 4), np.float32)
    for row, k, stored in zip(rows, kept, geometry.order, strict=True):
        thing = world.placements[k].thing
        is_object = isinstance(thing, MeshObject)
        matrix = world.placements[k].world_from_object
        size = world.scale[k] * np.sqrt(3.0) * geometry.extents[placed[stored].body]
        reach = np.abs(matrix[:3, 3]).max() + size
        step = OFFSET * reach if is_object else 0.0
        catches = is_object and thing.catches_shadows
        row[:] = world.number[k], float(catches), step, float(not is_object)
    return rows


def _lights(lights: Sequence[Light], radius: float, images: Images) -> NDArray[np.float32]:
    rows = np.zeros((max(len(lights), 1), LIGHT_WORDS, 4), np.float32)
    names = sorted({light.group for light in lights} - {""})
    probability = _probabilities(lights, radius)
    for k, (row, light) in enumerate(zip(rows, lights, strict=False)):
        group = np.uint32(names.index(light.group)) if light.group else _NONE
        flags = _SEEN * getattr(light, "visible_to_camera", False) + _DELTA * light.delta
        row[0, :3] = np.array([light.row.kind, group, flags], np.uint32).view(np.float32)
        row[1:6] = light.row.numbers[:ROW_NUMBERS].reshape(5, 4)
        row[6, :3] = probability[k]
        if isinstance(light, EnvironmentImageLight):
            texels, *sums = light.image.tables
            row.reshape(-1)[4 + 7 : 4 + 9] = texels.shape[:2]  # numbers 7 and 8
            places = [images.add(values.astype(np.float32)) for values in (texels, *sums)]
            row[7] = np.array(places, np.uint32).view(np.float32)
    return rows.reshape(-1, 4)


def _probabilities(lights: Sequence[Light], radius: float) -> NDArray[np.float64]:
    """(k, 3) samples that each light gets at a point of depth 1, 2 and later, on average."""
    chosen = LightSelection(lights, radius).probability
    if len(lights) > LIGHTS_AT_A_VERTEX:
        return np.repeat(chosen[:, None], 3, axis=1)
    times = [[light.samples, max(light.samples // 2, 1)] for light in lights]
    return np.column_stack([np.reshape(times, (-1, 2)), chosen])


def _albedo() -> NDArray[np.float32]:
    """albedo_table with its means behind each row, two entries a vec4f."""
    table, mean = albedo_table()
    whole = np.concatenate([table, mean[:, None]], axis=1).reshape(-1)
    return np.pad(whole, (0, -len(whole) % 4)).reshape(-1, 4).astype(np.float32)

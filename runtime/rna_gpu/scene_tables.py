"""A scene as the tables of `wgsl/render/`: things, surfaces, lights, images."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.geometry import Geometry, Placed, Shape, Strands, Triangles, build_geometry
from rna_gpu.scene_support import check_material
from rna_render.instances import ALL_RAYS, CAMERA_RAY
from rna_render.lights import EnvironmentImageLight, Light, LightSelection
from rna_render.lights.base import PlacedLight
from rna_render.lights.kinds import ROW_NUMBERS
from rna_render.materials import MeshObject
from rna_render.materials.ggx import albedo_table
from rna_render.path_numbers import LIGHTS_AT_A_VERTEX
from rna_render.surface import OFFSET
from rna_render.world import Placement, World

LIGHT_WORDS = 8  # vec4f: LIGHT_SIZE
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
        images: (m,) float32.
        parts: of the surfaces of assets: (asset's place in World.things, number of the part), in
            the order of their numbers in the shaders.
    """

    geometry: Geometry
    table: NDArray[np.float32]
    images: NDArray[np.float32]
    parts: list[tuple[int, int]]
    things: int = 0
    surfaces: int = 0
    lights: int = 0
    albedo: int = 0


@dataclass
class _Surfaces:
    """Surfaces as they are numbered: three vec4f each."""

    records: list[NDArray[np.float32]] = field(default_factory=list)
    parts: list[tuple[int, int]] = field(default_factory=list)
    has_coat: bool = False

    def add_part(self, thing: int, part: int, kind: str) -> int:
        code = _OF_NEURAL if kind == "surface" else _OF_FIBERS
        self.records.append(_surface(code, len(self.parts)))
        self.parts.append((thing, part))
        return len(self.records) - 1

    def add_material(self, material: Any) -> int:
        record = _surface(_OF_MATERIAL, 0)
        record[1] = *material.base_color, material.roughness**2
        record[2, :3] = material.metallic, material.coat_f0, material.coat_weight
        self.has_coat |= material.metallic > 0 or material.coat_f0 > 0
        self.records.append(record)
        return len(self.records) - 1


def scene_tables(world: World, lights: Sequence[Light]) -> SceneTables:
    """The tables of a world.

    lights: all of the scene, those of the world first. Raises GpuError for what the shaders do not
    know; see `scene_support`.
    """
    surfaces = _Surfaces()
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
    sections = [
        _things(world, [kept[i] for i in geometry.order], geometry, placed),
        np.concatenate(surfaces.records),
    ]
    light_rows, images = _lights(lights, world.radius)
    sections += [light_rows, _albedo() if surfaces.has_coat else np.zeros((1, 4), np.float32)]
    starts = np.cumsum([0, *(len(section) for section in sections)])[:-1]
    table = np.concatenate(sections).astype(np.float32)
    return SceneTables(geometry, table, images, surfaces.parts, *map(int, starts))


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
        return [Triangles(thing.positions, thing.normals, thing.triangles, own)]
    shapes: list[Shape] = []
    for number, part in enumerate(thing.parts):
        surface = surfaces.add_part(place, number, part.kind)
        if part.kind == "fiber":
            shapes.append(Strands(part.curves, surface))
        else:
            mesh = part.mesh
            own = np.full(len(mesh.triangles), surface)
            shapes.append(Triangles(mesh.positions, mesh.normals, mesh.triangles, own))
    return shapes


def _surface(kind: int, part: int) -> NDArray[np.float32]:
    record = np.zeros((3, 4), np.float32)
    record[0, :2] = np.array([kind, part], np.uint32).view(np.float32)
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


def _lights(
    lights: Sequence[Light], radius: float
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    rows = np.zeros((max(len(lights), 1), LIGHT_WORDS, 4), np.float32)
    names = sorted({light.group for light in lights} - {""})
    images: list[NDArray[np.float32]] = [np.zeros(4, np.float32)]
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
            places = []
            for values in (texels, *sums):
                places.append(sum(map(len, images)))
                images.append(values.reshape(-1).astype(np.float32))
            row[7] = np.array(places, np.uint32).view(np.float32)
    return rows.reshape(-1, 4), np.concatenate(images)


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

"""A scene as the tables of `wgsl/render/`: things, surfaces, textures, lights, domains, images."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from rna_gpu.geometry import Geometry, Placed, Shape, build_geometry
from rna_gpu.records.scene import ALL_DIRECTIONS, HEMISPHERE
from rna_gpu.records.tables import OBJECT
from rna_gpu.scene.scene_images import NONE, Images
from rna_gpu.scene.scene_lights import light_rows
from rna_gpu.scene.scene_surfaces import Surfaces
from rna_render import MeshObject, World
from rna_render.lights import Light, PlacedLight
from rna_render.materials import ALBEDO_MEANS, ALBEDO_TABLE
from rna_sdk.runtime import Asset

_ROUNDING = 1e-6  # as in rna_sdk.runtime.in_region


@dataclass
class SceneTables:
    """A scene as the shaders read it.

    Attributes:
        geometry: bodies and instances.
        table: (n, 4) float32, sections one behind the other.
        sections: where in `table` each begins, by its name in wgsl/render/frame.wgsl.
        images: (m,) uint32, see Images.
        parts: see Surfaces.
        transmits: whether something lets light through.
    """

    geometry: Geometry
    table: NDArray[np.float32]
    sections: dict[str, int]
    images: NDArray[np.uint32]
    parts: list[tuple[int, int]]
    transmits: bool


_BUILT: WeakKeyDictionary[World, Geometry] = WeakKeyDictionary()
"""The geometry of worlds of which several images are rendered."""


def scene_tables(world: World, lights: Sequence[Light]) -> SceneTables:
    """The tables of a world. lights: all of the scene, those of the world first."""
    surfaces = Surfaces(Images())
    bodies: list[list[Shape]] = []
    numbers: dict[int, int] = {}
    placed, visible = [], []
    for k, placement in enumerate(world.placements):
        if isinstance(placement.object, PlacedLight):
            continue
        if id(placement.object) not in numbers:
            numbers[id(placement.object)] = len(bodies)
            place = int(world.number[k]) - 1
            body, sides = len(bodies), world.sides(k)
            bodies.append(surfaces.add(placement.object, place, body, sides))
        body = numbers[id(placement.object)]
        placed.append(Placed(body, placement.world_from_object, world.met_by[k]))
        visible.append(k)
    geometry = _BUILT.get(world) or build_geometry(bodies, placed)
    _BUILT[world] = geometry
    ordered = [visible[i] for i in geometry.order]
    shining = np.where(world.light[ordered] < 0, NONE, world.light[ordered]).astype(np.uint32)
    geometry.instances["host_data"] = shining
    stored = {k: at for at, k in enumerate(ordered)}
    images = surfaces.images
    rows = {
        "objects": _scene_objects(world, list(stored)),
        "surfaces": surfaces.with_points(geometry.first_points),
        "lights": light_rows(lights, world, images, geometry, stored, numbers),
        "albedo": _albedo() if surfaces.has_coat else np.zeros((1, 4), np.float32),
        "domains": domain_rows([asset_at(world, place).domain for place, _ in surfaces.parts]),
        "textures": images.texture_rows(),
    }
    starts = np.cumsum([0, *(len(section) for section in rows.values())]).tolist()
    table = np.concatenate(list(rows.values()))
    sections = dict(zip(rows, starts, strict=False))
    whole = images.whole()
    return SceneTables(geometry, table, sections, whole, surfaces.parts, surfaces.transmits)


def asset_at(world: World, place: int) -> Asset:
    """One of `world.objects` that is an asset, all of which are the runtime's."""
    return cast(Asset, world.objects[place])


def _scene_objects(world: World, visible: Sequence[int]) -> NDArray[np.float32]:
    """(k, 4): a row of OBJECT an instance."""
    rows = np.zeros(len(visible), OBJECT.dtype)
    for row, k in zip(rows, visible, strict=True):
        is_object = isinstance(world.placements[k].object, MeshObject)
        row["number"] = world.number[k]
        row["catches"], row["passes"] = world.catches_shadows[k], not is_object
    return rows.view(np.float32).reshape(-1, 4)


def _albedo() -> NDArray[np.float32]:
    """ALBEDO_TABLE with its means behind each row, two entries a vec4f."""
    whole = np.concatenate([ALBEDO_TABLE, ALBEDO_MEANS[:, None]], axis=1).reshape(-1)
    return np.pad(whole, (0, -len(whole) % 4)).reshape(-1, 4).astype(np.float32)


def domain_rows(domains: Sequence[Any]) -> NDArray[np.float32]:
    """(n, 4) float32: a row a part, whose words are numbers and places of cones; then the cones.

    domains: `Asset.domain` of the parts' assets.
    """
    cones: list[list[float]] = []
    heads = np.zeros((len(domains), 4), np.uint32)
    for head, domain in zip(heads, domains, strict=True):
        for column, region in ((0, domain.wo), (2, domain.wi)):
            head[column : column + 2] = _words(region, cones, len(domains))
    rows = [heads.view(np.float32), np.array(cones, np.float32).reshape(-1, 4)]
    return np.concatenate([*rows, np.zeros((1, 4), np.float32)])


def _words(region: Any, cones: list[list[float]], heads: int) -> tuple[int, int]:
    if region == "sphere":
        return ALL_DIRECTIONS, 0
    if region == "hemisphere":
        return HEMISPHERE, 0
    first = heads + len(cones)
    for cone in region:
        axis = np.asarray(cone.axis, np.float64)
        cones.append([*(axis / np.linalg.norm(axis)), float(np.cos(cone.half_angle)) - _ROUNDING])
    return len(region), first

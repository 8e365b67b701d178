"""The lights of a scene, as rows of LIGHT."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rna_gpu.geometry import Geometry
from rna_gpu.records.tables import LIGHT, LIGHT_DELTA, LIGHT_INFINITE, LIGHT_KINDS, LIGHT_SEEN
from rna_gpu.scene.scene_images import NONE, Images
from rna_render import MeshObject, World
from rna_render.lights import (
    AssetLight,
    EnvironmentImageLight,
    InfiniteLight,
    Light,
    LightSelection,
    MeshLight,
)
from rna_render.paths.sampling import LIGHTS_AT_A_VERTEX


def light_rows(
    lights: Sequence[Light],
    world: World,
    images: Images,
    geometry: Geometry,
    stored: dict[int, int],
    bodies: dict[int, int],
) -> NDArray[np.float32]:
    """(8 k, 4) float32: rows of LIGHT; one at least.

    lights: those of the world first. stored: of the world's instances the numbers in the geometry.
    bodies: of objects, by their id.
    """
    rows = np.zeros(max(len(lights), 1), LIGHT.dtype)
    names = sorted({light.group for light in lights} - {""})
    probability = _probabilities(lights, world.radius)
    shining = _Triangles(images, geometry, bodies)
    instance_of = {int(light): k for k, light in enumerate(world.light) if light >= 0}
    for k, (row, light) in enumerate(zip(rows, lights, strict=False)):
        row["kind"] = LIGHT_KINDS.index(light.kind)
        row["group"] = names.index(light.group) if light.group else NONE
        seen = LIGHT_SEEN * getattr(light, "visible_to_camera", False)
        infinite = LIGHT_INFINITE * isinstance(light, InfiniteLight)
        row["flags"] = int(seen + LIGHT_DELTA * light.delta + infinite)
        numbers = light.numbers.view(np.float64)
        row["numbers"].flat[: len(numbers)] = numbers
        row["probability"] = probability[k]
        if isinstance(light, AssetLight | MeshLight):
            instance = instance_of[k]
            row["instance"] = stored[instance]
            row["numbers"][0, :3] = light.factor
            row["places"] = shining.places(light, world.placements[instance].object)
        elif isinstance(light, EnvironmentImageLight):
            row["places"] = [images.add(a.astype(np.float32)) for a in light.image.tables]
    return rows.view(np.float32).reshape(-1, 4)


class _Triangles:
    """Positions of emissive objects' triangles in the images; instances share them."""

    def __init__(self, images: Images, geometry: Geometry, bodies: dict[int, int]) -> None:
        self._images, self._geometry, self._bodies = images, geometry, bodies
        self._tables: dict[int, NDArray[np.uint32]] = {}

    def places(self, light: AssetLight | MeshLight, scene_object: Any) -> NDArray[np.uint32]:
        """(4,): LIGHT_PLACES of triangles."""
        if not len(light.cumulative):
            return np.zeros(4, np.uint32)
        if id(scene_object) not in self._tables:
            self._tables[id(scene_object)] = self._added(light.cumulative, scene_object)
        return self._tables[id(scene_object)]

    def _added(self, sums: NDArray[np.float64], scene_object: Any) -> NDArray[np.uint32]:
        places = self._geometry.places[self._bodies[id(scene_object)]]
        local, areas = _shining_triangles(scene_object)
        cumulative = sums.astype(np.float32)
        # Of the rounded sums, so that each triangle's density is that with which it is chosen.
        share = np.diff(cumulative).astype(np.float64)
        per_area = np.divide(share, areas, out=np.zeros_like(share), where=areas > 0.0)
        first = int(places.min())
        density = np.zeros(len(places), np.float32)
        density[places[local] - first] = per_area
        add = self._images.add
        offsets = add(cumulative), add(places[local].astype(np.uint32)), add(density)
        return np.array([*offsets[:2], (offsets[2] - first) % 2**32, len(local)], np.uint32)


def _shining_triangles(scene_object: Any) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Emitting triangles of an object or asset: primitive indices, and areas in object space."""
    if isinstance(scene_object, MeshObject):
        return np.arange(len(scene_object.triangles)), _areas(scene_object)
    numbers, areas, start = [], [], 0
    for part in scene_object.parts:
        if part.kind == "fiber":
            start += len(part.curves.segments())
            continue
        count = len(part.mesh.triangles)
        if part.emits:
            numbers.append(start + np.arange(count))
            areas.append(_areas(part.mesh))
        start += count
    return np.concatenate(numbers), np.concatenate(areas)


def _areas(mesh: Any) -> NDArray[np.float64]:
    corners = np.asarray(mesh.positions, np.float64)[mesh.triangles]
    edges = corners[:, 1:] - corners[:, :1]
    return np.asarray(np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1) / 2.0)


def _probabilities(lights: Sequence[Light], radius: float) -> NDArray[np.float64]:
    """(k, 3) samples that each light gets at a point of depth 1, 2 and later, on average."""
    chosen = LightSelection(lights, radius).probability
    if len(lights) > LIGHTS_AT_A_VERTEX:
        return np.repeat(chosen[:, None], 3, axis=1)
    times = [[light.samples, max(light.samples // 2, 1)] for light in lights]
    return np.column_stack([np.reshape(times, (-1, 2)), chosen])

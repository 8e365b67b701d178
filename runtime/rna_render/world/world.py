"""The scene as it is traced: instances of bodies, whose hits come sorted by part of a body."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from rna_render.lights.base import PlacedLight
from rna_render.materials import MeshObject
from rna_render.world.body_cache import BodyCache, body_key
from rna_render.world.placements import Placement, SceneObject
from rna_sdk.machine.compiled import compiled
from rna_sdk.runtime import Asset, Transform
from rna_trace.embree.instances import ALL_RAYS, CAMERA_RAY, NO_INSTANCE, Instance, InstanceScene
from rna_trace.embree.tracing import ClosestHits
from rna_trace.hit_points import Frames, Lines, stepped
from rna_trace.parts_scene import PartsScene
from rna_trace.points import Arrived, Body, Points, Role


@dataclass(frozen=True, slots=True)
class Vertices:
    """Points of the scene that scatter light: m of them, sorted by body, part and instance.

    ray: (m,) place of the ray that hit them in its batch. instance: (m,) int32.
    parts: for each part of a body that was hit its rows, and its points in object space.
    x_world, n_world: (m, 3) float32, points and shading normals.
    ng_world: (m, 3) float32, geometric normals.
    wo_world: (m, 3) float32, unit, towards where the rays came from.
    step: (m,) float32, how far off the surface rays from here start; 0 where they pass through it.
    start_instance: (m,) int32, the instance that rays from here pass through, or NO_INSTANCE.
    next_world: (m, 3) float32, where the points are in the next frame; of camera rays alone.
    """

    ray: np.ndarray
    instance: np.ndarray
    parts: list[tuple[slice, Points]]
    x_world: np.ndarray
    n_world: np.ndarray
    ng_world: np.ndarray
    wo_world: np.ndarray
    step: np.ndarray
    start_instance: np.ndarray
    next_world: np.ndarray

    def __len__(self) -> int:
        return len(self.ray)

    def local_rows(self, row: np.ndarray) -> list[tuple[slice, np.ndarray, Points]]:
        """The given rows, ascending, by part: which of them, their places in its points, these."""
        result = []
        for rows, points in self.parts:
            start, stop = np.searchsorted(row, (rows.start, rows.stop))
            if start < stop:
                result.append((slice(start, stop), row[start:stop] - rows.start, points))
        return result


class World:
    """Instances of bodies, in an order of their own: all instances of a body are neighbours.

    placements: the scene's objects, in the order of its file; the same object twice is one body
    with two instances. bodies: those of an earlier world, to take what does not move from.
    origin: (3,) float64, of the world's space, in which placements, rays and lights are, in that of
    the scene file: float32 is finest where it is looked from. reach: what extends further than this
    from there says nothing about the size of the scene, as a ground does, unless all does.
    Raises QueryError for a transform that is not a similarity.

    Attributes:
        origin: as given.
        objects: those of `placements`.
        indirect: those of `placements`, without None.
        placements: those given, in the order of the instances.
        scene: all instances, in Embree.
        number: (k,) int32, for each instance its place in `placements`, counted from 1.
        scale: (k,) float32, world units an object unit.
        lights: those of the placements.
        light: (k,) int32, for each instance its place in `lights`; -1 if it does not shine.
        same_light: (k,) int32, the same where what the light throws on the instance itself is part
            of its transport; else -1.
        met_by: for each instance the sorts of rays that meet it, as in Instance.
        counts_nearby: whether transport of any body takes random numbers for nearby light.
        catches_shadows: (k,) bool, for each instance whether it shows nothing but shadows on it.
        one_sided: (k,) bool, for each instance whether it sends to the viewer nothing of light that
            comes from the other side of its surface than the viewer is on.
        radius: of a sphere about the scene, without what is boundless or out of reach.
        scatters: whether light can go from one object to another, or to another part of the same.
    """

    def __init__(
        self,
        placements: Sequence[Placement],
        bodies: BodyCache | None = None,
        origin: np.ndarray | None = None,
        reach: float = math.inf,
    ) -> None:
        self.origin = np.zeros(3) if origin is None else origin
        groups: dict[tuple[int, int, int], list[int]] = {}
        for index, placement in enumerate(placements):
            groups.setdefault(body_key(placement), []).append(index)
        order = [index for group in groups.values() for index in group]
        ordered = [placements[index] for index in order]
        self.objects = [placement.object for placement in placements]
        self.indirect = [p.indirect for p in placements if p.indirect is not None]
        self.placements = ordered
        firsts = [placements[group[0]] for group in groups.values()]
        self._bodies = (bodies or BodyCache()).of(firsts)
        self._after = [placement.after for placement in firsts]
        self._order = _HitOrder(self._bodies, [len(group) for group in groups.values()])
        self.number = np.asarray(order, np.int32) + 1
        transforms = [Transform(placement.world_from_object) for placement in ordered]
        scale = np.array([transform.scale for transform in transforms])
        self.scale = scale.astype(np.float32)
        self._matrices = np.array([transform.matrix for transform in transforms])
        self._rotations = self._matrices[:, :3, :3] / scale[:, None, None]
        places = np.ascontiguousarray(self._matrices[:, :3, 3])
        self._frames = Frames(self._rotations, scale, places)
        self._turned = not (self._rotations == np.eye(3)).all()
        self._placed = not (self._matrices == np.eye(4)).all()
        placed_bodies = [self._bodies[b] for b in self._order.body]
        self.met_by = [_met_by(placement.object) for placement in ordered]
        scenes = [body.scene for body in placed_bodies]
        placed = zip(scenes, self._matrices, self.met_by, strict=True)
        self.scene = InstanceScene([Instance(*instance) for instance in placed])
        self.lights = [placement.light for placement in ordered if placement.light is not None]
        shines = np.array([placement.light is not None for placement in ordered])
        self.light = np.where(shines, np.cumsum(shines) - 1, -1).astype(np.int32)
        passes = np.array([body.passes_through for body in placed_bodies])
        self.same_light = np.where(passes, self.light, -1).astype(np.int32)
        self.one_sided = np.array([body.one_sided for body in placed_bodies])
        self._has_role = {
            role: np.array([body.role is role for body in placed_bodies]) for role in Role
        }
        self.counts_nearby = any(body.counts_nearby for body in placed_bodies)
        self.catches_shadows = self._has_role[Role.CATCH_SHADOWS]
        self._passes = passes
        size = scale * np.sqrt(3.0) * [body.scene.extent for body in placed_bodies]
        bounded = np.array([not p.boundless for p in ordered])
        near = bounded & (np.linalg.norm(places, axis=1) + size <= reach)
        self.radius = _radius(places, size, near if near.any() else bounded)
        scattering = self._has_role[Role.SCATTER]
        self.scatters = scattering.sum() > 1 or bool((scattering & ~self._passes).any())

    def vertices(
        self,
        role: Role,
        hits: ClosestHits,
        origin: np.ndarray,
        d_world: np.ndarray,
        seen: bool,
        spread: float = 0.0,
    ) -> Vertices:
        """The hits on bodies of that role, which is not SHINE.

        hits: of n rays. origin, d_world: (n, 3) float32, these. seen: whether they are camera
        rays. spread: width of a pixel over the distance to it; textures are averaged over it.
        """
        ray = np.flatnonzero(hits.instance >= 0)
        ray = ray[self._has_role[role][hits.instance[ray]]]
        ray, groups = self._order.sorted(ray, hits)
        instance = hits.instance[ray]
        wo_world = -d_world.take(ray, axis=0)
        wo = self.to_object_directions(instance, wo_world)
        lines = self.lines(instance, origin.take(ray, axis=0), d_world.take(ray, axis=0))
        x, n, x_next = (np.empty((len(ray), 3), np.float32) for _ in range(3))
        parts = []
        for body, part, rows in groups:
            widths = np.float32(spread) * hits.t[ray[rows]] / self.scale[instance[rows]]
            arrived = Arrived(hits, ray[rows], wo[rows], seen, widths, lines.rows(rows))
            points = self._bodies[body].points(part, arrived)
            x[rows], n[rows] = points.x, points.n
            parts.append((rows, points))
            after = self._after[body] if seen else None
            moved = points.x if after is None else after.points(part, hits, ray[rows], points.x)
            x_next[rows] = moved
        x_world, step = self.to_world_points(instance, x), np.zeros(len(ray), np.float32)
        for rows, points in parts:
            if points.found is not None:
                x_world[rows], step[rows] = points.found.x_world, points.found.step
        bends = seen and any(self._after)
        return Vertices(
            ray=ray,
            instance=instance,
            parts=parts,
            x_world=x_world,
            n_world=self.to_world_directions(instance, n),
            ng_world=self.to_world_directions(instance, hits.ng.take(ray, axis=0)),
            wo_world=wo_world,
            step=step,
            start_instance=np.where(self._passes[instance], instance, NO_INSTANCE).astype(np.int32),
            next_world=self.to_world_points(instance, x_next) if bends else x_world,
        )

    def origins(self, vertices: Vertices, row: np.ndarray, wi_world: np.ndarray) -> np.ndarray:
        """Origins of rays from the given rows along wi: (k, 3) float32.

        On bodies that they must not hit at once, a step off the surface towards wi.
        """
        return stepped(vertices.x_world, vertices.ng_world, vertices.step, wi_world, row)

    def lines(self, instance: np.ndarray, origin: np.ndarray, d_world: np.ndarray) -> Lines:
        """Rays that have hit the given instances, for `rna_trace.hit_points`."""
        return Lines(origin, d_world, instance, self._frames)

    def to_world_directions(self, instance: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """Object-space directions (n, 3) float32 of the given instances, in the world.

        Here and below the vectors themselves, not a copy, where no instance is placed otherwise.
        """
        if not self._turned:
            return directions
        return _transformed(self._rotations, self._no_shift, instance, directions)

    def to_object_directions(
        self, instance: np.ndarray, directions_world: np.ndarray
    ) -> np.ndarray:
        """World-space unit directions (n, 3) float32, in the given instances' object space."""
        if not self._turned:
            return directions_world
        inverse = self._rotations.transpose(0, 2, 1)
        return _transformed(inverse, self._no_shift, instance, directions_world)

    def to_world_points(self, instance: np.ndarray, points: np.ndarray) -> np.ndarray:
        """Object-space points (n, 3) float32 of the given instances, in the world."""
        if not self._placed:
            return points
        linear, translation = self._matrices[:, :3, :3], self._matrices[:, :3, 3]
        return _transformed(linear, translation, instance, points)

    def sides(self, instance: int) -> list[int]:
        """`PartsScene.sides` of an instance; empty where no scattered ray meets its parts."""
        scene = self._bodies[self._order.body[instance]].scene
        return scene.sides.tolist() if self.scatters and isinstance(scene, PartsScene) else []

    @property
    def assets(self) -> list[Asset]:
        """The assets among `objects`."""
        others = MeshObject | PlacedLight
        return [placed for placed in self.objects if not isinstance(placed, others)]

    @property
    def _no_shift(self) -> np.ndarray:
        return np.zeros((len(self.number), 3))


class _HitOrder:
    """Hits by body, then by part of it, then by instance.

    bodies: with their numbers of instances, which are neighbours. body: (k,) of each instance.
    """

    def __init__(self, bodies: Sequence[Body], instances: Sequence[int]) -> None:
        self.body = np.repeat(np.arange(len(bodies)), instances)
        most = max(body.part_count for body in bodies)
        # The rank of a hit on a part of an instance; those of a part of a body are in a row.
        self._rank = np.zeros((len(self.body), most), np.int64)
        self._groups: list[tuple[int, int]] = []
        starts, rank = [], 0
        for number, body in enumerate(bodies):
            for part in range(body.part_count):
                self._groups.append((number, part))
                starts.append(rank)
                self._rank[self.body == number, part] = rank + np.arange(instances[number])
                rank += instances[number]
        self._starts = np.array([*starts, rank])

    def sorted(
        self, ray: np.ndarray, hits: ClosestHits
    ) -> tuple[np.ndarray, list[tuple[int, int, slice]]]:
        """The rays in order, and for each part of a body that was hit both, and its rows."""
        rank = self._rank[hits.instance[ray], hits.geometry[ray]]
        order = np.argsort(rank, kind="stable")
        cuts = np.searchsorted(rank[order], self._starts)
        spans = zip(self._groups, pairwise(cuts), strict=True)
        groups = [(*group, slice(*cut)) for group, cut in spans if cut[0] < cut[1]]
        return ray[order], groups


def _met_by(scene_object: SceneObject) -> int:
    """The sorts of rays that meet an object."""
    if isinstance(scene_object, PlacedLight) and not scene_object.visible_to_camera:
        return ALL_RAYS & ~CAMERA_RAY
    if isinstance(scene_object, MeshObject) and scene_object.catches_shadows:
        return CAMERA_RAY
    return ALL_RAYS


def _radius(centres: np.ndarray, sizes: np.ndarray, counts: np.ndarray) -> float:
    """Radius of a sphere about the counted balls, or about all if none counts; approximate."""
    chosen = counts if counts.any() else np.ones(len(counts), bool)
    centre = centres[chosen].mean(axis=0)
    return float((np.linalg.norm(centres[chosen] - centre, axis=1) + sizes[chosen]).max())


def _transformed(
    linear: np.ndarray, shift: np.ndarray, instance: np.ndarray, vectors: np.ndarray
) -> np.ndarray:
    result = np.empty_like(vectors)
    _transform(np.ascontiguousarray(linear), np.ascontiguousarray(shift), instance, vectors, result)
    return result


@compiled(rows="instance vectors result", fastmath=())
def _transform(
    linear: np.ndarray,
    shift: np.ndarray,
    instance: np.ndarray,
    vectors: np.ndarray,
    result: np.ndarray,
) -> None:
    for i in range(len(instance)):
        k = instance[i]
        for row in range(3):
            value = shift[k, row]
            for column in range(3):
                value += linear[k, row, column] * vectors[i, column]
            result[i, row] = value

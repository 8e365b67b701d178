"""The exported geometry in Embree, with the renderer's intersection code."""

import copy
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from rna_export.capture.capture_settings import SHARPEST
from rna_export.capture.dataset.dataset_manifest import BASE_COLOR
from rna_export.capture.rays.fiber_shape import FiberShape
from rna_export.capture.rays.surface_shape import SurfaceShape
from rna_sdk.package import BaseColor, Curves, Mesh, NormalMap
from rna_sdk.package.textures.transmittance import Transmittance
from rna_sdk.runtime import DeformedCurves, DeformedMesh, RestPoints
from rna_sdk.runtime.base_color import BaseColorMaps
from rna_sdk.runtime.deformation import RestCurves, RestMesh
from rna_trace import ClosestHits, NormalMaps, PartPoints, PartsScene, mesh_transmittance

_MOST_LAYERS = 64  # that a ray passes
_CLEAR = 0.95  # transmittance from which a surface shows too little of itself to be learnt
_MOST_PASS = 0.75  # the share of rays that go on behind, at most: thin layers are learnt as well


@dataclass(frozen=True)
class PartRows:
    """Ray hits on one part.

    rows: (k,) int64, which of the rays. points: (k) of them. fields: what a sample records of the
    point, except its directions: name -> (k,) or (k, c) rows. rest: of a deformed part, the points
    at rest, whose rotations take directions there.
    """

    rows: np.ndarray
    points: PartPoints
    fields: dict[str, np.ndarray]
    rest: RestPoints | None = None

    def at_rest(self, directions: np.ndarray) -> np.ndarray:
        """Directions at the points as samples record them: those of the rest shape, (k, 3)."""
        return directions if self.rest is None else self.rest.to_rest(directions)


@dataclass(frozen=True)
class ShadePoints:
    """Ray hits on the asset; arrays have one row per ray, zero for misses."""

    part: np.ndarray  # (n,) int32, place of the part; -1 for a miss
    position: np.ndarray  # (n, 3) float32
    geometric_normal: np.ndarray  # (n, 3) float32
    transmittance: np.ndarray  # (n, 3) float32, of the point itself
    on: tuple[PartRows, ...]  # for each part

    @property
    def hit(self) -> np.ndarray:
        """(n,) bool."""
        return self.part >= 0


class AssetScene:
    """Ray queries against all parts of an asset.

    sharpest: roughness of the smoothest material whose highlights views are to find.
    transmittances: what each part lets through; none at all if left out. normal_maps, base_colors:
    likewise, the latter of each print. positions: of each part in a pose, (v, 3) float32; none at
    all if left out. Rays meet this shape; samples are those of the rest shape: spec/RNA.md, 8.3.

    Attributes:
        poses: the same asset in other poses, which rays of a capture meet by turns with this one.
        transmits: whether rays pass through any part.
        shapes: of the parts, in order.
        centre: (3,) float32, of the bounding box; radius: of the sphere around it.
    """

    def __init__(
        self,
        geometries: Sequence[Mesh | Curves],
        sharpest: float = SHARPEST,
        transmittances: Sequence[Sequence[Transmittance]] = (),
        normal_maps: Sequence[Sequence[NormalMap]] = (),
        positions: Sequence[np.ndarray] = (),
        base_colors: Sequence[Sequence[Sequence[BaseColor]]] = (),
    ):
        self.poses: tuple[AssetScene, ...] = ()
        rest = geometries
        self._deformed = [_deformed(g, p) for g, p in zip(rest, positions, strict=bool(positions))]
        geometries = [_geometry(d) for d in self._deformed] or rest
        self.shapes = tuple(
            FiberShape(g) if isinstance(g, Curves) else SurfaceShape(g, sharpest)
            for g in geometries
        )
        every = transmittances or [()] * len(geometries)
        tables = [
            mesh_transmittance(geometry, records)
            for geometry, records in zip(geometries, every, strict=True)
        ]
        self._scene = PartsScene(geometries, tables, _maps(geometries, normal_maps))
        self._prints = [
            [
                BaseColorMaps(geometry, of_part) if of_part and isinstance(geometry, Mesh) else None
                for geometry, of_part in zip(rest, of_print, strict=True)
            ]
            for of_print in base_colors or [[()] * len(rest)]
        ]
        self._colors = self._prints[0]
        self._rest_maps = _maps(rest, normal_maps) if self._deformed else []
        self.transmits = self._scene.transmits
        corners = np.concatenate([shape.points for shape in self.shapes])
        low, high = corners.min(axis=0), corners.max(axis=0)
        self.centre = ((low + high) / 2).astype(np.float32)
        self.radius = max(shape.reach(self.centre) for shape in self.shapes)
        area = np.array([shape.area for shape in self.shapes])
        self._by_area = area / area.sum()

    def distance(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """Distance to the asset along rays (n, 3): (n,), inf for misses."""
        return self.first_hits(origins, directions).t

    def part_hit(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """Part hit first by each ray, (n,) int32; -1 for misses."""
        return self.first_hits(origins, directions).geometry

    def first_hits(
        self, origins: np.ndarray, directions: np.ndarray, rng: np.random.Generator | None = None
    ) -> ClosestHits:
        """Closest hits of rays (n, 3), without holes; rng: `_solid_hits`."""
        return self._solid_hits(origins, directions, rng)[0]

    def meets(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """Whether each ray meets a triangle or strand, holes included: (n,) bool."""
        return np.asarray(self._scene.intersect(origins, directions).geometry >= 0)

    def coverage(self, origins: np.ndarray, directions: np.ndarray) -> np.ndarray:
        """The alpha of rays (n, 3) from outside: 1 less the transmittance of all layers, (n,)."""
        return np.asarray(1.0 - self._scene.transmitted(origins, directions).mean(axis=1))

    def free_distance(self, points: np.ndarray, normals: np.ndarray, wo: np.ndarray) -> np.ndarray:
        """Distance to the asset from points (n, 3) along wo: (n,), inf for misses."""
        return self.distance(points + np.float32(1e-4 * self.radius) * normals, wo)

    def _solid_hits(
        self, origins: np.ndarray, directions: np.ndarray, rng: np.random.Generator | None = None
    ) -> tuple[ClosestHits, np.ndarray]:
        """Closest hits of rays (n, 3), without holes, and their transmittance, (n, 3) float32.

        rng: where a hit lets a part of the light through, the ray goes on as often; None: never.
        """
        hits = self._scene.intersect(origins, directions)
        tau = np.zeros((len(origins), 3), np.float32)
        left = np.flatnonzero(hits.geometry >= 0) if self.transmits else np.zeros(0, int)
        for _ in range(_MOST_LAYERS):
            if not len(left):
                break
            tau[left] = self._scene.hit_transmittance(hits.take(left), directions[left])
            share = np.minimum(tau[left].mean(axis=1), _MOST_PASS)
            passes = tau[left].min(axis=1) > _CLEAR
            if rng is not None:
                passes |= rng.random(len(left)) < share
            left = left[passes]
            nearest = np.nextafter(hits.t[left], np.float32(np.inf)) * np.float32(1.0 + 1e-6)
            behind = self._scene.intersect(origins[left], directions[left], nearest)
            for name in ("t", "geometry", "primitive", "u", "v", "ng"):
                getattr(hits, name)[left] = getattr(behind, name)
            tau[left] = 0.0
            left = left[behind.geometry >= 0]
        return hits, tau

    def shade_points(
        self, origins: np.ndarray, directions: np.ndarray, rng: np.random.Generator | None = None
    ) -> ShadePoints:
        """First hits of rays (n, 3), with everything that a sample records; rng: `_solid_hits`."""
        hits, tau = self._solid_hits(origins, directions, rng)
        position = np.zeros((len(origins), 3), np.float32)
        on = []
        for part, shape in enumerate(self.shapes):
            rows = np.flatnonzero(hits.geometry == part)
            arrays = (a[rows] for a in (hits.primitive, hits.u, hits.v, hits.ng))
            points = self._scene.points(part, *arrays)
            position[rows] = points.x
            fields = shape.sample_fields(points, directions[rows])
            if (rest := self._rest_points(part, hits, rows)) is not None:
                fields |= {"position": rest.positions, shape.axis: rest.axes}
            if (colors := self._colors[part]) is not None:
                at = (a[rows] for a in (hits.primitive, hits.u, hits.v))
                fields[BASE_COLOR] = colors.at(*at).astype(np.float16)
            on.append(PartRows(rows, points, fields, rest))
        return ShadePoints(hits.geometry, position, hits.ng, tau, tuple(on))

    def _rest_points(self, part: int, hits: ClosestHits, rows: np.ndarray) -> RestPoints | None:
        if not self._deformed:
            return None
        shape, maps = self._deformed[part], self._rest_maps[part]
        triangle, u, v = (a[rows] for a in (hits.primitive, hits.u, hits.v))
        if isinstance(shape, DeformedCurves):
            return shape.rest_points(triangle, u, hits.ng[rows])
        rest = shape.rest_points(triangle, u, v)
        return rest if maps is None else replace(rest, axes=maps.at(rest.axes, triangle, u, v))

    def in_pose(self, number: int) -> "AssetScene":
        """The asset in one of its poses; 0 for this one."""
        return self if number == 0 else self.poses[number - 1]

    def printed(self, number: int) -> "AssetScene":
        """The asset in one of its prints; 0 for the first."""
        other = copy.copy(self)
        other._colors = self._prints[number]
        return other

    def visible(self, points: ShadePoints, wi: np.ndarray) -> np.ndarray:
        """The visibility of the transport contract along wi (n, 3) at each point.

        (n,) bool; where the asset transmits, (n, 3) float32.
        """
        shape, dtype = ((len(points.part), 3), np.float32) if self.transmits else (len(wi), bool)
        free = np.zeros(shape, dtype)
        for part, on in enumerate(points.on):
            free[on.rows] = self._scene.visible(part, on.points, wi[on.rows])
        return free

    def sample_points(
        self, n: int, rng: np.random.Generator, shares: np.ndarray | None = None
    ) -> tuple[np.ndarray, np.ndarray]:
        """n points and their geometric normals, (n, 3) float32 each, uniform by area on each part.

        shares: of each part among the points, which add up to 1; None: by area, too.
        """
        wanted = part_counts(n, self._by_area if shares is None else shares)
        drawn = [s.sample_points(k, rng) for s, k in zip(self.shapes, wanted, strict=True)]
        points, normals = (np.concatenate(arrays) for arrays in zip(*drawn, strict=True))
        return points, normals

    def highlight_views(
        self, points: ShadePoints, wi: np.ndarray, rng: np.random.Generator
    ) -> tuple[np.ndarray, np.ndarray]:
        """View directions at which light from wi (3,) makes highlights on the points.

        Returns the rows (k,) that have one, and the unit directions (k, 3).
        """
        rows, views = [], []
        for shape, on in zip(self.shapes, points.on, strict=True):
            of_part, wo = shape.highlight_views(on.points, wi, rng)
            rows.append(on.rows[of_part])
            views.append(wo)
        every = np.concatenate(rows)
        order = np.argsort(every)
        return every[order], np.concatenate(views)[order]


def _deformed(geometry: Mesh | Curves, positions: np.ndarray) -> DeformedMesh | DeformedCurves:
    if isinstance(geometry, Curves):
        return RestCurves(geometry).deformed(positions)
    return RestMesh(geometry).deformed(positions)


def _geometry(shape: DeformedMesh | DeformedCurves) -> Mesh | Curves:
    return shape.curves if isinstance(shape, DeformedCurves) else shape.mesh


def _maps(
    geometries: Sequence[Mesh | Curves], normal_maps: Sequence[Sequence[NormalMap]]
) -> list[NormalMaps | None]:
    return [
        NormalMaps(geometry, of_part) if of_part and isinstance(geometry, Mesh) else None
        for geometry, of_part in zip(geometries, normal_maps or [()] * len(geometries), strict=True)
    ]


def part_counts(n: int, shares: np.ndarray) -> np.ndarray:
    """n divided among parts as the shares say, whole numbers that add up to n."""
    return np.diff(np.round(n * np.concatenate([[0.0], np.cumsum(shares)])).astype(int))

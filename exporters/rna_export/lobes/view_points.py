"""Points of a part that viewers see, the transport at them, and the visibility about them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from rna_export.lobes.directions import even_directions, harmonics, random_directions
from rna_sdk.package import Mesh
from rna_sdk.package.geometry.vertex_visibility import Harmonics, quantised_harmonics
from rna_sdk.package.manifest.extensions import HARMONICS
from rna_sdk.runtime import Asset, FiberAsset, SurfaceAsset, offset_across
from rna_sdk.runtime.kernels.lobe_kernels import mixed_harmonics
from rna_trace import (
    FiberPoints,
    PartPoints,
    PartsScene,
    SurfacePoints,
    nearby_light,
    part_geometry,
    part_normal_maps,
    part_transmittance,
)

Rows = NDArray[np.float32]

_DISTANCE = 4.0  # of viewers from the asset's middle, in its radii
_RAYS = 512  # of the visibility of a vertex
_AT_ONCE = 2000  # vertices
_NEAR_CORNER = 0.9  # barycentric coordinate: rays do not start on the edges of a triangle
_NEARBY_RAYS = 4  # of each light direction at a point
_TRIES = 50_000  # rays that miss a part before it counts as hidden


@dataclass(frozen=True, eq=False)
class ViewPoints:
    """n points of a part, each with a viewer.

    Attributes:
        at: where they are, for rays.
        primitive: (n,), numbers of the triangles or segments that they are on.
        position, axis, wo: (n, 3) float32, object space: metres; mapped normals or tangents; to
            the viewer.
        h: (n,) float32, offsets across fibers; 0 for surfaces.
        wide, mirror: (n, 3) float32, unit: the directions that lobes are about before a decoder
            turns them. Surface: the normal, and the mirror direction of wo. Fiber: the directions
            in which a smooth cylinder lets wo through (TT), and reflects it (R).
        free: (n,) float32, visibility along `mirror`.
        visibility: (n, HARMONICS) float32, harmonics of the visibility about the point; (n, 0) on
            fibers.
        base_color: (n, 3) float32, of a part whose tier uses it.
    """

    at: PartPoints
    primitive: np.ndarray
    position: Rows
    axis: Rows
    h: Rows
    wo: Rows
    wide: Rows
    mirror: Rows
    free: Rows
    visibility: Rows
    base_color: Rows | None = None

    def __len__(self) -> int:
        return len(self.position)


@dataclass(frozen=True, slots=True)
class Grid:
    """Rays of a square picture.

    size: pixels of a side. rays: along a pixel's side. finest: pixels of a side of the picture that
    the pixels are taken from, evenly; None for all of its pixels.
    """

    size: int
    rays: int = 1
    finest: int | None = None

    def places(self) -> tuple[np.ndarray, np.ndarray, NDArray[np.int64]]:
        """x to the right and y down, -1 to 1, and the pixel of each ray, all ((rays size)^2,)."""
        within = ((np.arange(self.rays) + 0.5) / self.rays - 0.5) * 2.0 / (self.finest or self.size)
        middle = (np.arange(self.size) + 0.5) / self.size * 2.0 - 1.0
        line = (middle[:, None] + within).ravel()
        pixel = np.repeat(np.arange(self.size), self.rays)
        x, y = np.tile(line, len(line)), np.repeat(line, len(line))
        return x, y, (pixel[:, None] * self.size + pixel).ravel()


LobesAt = Callable[[ViewPoints], tuple[Rows, Rows]]
"""Amplitudes and axes of lobes at points, (n, L, 3) float32 each."""


def part_views(asset: Asset, visibility: Sequence[Harmonics | None] = ()) -> list["PartViews"]:
    """Views of each part of a loaded asset. visibility: of earlier views, to save its rays."""
    scene = PartsScene(
        [part_geometry(part) for part in asset.parts],
        [part_transmittance(part) for part in asset.parts],
        [part_normal_maps(part) for part in asset.parts],
    )
    known = visibility or [None] * len(asset.parts)
    return [PartViews(asset, index, scene, one) for index, one in enumerate(known)]


class PartViews:
    """Points of one part of an asset that viewers see.

    Attributes:
        part: the part.
        visibility: (m, HARMONICS) int8, harmonics of the asset's own visibility about the mesh's
            vertices, as `quantised_harmonics` has them; the first is the visible part of the
            sphere. None for fibers, about which it changes too fast with direction.
    """

    def __init__(
        self, asset: Asset, index: int, scene: PartsScene, visibility: Harmonics | None = None
    ) -> None:
        """index: of the part. scene: of all parts. visibility: the attribute, if it is known."""
        self.part, self._index, self._scene = asset.parts[index], index, scene
        box = part_geometry(self.part).box()
        boxes = [part_geometry(part).box() for part in asset.parts]
        self._sphere, self._picture_sphere = (
            _sphere(*box),
            _sphere(
                low=np.min([box[0] for box in boxes], axis=0),
                high=np.max([box[1] for box in boxes], axis=0),
            ),
        )
        self._mesh = self.part.mesh if isinstance(self.part, SurfaceAsset) else None
        if visibility is None and self._mesh is not None:
            visibility = self._baked(self._mesh)
        self.visibility = visibility

    @property
    def visibility_columns(self) -> int:
        """Number of columns of ViewPoints.visibility."""
        return 0 if self.visibility is None else HARMONICS

    @cached_property
    def is_hidden(self) -> bool:
        """Whether no viewer sees it."""
        row, _ = self._seen(*self._random_rays(_TRIES, np.random.default_rng(0)))
        return not len(row)

    def points(self, count: int, rng: np.random.Generator) -> ViewPoints:
        """`count` random points that random viewers see of a part that is not hidden."""
        result: list[tuple[np.ndarray, ...]] = []
        have = 0
        while have < count:
            _, seen = self._seen(*self._random_rays(3 * (count - have) + 64, rng))
            result.append(seen)
            have += len(seen[0])
        columns = zip(*result, strict=True)
        return self._view_points(*(np.concatenate(rows)[:count] for rows in columns))

    def picture(self, azimuth: float, grid: Grid) -> tuple[ViewPoints, NDArray[np.int64]]:
        """The part's points of a square picture of the asset, and their pixels, top row first.

        azimuth: of the viewer about the vertical, radians.
        """
        centre, radius = self._picture_sphere
        away = np.array([np.sin(azimuth), 0.5, np.cos(azimuth)]) / np.hypot(1.0, 0.5)
        right = np.array([np.cos(azimuth), 0.0, -np.sin(azimuth)])
        x, y, pixel = grid.places()
        across, down = radius * x[:, None], radius * y[:, None]
        origin = centre + _DISTANCE * radius * away
        target = centre + across * right - down * np.cross(away, right)
        row, seen = self._seen(np.broadcast_to(origin, target.shape), target)
        return self._view_points(*seen), pixel[row]

    def transport(self, points: ViewPoints, row: np.ndarray, wi: Rows) -> Rows:
        """Transport with the asset's own shadows: (k, 3) float32.

        row: (k,) which points. wi: (k, 3) float32, unit.
        """
        free = self._free(points.at, row, wi)
        x, axis = points.position.take(row, axis=0), points.axis.take(row, axis=0)
        wo, nearby = points.wo.take(row, axis=0), self._nearby(points.at.x, row, wi)
        if isinstance(self.part, FiberAsset):
            return self.part.transport(x, axis, points.h[row], wo, wi, free, nearby)
        color = None if points.base_color is None else points.base_color.take(row, axis=0)
        return self.part.transport(x, axis, wo, wi, free, color, nearby)

    def _nearby(self, x: Rows, row: np.ndarray, wi: Rows) -> Rows | None:
        """Nearby light of rows, by few rays: lobes are the mean of many; None of a part without."""
        lengths = self.part.nearby_lengths
        if lengths is None:
            return None
        return nearby_light(self._scene, lengths, x.take(row, axis=0), wi, _NEARBY_RAYS)

    def _random_rays(self, count: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """Origins at random viewers, and random places in the part's sphere."""
        centre, radius = self._sphere
        origin = centre + _DISTANCE * radius * random_directions(count, rng)
        place = random_directions(count, rng) * rng.random((count, 1)) ** (1 / 3)
        return origin, centre + radius * place

    def _seen(
        self, origin: np.ndarray, target: np.ndarray
    ) -> tuple[NDArray[np.int64], tuple[np.ndarray, ...]]:
        """Rays that meet this part; primitive, u, v and normal of their hits, and wo there."""
        d = target - origin
        d /= np.linalg.norm(d, axis=1, keepdims=True)
        hits = self._scene.intersect(origin.astype(np.float32), d.astype(np.float32))
        row = np.flatnonzero(hits.geometry == self._index)
        at = hits.primitive[row], hits.u[row], hits.v[row], hits.ng[row]
        return row, (*at, -d[row].astype(np.float32))

    def _view_points(
        self, primitive: np.ndarray, u: np.ndarray, v: np.ndarray, normals: Rows, wo: Rows
    ) -> ViewPoints:
        at = self._scene.points(self._index, primitive, u, v, normals)
        if isinstance(at, FiberPoints):
            axis, h = at.tangent, offset_across(at.n, at.tangent, wo)
        else:
            axis, h = at.mapped, np.zeros(len(wo), np.float32)
        wide, mirror = -wo if isinstance(at, FiberPoints) else axis, self.part.mirror(axis, wo)
        free = self._free(at, np.arange(len(wo)), mirror)
        visibility = self._interpolated(primitive, u, v)
        part, color = self.part, None
        if isinstance(part, SurfaceAsset) and part.uses_base_color:
            color = part.base_color_at(primitive, u, v)
        return ViewPoints(
            at=at,
            primitive=primitive,
            position=at.x,
            axis=axis,
            h=h,
            wo=wo,
            wide=wide,
            mirror=mirror,
            free=free,
            visibility=visibility,
            base_color=color,
        )

    def _free(self, at: PartPoints, row: np.ndarray, wi: Rows) -> Rows:
        """How much of the light along wi the asset leaves: (k,) float32, the mean of RGB."""
        far = np.full(len(wi), np.inf, np.float32)
        seen = self._scene.visible(self._index, at, np.ascontiguousarray(wi, np.float32), far, row)
        return np.asarray(seen if seen.ndim == 1 else seen.mean(axis=1), np.float32)

    def _baked(self, mesh: Mesh) -> Harmonics:
        at = self._vertices(mesh)
        d = even_directions(_RAYS)
        columns = harmonics(d) * np.float32(np.sqrt(4 * np.pi) / _RAYS)
        baked = []
        for start in range(0, len(at), _AT_ONCE):
            row = np.arange(start, min(start + _AT_ONCE, len(at)))
            free = self._free(at, np.repeat(row, _RAYS), np.tile(d, (len(row), 1)))
            baked.append(free.reshape(-1, _RAYS) @ columns)
        return quantised_harmonics(np.concatenate(baked))

    def _vertices(self, mesh: Mesh) -> SurfacePoints:
        """Each vertex as a point of a triangle that has it."""
        triangles, corners = mesh.triangles, mesh.positions
        of, corner = np.zeros(len(corners), np.int32), np.zeros(len(corners), np.int64)
        for k in range(3):
            of[triangles[:, k]], corner[triangles[:, k]] = np.arange(len(triangles)), k
        rest = (1 - _NEAR_CORNER) / 2
        u, v = (np.where(corner == k, _NEAR_CORNER, rest).astype(np.float32) for k in (1, 2))
        a, b, c = (corners[triangles[of, k]] for k in range(3))
        points = self._scene.points(self._index, of, u, v, _unit(np.cross(b - a, c - a)))
        assert isinstance(points, SurfacePoints)
        return points

    def _interpolated(self, primitive: np.ndarray, u: np.ndarray, v: np.ndarray) -> Rows:
        """The vertices' harmonics at hits."""
        if self._mesh is None or self.visibility is None:
            return np.zeros((len(u), 0), np.float32)
        result = np.empty((len(u), HARMONICS), np.float32)
        number = primitive.astype(np.int64)
        mixed_harmonics(self.visibility, self._mesh.triangles, number, u, v, result)
        return result


def _sphere(low: np.ndarray, high: np.ndarray) -> tuple[np.ndarray, float]:
    """Middle and radius of a box's sphere."""
    return (low + high) / 2, float(np.linalg.norm(high - low)) / 2


def _unit(v: np.ndarray) -> Rows:
    length = np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-30)
    return np.asarray(v / length, np.float32)

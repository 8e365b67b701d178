"""Random points of random views of an asset of one part, and the transport at them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rna_bench.lobes.directions import even_directions, random_directions
from rna_bench.lobes.spherical_harmonics import harmonics
from rna_bench.one_part import OnePart
from rna_sdk.runtime import FiberAsset, offset_across
from rna_trace import (
    FiberPoints,
    PartPoints,
    PartsScene,
    SurfacePoints,
    part_geometry,
    part_normal_maps,
    part_transmittance,
)

Rows = NDArray[np.float32]

_DISTANCE = 4.0  # of viewers from the asset's middle, in its radii
_RAYS = 512  # of the visibility of a vertex
_AT_ONCE = 2000  # vertices
_NEAR_CORNER = 0.9  # barycentric coordinate: rays do not start on the edges of a triangle


@dataclass(frozen=True, eq=False)
class ViewPoints:
    """n points, each with a viewer.

    Attributes:
        at: where they are, for rays.
        position, axis, wo: (n, 3) float32, object space: metres; mapped normals or tangents; to
            the viewer.
        h: (n,) float32, offsets across fibers; 0 for surfaces.
        about: two directions, (n, 3) float32 each, that lobes are about before a decoder turns
            them. Surface: the normal, and the mirror direction of wo. Fiber: the directions in
            which a smooth cylinder lets wo through (TT), and reflects it (R).
        free: (n,) float32, visibility along the second of them.
        visibility: (n, COUNT) float32, harmonics of the visibility about the point.
    """

    at: PartPoints
    position: Rows
    axis: Rows
    h: Rows
    wo: Rows
    about: tuple[Rows, Rows]
    free: Rows
    visibility: Rows

    def __len__(self) -> int:
        return len(self.position)

    def rows(self) -> dict[str, Rows]:
        """All but `at`, by name; `about` as "untouched" and "asked"."""
        named = {"position": self.position, "axis": self.axis, "h": self.h, "wo": self.wo}
        named |= {"untouched": self.about[0], "asked": self.about[1]}
        return named | {"free": self.free, "visibility": self.visibility}


class AssetViews:
    """What random viewers see of an asset of one part."""

    def __init__(self, part: OnePart) -> None:
        self.part, self._geometry = part, part_geometry(part)
        tables, maps = [part_transmittance(part)], [part_normal_maps(part)]
        self._scene = PartsScene([self._geometry], tables, maps)
        low, high = self._geometry.box()
        self._centre, self._radius = (low + high) / 2, float(np.linalg.norm(high - low)) / 2
        self._visibility = self._baked()

    def points(self, count: int, rng: np.random.Generator) -> ViewPoints:
        """`count` random points that random viewers see."""
        found: list[tuple[np.ndarray, ...]] = []
        have = 0
        while have < count:
            found.append(self._seen(3 * (count - have) + 64, rng))
            have += len(found[-1][0])
        primitive, u, v, normals, wo = (
            np.concatenate(rows)[:count] for rows in zip(*found, strict=True)
        )
        at = self._scene.points(0, primitive, u, v, normals)
        if isinstance(at, FiberPoints):
            axis, h = at.tangent, offset_across(at.n, at.tangent, wo)
        else:
            axis, h = at.mapped, np.zeros(count, np.float32)
        along = np.sum(axis * wo, axis=1, keepdims=True)
        is_fiber = isinstance(at, FiberPoints)
        about = (-wo, wo - 2 * along * axis) if is_fiber else (axis, 2 * along * axis - wo)
        free = self._free(at, np.arange(count), about[1])
        return ViewPoints(at, at.x, axis, h, wo, about, free, self._interpolated(primitive, u, v))

    def _seen(self, rays: int, rng: np.random.Generator) -> tuple[np.ndarray, ...]:
        """Where rays from random viewers to random places in the asset's sphere meet it."""
        away = random_directions(rays, rng)
        place = random_directions(rays, rng) * rng.random((rays, 1)) ** (1 / 3)
        origin = self._centre + _DISTANCE * self._radius * away
        d = self._centre + self._radius * place - origin
        d /= np.linalg.norm(d, axis=1, keepdims=True)
        hits = self._scene.intersect(origin.astype(np.float32), d.astype(np.float32))
        row = np.flatnonzero(hits.part >= 0)
        wo = -d[row].astype(np.float32)
        return hits.primitive[row], hits.u[row], hits.v[row], hits.normals[row], wo

    def transport(self, points: ViewPoints, row: np.ndarray, wi: Rows) -> Rows:
        """Transport with the asset's own shadows: (k, 3) float32.

        row: (k,) which points. wi: (k, 3) float32, unit.
        """
        free = self._free(points.at, row, wi)[:, None]
        x, axis = points.position.take(row, axis=0), points.axis.take(row, axis=0)
        wo = points.wo.take(row, axis=0)
        if isinstance(self.part, FiberAsset):
            visible, shadowed = self.part.evaluate(x, axis, points.h[row], wo, wi)
        else:
            visible, shadowed = self.part.evaluate(x, axis, wo, wi)
        return free * visible + (np.float32(1.0) - free) * shadowed

    def _free(self, at: PartPoints, row: np.ndarray, wi: Rows) -> Rows:
        """How much of the light along wi the asset leaves: (k,) float32, the mean of RGB."""
        far = np.full(len(wi), np.inf, np.float32)
        seen = self._scene.visible(0, at, np.ascontiguousarray(wi, np.float32), far, row)
        return np.asarray(seen if seen.ndim == 1 else seen.mean(axis=1), np.float32)

    def _baked(self) -> Rows:
        """Harmonics of the visibility about each vertex, (m, COUNT) float32.

        The first is the visible part of the sphere.
        """
        at = self._vertices()
        d = even_directions(_RAYS)
        columns = harmonics(d) * np.float32(np.sqrt(4 * np.pi) / _RAYS)
        baked = []
        for start in range(0, len(at), _AT_ONCE):
            row = np.arange(start, min(start + _AT_ONCE, len(at)))
            free = self._free(at, np.repeat(row, _RAYS), np.tile(d, (len(row), 1)))
            baked.append(free.reshape(-1, _RAYS) @ columns)
        return np.concatenate(baked)

    def _vertices(self) -> PartPoints:
        """Each vertex as a point of a triangle or segment that has it."""
        if isinstance(self.part, FiberAsset):
            first = self.part.curves.segments()
            of = np.zeros(len(self.part.curves.points), np.int32)
            of[first + 1] = of[first] = np.arange(len(first))
            u = (np.arange(len(of)) != first[of]).astype(np.float32)
            side = np.cross(self._segments(first)[of], (0.0, 1.0, 1e-3))
            return self._scene.points(0, of, u, np.zeros_like(u), _unit(side))
        triangles, corners = self.part.mesh.triangles, self.part.mesh.positions
        of, corner = np.zeros(len(corners), np.int32), np.zeros(len(corners), np.int64)
        for k in range(3):
            of[triangles[:, k]], corner[triangles[:, k]] = np.arange(len(triangles)), k
        rest = (1 - _NEAR_CORNER) / 2
        u, v = (np.where(corner == k, _NEAR_CORNER, rest).astype(np.float32) for k in (1, 2))
        a, b, c = (corners[triangles[of, k]] for k in range(3))
        points = self._scene.points(0, of, u, v, _unit(np.cross(b - a, c - a)))
        assert isinstance(points, SurfacePoints)
        return points

    def _segments(self, first: np.ndarray) -> Rows:
        assert isinstance(self.part, FiberAsset)
        points = self.part.curves.points
        return np.asarray(points[first + 1] - points[first])

    def _interpolated(self, primitive: np.ndarray, u: np.ndarray, v: np.ndarray) -> Rows:
        """The vertices' harmonics at hits."""
        if isinstance(self.part, FiberAsset):
            first = self.part.curves.segments()[primitive]
            weighted = [(first, 1 - u), (first + 1, u)]
        else:
            a, b, c = self.part.mesh.triangles[primitive].T
            weighted = [(a, 1 - u - v), (b, u), (c, v)]
        mixed = (self._visibility[corner] * weight[:, None] for corner, weight in weighted)
        return np.asarray(sum(mixed), np.float32)


def _unit(v: np.ndarray) -> Rows:
    length = np.maximum(np.linalg.norm(v, axis=1, keepdims=True), 1e-30)
    return np.asarray(v / length, np.float32)

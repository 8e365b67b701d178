"""An asset in a frame of its motion: the light that rays see, and how its surface has moved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rna_bench.one_part import OnePart
from rna_bench.stability.answers import of_package
from rna_sdk.package import Curves, Mesh
from rna_sdk.runtime import DeformedCurves, RestPoints, offset_across
from rna_trace import (
    OFFSET,
    FiberPoints,
    PartPoints,
    PartsScene,
    part_geometry,
    part_transmittance,
)


@dataclass(frozen=True)
class Seen:
    """What rays meet, a row each.

    ray: (n,) int64. element: (n,) int64, number of the triangle or segment. front: (n,) bool,
    whether its outside is seen. position: (n, 3) float32. radiance: (n, 3) float32, ours.
    """

    ray: np.ndarray
    element: np.ndarray
    front: np.ndarray
    position: np.ndarray
    radiance: np.ndarray


class MovedAsset:
    """One part with other positions, (v, 3) float32; rest is its own positions.

    Attributes:
        kind: "surface" or "fiber". radius: of the sphere around it at rest.
    """

    def __init__(self, asset: OnePart, positions: np.ndarray) -> None:
        self._answers, self._shape = of_package(asset), asset.deformed(positions)
        self.kind = asset.kind
        at_rest = _points(part_geometry(asset))
        middle = (at_rest.min(axis=0) + at_rest.max(axis=0)) / 2
        self.radius = float(np.linalg.norm(at_rest - middle, axis=1).max())
        self._rest = part_geometry(asset)
        geometry = part_geometry(asset, self._shape)
        self._scene = PartsScene([geometry], [part_transmittance(asset, self._shape)])
        self._geometry = geometry

    def see(self, origins: np.ndarray, directions: np.ndarray, wi: np.ndarray) -> Seen:
        """Light along rays, (n, 3) float32, from a sun in direction wi, (3,), of irradiance 1."""
        hits = self._scene.intersect(origins, directions)
        ray = np.flatnonzero(hits.geometry >= 0)
        where = hits.primitive[ray], hits.u[ray], hits.v[ray], hits.ng[ray]
        points = self._scene.points(0, *where)
        wo = np.ascontiguousarray(-directions[ray])
        light = np.tile(wi.astype(np.float32), (len(ray), 1))
        lit = self._scene.visible(0, points, light)
        visible, shadowed = self._asked(self._at_rest(*where), points, wo, light)
        share = lit.reshape(len(ray), -1).astype(np.float32)
        radiance = share * visible + (1.0 - share) * shadowed
        front = np.sum(where[3] * wo, axis=1) > 0.0
        return Seen(ray, where[0].astype(np.int64), front, points.x, radiance)

    def _at_rest(
        self, primitive: np.ndarray, u: np.ndarray, v: np.ndarray, normals: np.ndarray
    ) -> RestPoints:
        if isinstance(self._shape, DeformedCurves):
            return self._shape.rest_points(primitive, u, normals)
        return self._shape.rest_points(primitive, u, v)

    def _asked(
        self, rest: RestPoints, points: PartPoints, wo: np.ndarray, wi: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        asked = {"position": rest.positions, "wo": rest.to_rest(wo), "wi": rest.to_rest(wi)}
        if isinstance(points, FiberPoints):
            asked |= {"tangent": rest.axes, "h": offset_across(points.n, points.tangent, wo)}
        else:
            asked["normal"] = rest.axes
        return self._answers(asked)

    def turned_deg(self) -> np.ndarray:
        """How far each element has turned, degrees: (t,)."""
        count = len(self._elements())
        number, third = np.arange(count, dtype=np.int32), np.full(count, 1 / 3, np.float32)
        normals = np.tile(np.array([0.0, 0.0, 1.0], np.float32), (count, 1))
        r = self._at_rest(number, third, third, normals).rotations.astype(np.float64)
        cosine = (np.trace(r, axis1=1, axis2=2) - 1.0) / 2.0
        return np.asarray(np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))))

    def stretch(self) -> np.ndarray:
        """The largest change of length in each element, of longer and shorter: (t,), from 1 on."""
        numbers = self._elements()
        before, now = (_edges(_points(g)[numbers]) for g in (self._rest, self._geometry))
        if numbers.shape[1] == 2:
            ratio = np.linalg.norm(now[:, 0], axis=1) / np.linalg.norm(before[:, 0], axis=1)
            return np.asarray(np.maximum(ratio, 1.0 / np.maximum(ratio, 1e-9)))
        inner = [e @ e.transpose(0, 2, 1) for e in (before, now)]
        squared = np.linalg.eigvals(np.linalg.solve(inner[0], inner[1])).real
        size = np.sqrt(np.maximum(squared, 1e-18))
        return np.asarray(np.maximum(size.max(axis=1), 1.0 / size.min(axis=1)))

    def gaps(self) -> np.ndarray:
        """Room over the middle of each triangle, outside and inside: (2, t), metres."""
        corners = _points(self._geometry)[self._elements()].astype(np.float64)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
        step = 8.0 * OFFSET * self._scene.extent
        found = []
        for side in (normals, -normals):
            start = corners.mean(axis=1) + step * side
            ray = np.ascontiguousarray(start, np.float32), np.ascontiguousarray(side, np.float32)
            found.append(self._scene.intersect(*ray).t)
        return np.stack(found)

    def _elements(self) -> np.ndarray:
        """Numbers of each element's points: (t, 3) of triangles, (t, 2) of segments."""
        if isinstance(self._rest, Curves):
            first = self._rest.segments().astype(np.int64)
            return np.stack([first, first + 1], axis=1)
        return self._rest.triangles.astype(np.int64)


def _points(geometry: Mesh | Curves) -> np.ndarray:
    return geometry.points if isinstance(geometry, Curves) else geometry.positions


def _edges(corners: np.ndarray) -> np.ndarray:
    """(t, k - 1, 3) from the first of k corners to the others."""
    return np.asarray(corners[:, 1:].astype(np.float64) - corners[:, :1])


def joined(seen: Sequence[Seen], rays: Sequence[int]) -> Seen:
    """Those of several images as one; rays: how many each has."""
    first = np.concatenate([[0], np.cumsum(rays)[:-1]])
    return Seen(
        np.concatenate([s.ray + k for s, k in zip(seen, first, strict=True)]),
        *(
            np.concatenate([getattr(s, name) for s in seen])
            for name in ("element", "front", "position", "radiance")
        ),
    )

"""A surface in a frame of its motion: the light that rays see, and how it has moved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rna_bench.stability.answers import of_package
from rna_sdk.runtime import SurfaceAsset
from rna_trace import PartsScene, part_geometry, part_transmittance


@dataclass(frozen=True)
class Seen:
    """What rays meet, a row each.

    ray: (n,) int64. element: (n,) int64, number of the triangle. radiance: (n, 3) float32, ours.
    """

    ray: np.ndarray
    element: np.ndarray
    radiance: np.ndarray


class MovedAsset:
    """One part with other positions, (v, 3) float32; rest is its own positions."""

    def __init__(self, asset: SurfaceAsset, positions: np.ndarray) -> None:
        self._answers, self._shape = of_package(asset), asset.deformed(positions)
        self._triangles = len(asset.mesh.triangles)
        geometry = part_geometry(asset, self._shape)
        self._scene = PartsScene([geometry], [part_transmittance(asset, self._shape)])

    def see(self, origins: np.ndarray, directions: np.ndarray, wi: np.ndarray) -> Seen:
        """Light along rays, (n, 3) float32, from a sun in direction wi, (3,), of irradiance 1."""
        hits = self._scene.intersect(origins, directions)
        ray = np.flatnonzero(hits.part >= 0)
        where = hits.primitive[ray], hits.u[ray], hits.v[ray]
        points = self._scene.points(0, *where, hits.normals[ray])
        rest = self._shape.rest_points(*where)
        wo = np.ascontiguousarray(-directions[ray])
        light = np.tile(wi.astype(np.float32), (len(ray), 1))
        asked = {"position": rest.positions, "normal": rest.axes}
        asked |= {"wo": rest.to_rest(wo), "wi": rest.to_rest(light)}
        visible, shadowed = self._answers(asked)
        share = self._scene.visible(0, points, light).reshape(len(ray), -1).astype(np.float32)
        radiance = share * visible + (1.0 - share) * shadowed
        return Seen(ray, where[0].astype(np.int64), radiance)

    def turned_deg(self) -> np.ndarray:
        """How far each triangle has turned, degrees: (t,)."""
        number = np.arange(self._triangles, dtype=np.int32)
        third = np.full(self._triangles, 1 / 3, np.float32)
        r = self._shape.rest_points(number, third, third).rotations.astype(np.float64)
        cosine = (np.trace(r, axis1=1, axis2=2) - 1.0) / 2.0
        return np.asarray(np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))))


def joined(seen: Sequence[Seen], pixels: int) -> Seen:
    """Those of several images as one; pixels: of each."""
    return Seen(
        np.concatenate([one.ray + k * pixels for k, one in enumerate(seen)]),
        np.concatenate([one.element for one in seen]),
        np.concatenate([one.radiance for one in seen]),
    )

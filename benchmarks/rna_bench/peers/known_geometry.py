"""First hits and shadow rays on a package's geometry, in units of the views' sphere."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_bench.peers.views import Views
from rna_sdk.runtime import load
from rna_trace import FiberPoints, PartsScene, part_geometry, part_normal_maps, part_transmittance


@dataclass(frozen=True)
class Hits:
    """k first hits, float32. row: (k,) of the rays. points, normals, tangents: (k, 3), the last of
    strands alone, else 0. visible: (k,), 1 where the light is seen.
    """

    row: np.ndarray
    points: np.ndarray
    normals: np.ndarray
    tangents: np.ndarray
    visible: np.ndarray


class KnownGeometry:
    """A package's geometry, placed as in views.

    Attributes:
        kinds: of its parts, "surface" and "fiber".
    """

    def __init__(self, package: Path, views: Views):
        parts = load(package, threads=1).parts
        self.kinds = {part.kind for part in parts}
        tables = [part_transmittance(part) for part in parts]
        maps = [part_normal_maps(part) for part in parts]
        self._scene = PartsScene([part_geometry(part) for part in parts], tables, maps)
        self._centre, self._radius = np.array(views.centre), views.radius

    def hits(self, origins: np.ndarray, directions: np.ndarray, lights: np.ndarray) -> Hits:
        """Hits of n rays; origins, directions and lights are (n, 3) float32."""
        starts = self._placed(origins)
        hits = self._scene.intersect(starts, directions)
        normals, tangents = np.zeros_like(directions), np.zeros_like(directions)
        visible = np.zeros(len(directions), np.float32)
        for part in range(len(self._scene.geometries)):
            row = np.flatnonzero(hits.geometry == part)
            if not len(row):
                continue
            at = (a[row] for a in (hits.primitive, hits.u, hits.v, hits.ng))
            points = self._scene.points(part, *at)
            way = self._placed(lights[row]) - points.x
            seen = self._scene.visible(part, points, way, 1.0).astype(np.float32)
            visible[row] = seen if seen.ndim == 1 else seen.mean(axis=1)
            if isinstance(points, FiberPoints):
                normals[row], tangents[row] = points.n, points.tangent
            else:
                normals[row] = points.mapped
        row = np.flatnonzero(hits.geometry >= 0)
        points_at = origins[row] + (hits.t[row] / self._radius)[:, None] * directions[row]
        return Hits(row, points_at.astype(np.float32), normals[row], tangents[row], visible[row])

    def _placed(self, points: np.ndarray) -> np.ndarray:
        """Points of the views' sphere in the package's space, (n, 3) float32."""
        return (self._centre + self._radius * points).astype(np.float32)

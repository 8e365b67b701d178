"""A mesh for ray sampling."""

from collections.abc import Iterator

import numpy as np
import trimesh

from rna_export.capture.capture_settings import SHARPEST
from rna_export.capture.rays.capture_directions import around, reflect
from rna_export.capture.rays.light_samples import WIDEST, LightSamples, surface_lights
from rna_sdk.package import Mesh
from rna_trace import PartPoints, SurfacePoints, geometric_normals


class SurfaceShape:
    """Points, normals and highlights of one mesh.

    sharpest: roughness of the smoothest material whose highlights views are to find.

    Attributes:
        points: (v, 3) float32, corners that the box around the asset is made of.
        area: of all triangles.
    """

    axis = "normal"  # field of a sample

    def __init__(self, mesh: Mesh, sharpest: float = SHARPEST):
        self._mesh, self.points = mesh, mesh.positions
        self._narrowest = sharpest**2  # alpha of GGX
        area = trimesh.triangles.area(mesh.positions[mesh.triangles].astype(np.float64))
        self.area = float(area.sum())
        self._area_cdf = np.cumsum(area) / self.area
        every = np.arange(len(mesh.triangles), dtype=np.int32)
        self._geometric = geometric_normals(mesh.positions, mesh.triangles, every)

    def reach(self, centre: np.ndarray) -> float:
        """Radius of the sphere around `centre` that holds the mesh."""
        return float(np.linalg.norm(self.points - centre, axis=1).max())

    def sample_fields(self, points: PartPoints, _: np.ndarray) -> dict[str, np.ndarray]:
        """Fields of a sample that describe points, without directions."""
        assert isinstance(points, SurfacePoints)
        return {"position": points.x, "normal": points.mapped}

    def sample_points(self, n: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """n points uniform by area and their geometric normals, (n, 3) float32 each."""
        triangle = np.minimum(
            np.searchsorted(self._area_cdf, rng.random(n)), len(self._area_cdf) - 1
        )
        root, v = np.sqrt(rng.random(n)), rng.random(n)
        weights = np.stack([1.0 - root, root * (1.0 - v), root * v], axis=1).astype(np.float32)
        corners = self._mesh.positions[self._mesh.triangles[triangle]]
        return np.einsum("nc,nck->nk", weights, corners), self._geometric[triangle]

    def highlight_views(
        self, points: PartPoints, wi: np.ndarray, rng: np.random.Generator
    ) -> tuple[np.ndarray, np.ndarray]:
        """Mirrors of wi about half vectors of GGX, alpha from the sharpest lobe's to 0.8."""
        assert isinstance(points, SurfacePoints)
        lit = np.flatnonzero(points.mapped @ wi > 0.02)
        width = self._narrowest * (WIDEST / self._narrowest) ** rng.random(len(lit))
        u = rng.random(len(lit))
        cosine = np.sqrt((1.0 - u) / (1.0 + (width**2 - 1.0) * u))
        h = around(points.mapped[lit], cosine, 2.0 * np.pi * rng.random(len(lit)))
        return lit, reflect(np.broadcast_to(wi, h.shape), h)

    def light_samples(
        self, points: PartPoints, wo: np.ndarray, rng: np.random.Generator
    ) -> Iterator[LightSamples]:
        """See `surface_lights`."""
        assert isinstance(points, SurfacePoints)
        return surface_lights(points.mapped, wo, self._narrowest, rng)

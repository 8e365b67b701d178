"""Strands for ray sampling."""

from collections.abc import Iterator

import numpy as np

from rna_export.capture.rays.capture_directions import around
from rna_export.capture.rays.light_samples import LightSamples, fiber_lights
from rna_sdk.package import Curves
from rna_sdk.runtime import offset_across
from rna_trace import FiberPoints, PartPoints, tangents


class FiberShape:
    """Points, normals and highlights of strands.

    Attributes:
        points: (p, 3) float32, corners that the box around the asset is made of.
        area: of all segments.
    """

    axis = "tangent"  # field of a sample

    def __init__(self, curves: Curves):
        self._curves, self.points = curves, curves.points
        self._first = curves.segments()
        root, tip = curves.points[self._first], curves.points[self._first + 1]
        length = np.linalg.norm(tip.astype(np.float64) - root, axis=1)
        area = np.pi * length * (curves.radii[self._first] + curves.radii[self._first + 1])
        self.area = float(area.sum())
        self._area_cdf = np.cumsum(area) / self.area

    def reach(self, centre: np.ndarray) -> float:
        """Radius of the sphere around `centre` that holds the strands."""
        apart = np.linalg.norm(self.points - centre, axis=1) + self._curves.radii
        return float(apart.max())

    def sample_fields(self, points: PartPoints, directions: np.ndarray) -> dict[str, np.ndarray]:
        """Fields of a sample that describe points, without directions.

        h: (k,) float32, offset of the ray, which came along `directions`, from the axis, in radii.
        """
        assert isinstance(points, FiberPoints)
        h = offset_across(points.n, points.tangent, -directions)
        return {"position": points.x, "tangent": points.tangent, "h": h}

    def sample_points(self, n: int, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
        """n points uniform by area and their geometric normals, (n, 3) float32 each."""
        segment = np.minimum(
            np.searchsorted(self._area_cdf, rng.random(n)), len(self._area_cdf) - 1
        )
        first = self._first[segment]
        along = rng.random((n, 1)).astype(np.float32)
        axis = (1.0 - along) * self._curves.points[first] + along * self._curves.points[first + 1]
        radius = (1.0 - along) * self._curves.radii[first, None]
        radius = radius + along * self._curves.radii[first + 1, None]
        tangent = tangents(self._curves.points, self._first, segment.astype(np.int32))
        normals = around(tangent, np.zeros(n), 2.0 * np.pi * rng.random(n))
        return axis + radius * normals, normals

    def highlight_views(
        self, points: PartPoints, wi: np.ndarray, rng: np.random.Generator
    ) -> tuple[np.ndarray, np.ndarray]:
        """About the cone of wi's mirror images (Marschner et al. 2003): all azimuths.

        Inclinations spread by 0.02 to 0.5 in their sine.
        """
        assert isinstance(points, FiberPoints)
        rows = np.arange(len(points))
        spread = 0.02 * 25.0 ** rng.random(len(rows)) * rng.standard_normal(len(rows))
        sine = np.clip(-(points.tangent @ wi) + spread, -0.999, 0.999)
        return rows, around(points.tangent, sine, 2.0 * np.pi * rng.random(len(rows)))

    def light_samples(
        self, points: PartPoints, wo: np.ndarray, rng: np.random.Generator
    ) -> Iterator[LightSamples]:
        """See `fiber_lights`."""
        assert isinstance(points, FiberPoints)
        return fiber_lights(points.tangent, wo, rng)

"""Triangles that shine: a mesh whose material does, and what all such lights have in common."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable

import numpy as np
from numba import prange

from rna_render.lights.base import LightSamples, ShapeLight
from rna_render.lights.directions import flat_pdf
from rna_render.lights.intervals import find_interval, place_within
from rna_render.rays import vectors
from rna_render.tracing import ClosestHits
from rna_sdk.compiled import compiled
from rna_sdk.errors import SceneError

Emission = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


class TriangleLight(ShapeLight):
    """Light from both sides of triangles.

    It chooses a triangle in proportion to its area times its mean luminance, and then a point of
    it uniformly. The triangles stay those of the thing they belong to, which says whether a camera
    sees them.

    positions: (v, 3) float32, world space, or that of the points and directions which
    the light is asked for. triangles: (t, 3) uint32; t may be 0. luminance: (t,)
    float, the mean over each triangle; a triangle of luminance 0 is never chosen.

    Raises SceneError for a luminance that is negative or not finite.
    """

    delta = False

    def __init__(
        self,
        positions: np.ndarray,
        triangles: np.ndarray,
        luminance: np.ndarray,
        group: str = "",
    ) -> None:
        luminance = np.asarray(luminance, np.float64)
        if not (np.isfinite(luminance).all() and (luminance >= 0.0).all()):
            raise SceneError("mesh light: luminance must be finite and not negative")
        self.group = group
        self._corners = np.asarray(positions, np.float64)[triangles]
        edges = self._corners[:, 1:] - self._corners[:, :1]
        normals = np.cross(edges[:, 0], edges[:, 1])
        doubled = np.linalg.norm(normals, axis=1)
        self._normals = normals / np.maximum(doubled, 1e-300)[:, None]
        weights = doubled / 2.0 * luminance
        self._power = 2.0 * np.pi * float(weights.sum())
        total = max(float(weights.sum()), 1e-300)
        self._cumulative = np.concatenate([[0.0], np.cumsum(weights)]) / total
        # Density of points per m^2: probability of the triangle by its area.
        self._per_area = luminance / total

    def power(self, scene_radius: float) -> float:
        return self._power

    def sample(self, x_world: np.ndarray, u: np.ndarray) -> LightSamples:
        x_world = vectors("x_world", x_world)
        n = len(x_world)
        wi_world, triangle = np.zeros((n, 3), np.float32), np.zeros(n, np.int32)
        distance, b1, b2, pdf = (np.zeros(n, np.float32) for _ in range(4))
        if self._power > 0.0:
            mesh = self._corners, self._normals, self._cumulative, self._per_area
            _sample_mesh(*mesh, x_world, u, wi_world, distance, triangle, b1, b2, pdf)
        row = np.flatnonzero(pdf > 0.0)
        radiance = np.zeros((n, 3), np.float32)
        radiance[row] = self._sent(triangle[row], b1[row], b2[row], wi_world.take(row, axis=0))
        return LightSamples(wi_world, distance, radiance, pdf)

    @abstractmethod
    def _sent(
        self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, d_world: np.ndarray
    ) -> np.ndarray:
        """Radiance (n, 3) float32 against d, of what stops a ray along d.

        At barycentrics u, v (n,) float32 of triangles (n,) int32; the point is
        (1 - u - v) p0 + u p1 + v p2, as in ClosestHits. d_world: (n, 3) float32, unit.
        """

    def _density(
        self, x_world: np.ndarray, d_world: np.ndarray, triangle: np.ndarray
    ) -> np.ndarray:
        """Density (n,) float32 per steradian with which `sample` at x finds d on a triangle."""
        x_world = vectors("x_world", x_world)
        d_world = vectors("d_world", d_world, len(x_world))
        pdf = np.empty(len(x_world), np.float32)
        mesh = self._corners, self._normals, self._per_area
        _mesh_pdf(*mesh, x_world, d_world, triangle, pdf)
        return pdf


class MeshLight(TriangleLight):
    """A mesh whose material shines to both sides, as glTF's emission.

    emission: radiance (n, 3) float32 at barycentrics of triangles, as in `MeshObject`.
    opaque_emission: the same times the share of the surface that is there, if rays meet it only
    so often; None where it is opaque. The other arguments are those of TriangleLight; a triangle
    of luminance 0 must not shine anywhere.
    """

    def __init__(
        self,
        positions: np.ndarray,
        triangles: np.ndarray,
        luminance: np.ndarray,
        emission: Emission,
        group: str = "",
        opaque_emission: Emission | None = None,
    ) -> None:
        super().__init__(positions, triangles, luminance, group)
        self._emission = emission
        self._opaque_emission = opaque_emission or emission

    def met(
        self, x_world: np.ndarray, d_world: np.ndarray, hits: ClosestHits, ng_world: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        pdf = self._density(x_world, d_world, hits.primitive)
        radiance = self._emission(hits.primitive, hits.u, hits.v)
        return np.asarray(radiance, np.float32), pdf

    def _sent(
        self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, d_world: np.ndarray
    ) -> np.ndarray:
        return np.asarray(self._opaque_emission(triangle, u, v), np.float32)


@compiled(fastmath=())
def _triangle_pdf(corners, normals, per_area, triangle, x, d):
    """Density of the direction d from x of points on either side of a triangle."""
    return flat_pdf(corners[triangle, 0], normals[triangle], True, per_area[triangle], x, d)


@compiled(parallel=True, fastmath=())
def _sample_mesh(
    corners, normals, cumulative, per_area, x_world, u, wi_world, distance, triangle, b1, b2, pdf
):
    for i in prange(len(x_world)):
        value = u[i, 0] * cumulative[-1]
        chosen = find_interval(cumulative, value)
        place = place_within(cumulative, chosen, value)
        # Uniform over a triangle: Shirley, Wang and Zimmerman, Monte Carlo Techniques for Direct
        # Lighting Calculations (TOG 15(1), 1996), section 3.2.
        root = np.sqrt(place)
        first, second = root * (1.0 - u[i, 1]), root * u[i, 1]
        p0, p1, p2 = corners[chosen, 0], corners[chosen, 1], corners[chosen, 2]
        dx = p0[0] + first * (p1[0] - p0[0]) + second * (p2[0] - p0[0]) - x_world[i, 0]
        dy = p0[1] + first * (p1[1] - p0[1]) + second * (p2[1] - p0[1]) - x_world[i, 1]
        dz = p0[2] + first * (p1[2] - p0[2]) + second * (p2[2] - p0[2]) - x_world[i, 2]
        r = np.sqrt(dx * dx + dy * dy + dz * dz)
        scale = 1.0 / r if r > 0.0 else 0.0
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = dx * scale, dy * scale, dz * scale
        distance[i], triangle[i], b1[i], b2[i] = r, chosen, first, second
        pdf[i] = _triangle_pdf(corners, normals, per_area, chosen, x_world[i], wi_world[i])


@compiled(parallel=True, fastmath=())
def _mesh_pdf(corners, normals, per_area, x_world, d_world, primitive, pdf):
    for i in prange(len(x_world)):
        pdf[i] = _triangle_pdf(corners, normals, per_area, primitive[i], x_world[i], d_world[i])

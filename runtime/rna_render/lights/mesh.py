"""Triangles that shine: a mesh whose material does, and what all such lights have in common."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable

import numpy as np
from numba import carray, prange  # type: ignore[attr-defined]

from rna_render.lights.base import ShapeLight
from rna_render.lights.directions import Axes, flat_pdf
from rna_render.lights.intervals import find_interval, place_within
from rna_render.lights.kinds import TRIANGLES, LightRow, light_row, row_places
from rna_sdk.compiled import compiled
from rna_sdk.errors import SceneError
from rna_trace.embree.tracing import ClosestHits
from rna_trace.memory import pointer_f64, signed
from rna_trace.rays import vectors
from rna_trace.vectors import Vector

_ROTATION, _PLACE, _SCALE = (
    row_places("triangles")[name] for name in ("rotation", "place", "scale")
)
# Of a row's words: addresses of arrays of float64, and the number of triangles.
_CORNERS, _NORMALS, _CUMULATIVE, _PER_AREA, _COUNT = range(5)

Emission = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


class TriangleLight(ShapeLight):
    """Light from both sides of triangles.

    It chooses a triangle in proportion to its area times its mean luminance, and then a point of
    it uniformly. The triangles stay those of the object they belong to, which says whether a camera
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
        self.row = self.placed_row(np.eye(3), np.zeros(3), 1.0)

    def power(self, scene_radius: float) -> float:
        return self._power

    @property
    def cumulative(self) -> np.ndarray:
        """(t + 1,) float64 running shares of the triangles; (0,) where none sends light."""
        return self._cumulative if self._power > 0.0 else self._cumulative[:0]

    def placed_row(self, rotation: np.ndarray, place: np.ndarray, scale: float) -> LightRow:
        """The row of the same triangles elsewhere: scaled, then rotated, then moved."""
        arrays = self._corners, self._normals, self._cumulative, self._per_area
        addresses = [array.ctypes.data for array in arrays]
        count = len(self._corners) if len(self.cumulative) else 0
        words = [*addresses, count]
        at = {"rotation": rotation, "place": place, "scale": scale}
        return light_row(TRIANGLES, np.ones(3), words, **at)

    def sent(self, place: np.ndarray, d_world: np.ndarray) -> np.ndarray:
        u, v = place[:, 1].astype(np.float32), place[:, 2].astype(np.float32)
        return self._sent(place[:, 0].astype(np.int32), u, v, d_world)

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

    factor = 1.0

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

    def eval_hit(
        self, x_world: np.ndarray, d_world: np.ndarray, hits: ClosestHits, ng_world: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        pdf = self._density(x_world, d_world, hits.primitive)
        radiance = self._emission(hits.primitive, hits.u, hits.v)
        return np.ascontiguousarray(radiance, np.float32), pdf

    def _sent(
        self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, d_world: np.ndarray
    ) -> np.ndarray:
        return np.asarray(self._opaque_emission(triangle, u, v), np.float32)


@compiled(fastmath=())
def _triangle_pdf(
    corners: np.ndarray, normals: np.ndarray, per_area: np.ndarray, triangle: int, x: Axes, d: Axes
) -> float:
    """Density of the direction d from x of points on either side of a triangle."""
    return flat_pdf(corners[triangle, 0], normals[triangle], True, per_area[triangle], x, d)


@compiled(fastmath=())
def sample_triangles(
    numbers: np.ndarray, words: np.ndarray, x: Vector, u1: float, u2: float
) -> tuple[Vector, float, float, Vector]:
    """Direction, distance, density, and triangle with barycentrics as three float64."""
    count = signed(words[_COUNT])
    if count == 0:
        return (0.0, 0.0, 0.0), 0.0, 0.0, (0.0, 0.0, 0.0)
    corners = carray(pointer_f64(words[_CORNERS]), (count, 3, 3))
    normals = carray(pointer_f64(words[_NORMALS]), (count, 3))
    cumulative = carray(pointer_f64(words[_CUMULATIVE]), (count + 1,))
    per_area = carray(pointer_f64(words[_PER_AREA]), (count,))
    rotation = numbers[_ROTATION : _ROTATION + 9].reshape(3, 3)
    place, scale = numbers[_PLACE : _PLACE + 3], numbers[_SCALE]
    moved = (x[0] - place[0]) / scale, (x[1] - place[1]) / scale, (x[2] - place[2]) / scale
    x = _turned(rotation.T, moved)
    value = u1 * cumulative[-1]
    chosen = find_interval(cumulative, value)
    # Uniform over a triangle: Shirley, Wang and Zimmerman, Monte Carlo Techniques for Direct
    # Lighting Calculations (TOG 15(1), 1996), section 3.2.
    root = np.sqrt(place_within(cumulative, chosen, value))
    first, second = root * (1.0 - u2), root * u2
    p0, p1, p2 = corners[chosen, 0], corners[chosen, 1], corners[chosen, 2]
    dx = p0[0] + first * (p1[0] - p0[0]) + second * (p2[0] - p0[0]) - x[0]
    dy = p0[1] + first * (p1[1] - p0[1]) + second * (p2[1] - p0[1]) - x[1]
    dz = p0[2] + first * (p1[2] - p0[2]) + second * (p2[2] - p0[2]) - x[2]
    r = np.sqrt(dx * dx + dy * dy + dz * dz)
    inverse = 1.0 / r if r > 0.0 else 0.0
    wi = dx * inverse, dy * inverse, dz * inverse
    pdf = _triangle_pdf(corners, normals, per_area, chosen, x, wi)
    return _turned(rotation, wi), r * scale, pdf, (np.float64(chosen), first, second)


@compiled(fastmath=())
def _turned(m: np.ndarray, v: Vector) -> Vector:
    return (
        m[0, 0] * v[0] + m[0, 1] * v[1] + m[0, 2] * v[2],
        m[1, 0] * v[0] + m[1, 1] * v[1] + m[1, 2] * v[2],
        m[2, 0] * v[0] + m[2, 1] * v[1] + m[2, 2] * v[2],
    )


@compiled(parallel=True, fastmath=())
def _mesh_pdf(
    corners: np.ndarray,
    normals: np.ndarray,
    per_area: np.ndarray,
    x_world: np.ndarray,
    d_world: np.ndarray,
    primitive: np.ndarray,
    pdf: np.ndarray,
) -> None:
    for i in prange(len(x_world)):
        pdf[i] = _triangle_pdf(corners, normals, per_area, primitive[i], x_world[i], d_world[i])

"""Triangles that shine: a mesh with an emissive material, and the base of all such lights."""

from abc import abstractmethod
from collections.abc import Callable

import numpy as np

from rna_render.lights.base import LightSamples, ShapeLight, light_numbers
from rna_render.lights.directions import Axes, flat_pdf
from rna_render.lights.intervals import find_interval, place_within
from rna_sdk.arrays import vectors
from rna_sdk.errors import SceneError
from rna_sdk.machine.compiled import compiled
from rna_trace.embree.tracing import ClosestHits
from rna_trace.vectors import Vector, vector_at

Emission = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


class TriangleLight(ShapeLight):
    """Light from both sides of triangles.

    It chooses a triangle in proportion to its area times its mean luminance, and then a point of
    it uniformly. The triangles stay those of the object they belong to, which says whether a camera
    sees them.

    positions: (v, 3) float32, world space, or the space of the points and directions which
    the light is asked for. triangles: (t, 3) uint32; t may be 0. luminance: (t,)
    float, the mean over each triangle; a triangle of luminance 0 is never chosen.

    Raises SceneError for a luminance that is negative or not finite.
    """

    kind = "triangles"
    NUMBERS = light_numbers(("rotation", (3, 3)), ("place", 3), ("scale", ()))

    def __init__(
        self, positions: np.ndarray, triangles: np.ndarray, luminance: np.ndarray, group: str = ""
    ) -> None:
        super().__init__(group, colour=1.0, rotation=np.eye(3), scale=1.0)
        luminance = np.asarray(luminance, np.float64)
        if not (np.isfinite(luminance).all() and (luminance >= 0.0).all()):
            raise SceneError("mesh light: luminance must be finite and not negative")
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

    @property
    def cumulative(self) -> np.ndarray:
        """(t + 1,) float64 running shares of the triangles; (0,) where none sends light."""
        return self._cumulative if self._power > 0.0 else self._cumulative[:0]

    def _fill(self, x_world: np.ndarray, u: np.ndarray, samples: LightSamples) -> None:
        place = self.fill_directions(self.numbers, x_world, u, samples)
        samples.radiance[:] = self.sent(place, samples.wi_world)

    def fill_directions(
        self, numbers: np.ndarray, x_world: np.ndarray, u: np.ndarray, samples: LightSamples
    ) -> np.ndarray:
        """Fill in all but the radiance of samples of these triangles elsewhere: scaled, then
        rotated, then moved, as the numbers say.

        Returns (n, 3) float64: triangle and barycentrics of their points, for `sent`.
        """
        place = np.zeros((len(x_world), 3))
        if len(self.cumulative):
            _sample(
                numbers,
                self._corners,
                self._normals,
                self._cumulative,
                self._per_area,
                x_world,
                u,
                samples.wi_world,
                samples.distance,
                samples.pdf,
                place,
            )
        return place

    def sent(self, place: np.ndarray, d_world: np.ndarray) -> np.ndarray:
        """Radiance (n, 3) float32 against d, (n, 3) float32, of the hits that stop rays along d.

        place: see `fill_directions`.
        """
        u, v = place[:, 1].astype(np.float32), place[:, 2].astype(np.float32)
        return self._sent(place[:, 0].astype(np.int32), u, v, d_world)

    @abstractmethod
    def _sent(
        self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, d_world: np.ndarray
    ) -> np.ndarray:
        """Radiance (n, 3) float32 against d, of the hit that stops a ray along d.

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
        _mesh_pdf(self._corners, self._normals, self._per_area, x_world, d_world, triangle, pdf)
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
def _sample(
    numbers: np.ndarray,
    corners: np.ndarray,
    normals: np.ndarray,
    cumulative: np.ndarray,
    per_area: np.ndarray,
    x_world: np.ndarray,
    u: np.ndarray,
    wi_world: np.ndarray,
    distance: np.ndarray,
    pdf: np.ndarray,
    place: np.ndarray,
) -> None:
    light = numbers[0]
    rotation, origin, scale = light.rotation, light.place, light.scale
    for i in range(len(x_world)):
        x = vector_at(x_world, i)
        moved = (x[0] - origin[0]) / scale, (x[1] - origin[1]) / scale, (x[2] - origin[2]) / scale
        x = _turned(rotation.T, moved)
        value = u[i, 0] * cumulative[-1]
        chosen = find_interval(cumulative, value)
        # Uniform over a triangle: Shirley, Wang and Zimmerman, Monte Carlo Techniques for Direct
        # Lighting Calculations (TOG 15(1), 1996), section 3.2.
        root = np.sqrt(place_within(cumulative, chosen, value))
        first, second = root * (1.0 - u[i, 1]), root * u[i, 1]
        p0, p1, p2 = corners[chosen, 0], corners[chosen, 1], corners[chosen, 2]
        dx = p0[0] + first * (p1[0] - p0[0]) + second * (p2[0] - p0[0]) - x[0]
        dy = p0[1] + first * (p1[1] - p0[1]) + second * (p2[1] - p0[1]) - x[1]
        dz = p0[2] + first * (p1[2] - p0[2]) + second * (p2[2] - p0[2]) - x[2]
        r = np.sqrt(dx * dx + dy * dy + dz * dz)
        inverse = 1.0 / r if r > 0.0 else 0.0
        wi = dx * inverse, dy * inverse, dz * inverse
        pdf[i] = _triangle_pdf(corners, normals, per_area, chosen, x, wi)
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = _turned(rotation, wi)
        distance[i] = r * scale
        place[i, 0], place[i, 1], place[i, 2] = chosen, first, second


@compiled(fastmath=())
def _turned(m: np.ndarray, v: Vector) -> Vector:
    return (
        m[0, 0] * v[0] + m[0, 1] * v[1] + m[0, 2] * v[2],
        m[1, 0] * v[0] + m[1, 1] * v[1] + m[1, 2] * v[2],
        m[2, 0] * v[0] + m[2, 1] * v[1] + m[2, 2] * v[2],
    )


@compiled(rows="x_world d_world primitive pdf", fastmath=())
def _mesh_pdf(
    corners: np.ndarray,
    normals: np.ndarray,
    per_area: np.ndarray,
    x_world: np.ndarray,
    d_world: np.ndarray,
    primitive: np.ndarray,
    pdf: np.ndarray,
) -> None:
    for i in range(len(x_world)):
        pdf[i] = _triangle_pdf(corners, normals, per_area, primitive[i], x_world[i], d_world[i])

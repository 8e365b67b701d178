"""The emission of an asset, as a light of the scene."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from rna_render.lights.base import LightSamples, ShapeLight
from rna_render.lights.directions import luminance
from rna_render.lights.kinds.mesh import TriangleLight
from rna_render.materials.mesh_object import EMISSION_FLOOR, points_of_a_triangle
from rna_sdk.arrays import vectors
from rna_sdk.package import Curves
from rna_sdk.runtime import (
    Asset,
    DeformedCurves,
    DeformedMesh,
    FiberAsset,
    SurfaceAsset,
    Transform,
    offset_across,
)
from rna_trace.asset_parts import (
    Shape,
    part_geometry,
    part_mesh,
    part_normal_maps,
    part_transmittance,
    shaped_parts,
)
from rna_trace.embree.tracing import ClosestHits
from rna_trace.fiber import FiberPoints
from rna_trace.surface import SurfacePoints, geometric_normals, interpolate_normals
from rna_trace.transmittance import Transmittance

# Emission is evaluated at so many points at least of a part's mesh, in as many equal parts of each
# triangle as that takes, but no more than the square of the second number.
_POINTS, _DIVISIONS = 20_000, 8

# Cosines to the normal of the directions that it is asked for, on either side: in the middle of
# halves of a cosine-weighted hemisphere. Azimuths go on by the golden angle.
_COSINES = np.sqrt([0.75, 0.25])
_GOLDEN = np.pi * (3.0 - np.sqrt(5.0))


class AssetEmission(TriangleLight):
    """The emission of an asset, in its object space; its instances share it.

    The triangles of its parts are sampled by what they send out on average, a share of the samples
    by area alone. Strands are found by rays that meet them. shapes: of its parts in motion. Raises
    SceneError for emission that is not finite.
    """

    def __init__(self, asset: Asset, shapes: Sequence[Shape] | None = None) -> None:
        pairs = enumerate(shaped_parts(asset, shapes))
        self._parts = {k: (part, shape) for k, (part, shape) in pairs if part.emits}
        self._meshes = {
            k: _MeshEmitter(part, shape)
            for k, (part, shape) in self._parts.items()
            if part.kind == "surface"
        }
        counts = [len(mesh.mesh.triangles) for mesh in self._meshes.values()]
        self._cuts = np.cumsum([0, *counts])
        self._first = dict(zip(self._meshes, self._cuts[:-1].tolist(), strict=True))
        mean = [mesh.mean_luminance() for mesh in self._meshes.values()]
        super().__init__(*_joined(list(self._meshes.values())), np.concatenate([[], *mean]))

    def eval_hit(
        self, x_world: np.ndarray, d_world: np.ndarray, hits: ClosestHits, ng_world: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        radiance, pdf = np.zeros_like(x_world), np.zeros(len(x_world), np.float32)
        for k, (part, shape) in self._parts.items():
            row = np.flatnonzero(hits.geometry == k)
            at, wo = hits.take(row), -d_world[row]
            if part.kind == "fiber":
                radiance[row] = _strand_emission(part, shape, at, ng_world[row], wo)
                continue
            radiance[row] = self._meshes[k].emission(at.primitive, at.u, at.v, wo)
            triangle = at.primitive + np.int32(self._first[k])
            pdf[row] = self._density(x_world[row], d_world[row], triangle)
        return radiance, pdf

    def _sent(
        self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, d_world: np.ndarray
    ) -> np.ndarray:
        result = np.zeros_like(d_world)
        for mesh, (start, stop) in zip(self._meshes.values(), pairwise(self._cuts), strict=True):
            row = np.flatnonzero((triangle >= start) & (triangle < stop))
            own, wo = triangle[row] - np.int32(start), -d_world[row]
            emitted = mesh.emission(own, u[row], v[row], wo)
            result[row] = emitted * mesh.opacity(own, u[row], v[row], wo)
        return result


class AssetLight(ShapeLight):
    """The emission of one instance of an asset.

    world_from_object: (4, 4), a similarity. Raises QueryError for another matrix.

    Attributes:
        factor: on all that it emits.
    """

    kind = TriangleLight.kind
    NUMBERS = TriangleLight.NUMBERS

    def __init__(
        self, emission: AssetEmission, world_from_object: np.ndarray, factor: float = 1.0
    ) -> None:
        self._emission, self.factor = emission, np.float32(factor)
        transform = Transform(world_from_object)
        self._scale, self._place = np.float32(transform.scale), transform.matrix[:3, 3]
        rotation = transform.matrix[:3, :3] / transform.scale
        self._rotation = rotation.astype(np.float32)
        at = {"rotation": rotation, "place": self._place, "scale": transform.scale}
        super().__init__("", colour=1.0, **at)

    def power(self, scene_radius: float) -> float:
        size = scene_radius / float(self._scale)
        return float(self.factor * self._scale**2) * self._emission.power(size)

    @property
    def cumulative(self) -> np.ndarray:
        """Cumulative power of the triangles of AssetEmission."""
        return self._emission.cumulative

    def _fill(self, x_world: np.ndarray, u: np.ndarray, samples: LightSamples) -> None:
        place = self._emission.fill_directions(self.numbers, x_world, u, samples)
        sent = self._emission.sent(place, samples.wi_world @ self._rotation)
        samples.radiance[:] = self.factor * sent

    def eval_hit(
        self, x_world: np.ndarray, d_world: np.ndarray, hits: ClosestHits, ng_world: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        moved = vectors("x_world", x_world) - self._place
        radiance, pdf = self._emission.eval_hit(
            x_world=((moved @ self._rotation) / self._scale).astype(np.float32),
            d_world=d_world @ self._rotation,
            hits=hits,
            ng_world=hits.ng,
        )
        return self.factor * radiance, pdf


class _MeshEmitter:
    """A part with a mesh. wo: (n, 3) float32, unit, object space; the rest as in ClosestHits."""

    def __init__(self, part: SurfaceAsset, shape: Shape | None) -> None:
        self.part, self.mesh = part, part_mesh(part, shape)
        self._shape = shape if isinstance(shape, DeformedMesh) else None
        self._transmittance: Transmittance | None = part_transmittance(part, shape)
        self._normal_maps = part_normal_maps(part)

    def emission(
        self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, wo: np.ndarray
    ) -> np.ndarray:
        """Radiance of the opaque share towards wo: (n, 3) float32."""
        maps = self._normal_maps
        if self._shape is None:
            points = SurfacePoints.of(self.mesh, triangle, u, v, maps)
            return self.part.emission(points.x, points.mapped, wo)
        rest = self._shape.rest_points(triangle, u, v)
        n = rest.axes if maps is None else maps.at(rest.axes, triangle, u, v)
        return self.part.emission(rest.positions, n, rest.to_rest(wo))

    def opacity(
        self, triangle: np.ndarray, u: np.ndarray, v: np.ndarray, wo: np.ndarray
    ) -> np.ndarray:
        """The opaque share: (n, 3) float32, or (1, 1) if it is 1 everywhere."""
        if self._transmittance is None:
            return np.ones((1, 1), np.float32)
        mesh = self.mesh
        ng = geometric_normals(mesh.positions, mesh.triangles, triangle)
        facing = np.sum(ng * wo, axis=1) > 0.0
        return np.float32(1.0) - self._transmittance.at(triangle, u, v, -wo, facing)

    def mean_luminance(self) -> np.ndarray:
        """About the mean luminance over each triangle and all directions: (t,) float64.

        More than 0 on all triangles, unless it is 0 at every point that is asked.
        """
        mesh = self.mesh
        count = len(mesh.triangles)
        triangle = np.arange(count, dtype=np.int32)
        divisions = int(np.clip(np.ceil(np.sqrt(_POINTS / max(count, 1))), 1, _DIVISIONS))
        points = points_of_a_triangle(divisions)
        result = np.zeros(count)
        for k, (u, v) in enumerate(points):
            b1, b2 = np.full(count, u, np.float32), np.full(count, v, np.float32)
            normals = interpolate_normals(mesh.normals, mesh.triangles, triangle, b1, b2)
            for j, cosine in enumerate((*_COSINES, *-_COSINES)):
                azimuth = _GOLDEN * (triangle + count * (4 * k + j))
                wo = _about(normals, cosine, azimuth)
                emitted = self.emission(triangle, b1, b2, wo)
                result += luminance(emitted * self.opacity(triangle, b1, b2, wo))
        result /= 4.0 * len(points)
        floor = result.mean() if count else 0.0
        return (1.0 - EMISSION_FLOOR) * result + EMISSION_FLOOR * floor


def _joined(meshes: list[_MeshEmitter]) -> tuple[np.ndarray, np.ndarray]:
    """The meshes as one: (v, 3) float32 and (t, 3) uint32."""
    starts = np.cumsum([0, *(len(mesh.mesh.positions) for mesh in meshes)])
    positions = [np.zeros((0, 3), np.float32), *(mesh.mesh.positions for mesh in meshes)]
    triangles = [mesh.mesh.triangles for mesh in meshes]
    shifted = [rows + np.uint32(s) for rows, s in zip(triangles, starts[:-1], strict=True)]
    return np.concatenate(positions), np.concatenate([np.zeros((0, 3), np.uint32), *shifted])


def _strand_emission(
    part: FiberAsset, shape: Shape | None, hits: ClosestHits, n: np.ndarray, wo: np.ndarray
) -> np.ndarray:
    """Radiance of strands towards wo: (n, 3) float32. n: outward normals; object space."""
    curves = part_geometry(part, shape)
    assert isinstance(curves, Curves)
    at = FiberPoints.of(curves, curves.segments(), hits.primitive, hits.u, n)
    h = offset_across(n, at.tangent, wo)
    if not isinstance(shape, DeformedCurves):
        return part.emission(at.x, at.tangent, h, wo)
    rest = shape.rest_points(hits.primitive, hits.u, n)
    return part.emission(rest.positions, rest.axes, h, rest.to_rest(wo))


def _about(axis: np.ndarray, cosine: float, azimuth: np.ndarray) -> np.ndarray:
    """Unit directions (n, 3) float32 at that cosine to axes (n, 3), at azimuths (n,)."""
    across = np.eye(3)[np.argmin(np.abs(axis), axis=1)]
    side = np.cross(axis, across)
    side /= np.maximum(np.linalg.norm(side, axis=1, keepdims=True), 1e-30)
    turned = np.cross(axis, side)
    sine = np.sqrt(1.0 - cosine * cosine)
    around = np.cos(azimuth)[:, None] * side + np.sin(azimuth)[:, None] * turned
    return np.asarray(cosine * axis + sine * around, np.float32)

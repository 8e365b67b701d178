"""Rays through solid glass: at each interface reflected or refracted, as often as light is.

Smooth interfaces scatter into single directions, so nothing is sampled there, and no shadow ray
passes: light that comes through glass is what rays find behind it. `docs/scene.md` says so.
"""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from rna_render.materials import MeshObject
from rna_render.materials.refraction import fresnel, reflected, refracted
from rna_render.paths.sampling import Sampler
from rna_render.world.world import World
from rna_trace.embree.instances import INDIRECT_RAY
from rna_trace.embree.tracing import ClosestHits
from rna_trace.hit_points import hit_points, stepped
from rna_trace.surface import interpolate_normals

MOST_INTERFACES = 24
_DIMENSION = 1 << 20  # of random numbers: beyond those of the points of any path


class Followed(NamedTuple):
    """Rays from the last interface that they met, or from their beginning.

    origin, direction: (n, 3) float32, world space. hits: of no glass; their weight has what is left
    by all interfaces and by absorption. bent: (n,) bool, which have met glass.
    """

    origin: np.ndarray
    direction: np.ndarray
    hits: ClosestHits
    bent: np.ndarray


@dataclass(frozen=True, slots=True)
class _Interfaces:
    """Where k rays meet glass: points, shading and geometric normals, (k, 3), world space.

    ior: (k,). tint: (k, 3), of each passage. absorption: (k, 3), of the inside, per world unit.
    step: (k,) float32, off the interface, where rays start.
    """

    x: np.ndarray
    n: np.ndarray
    ng: np.ndarray
    ior: np.ndarray
    tint: np.ndarray
    absorption: np.ndarray
    step: np.ndarray


class _Rays(NamedTuple):
    """Rays that are followed: (n, 3) each; inside: absorption where they are."""

    origin: np.ndarray
    direction: np.ndarray
    hits: ClosestHits
    weight: np.ndarray
    inside: np.ndarray


class SolidGlass:
    """The solid glass of a world."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._meshes = {
            number: placement.object
            for number, placement in enumerate(world.placements)
            if isinstance(placement.object, MeshObject) and placement.object.has_solid_glass
        }

    def __bool__(self) -> bool:
        return bool(self._meshes)

    def follow(
        self,
        origin: np.ndarray,
        direction: np.ndarray,
        hits: ClosestHits,
        sampler: Sampler,
        pixels: np.ndarray,
        number: np.ndarray,
        depth: int,
    ) -> Followed:
        """The rays behind all glass. Arrays that are given are changed.

        hits: of n rays. pixels, number: (n,), see PathNumbers. depth: of the point where they
        start, 0 for the camera.
        """
        bent = np.zeros(len(origin), bool)
        weight = np.ones((len(origin), 3), np.float32) if hits.weight is None else hits.weight
        rays = _Rays(origin, direction, hits, weight, inside=np.zeros((len(origin), 3)))
        row = self._on_glass(hits, np.arange(len(origin)))
        for k in range(MOST_INTERFACES):
            if not len(row):
                break
            bent[row] = True
            at = self._interfaces(rays, row)
            dimension = _DIMENSION + depth * MOST_INTERFACES + k
            u = sampler.square(pixels[row], dimension, number=number[row])[:, 0]
            self._pass(at, row, u, rays)
            row = self._on_glass(hits, row)
        hits.instance[row] = -1
        weight[row] = 0.0
        ends = np.flatnonzero(bent & np.isfinite(hits.t) & rays.inside.any(axis=1))
        weight[ends] *= np.exp(-rays.inside[ends] * hits.t[ends, None])
        return Followed(origin, direction, replace(hits, weight=weight), bent)

    def _pass(self, at: _Interfaces, row: np.ndarray, u: np.ndarray, rays: _Rays) -> None:
        """Take the rays of the rows to their hits behind an interface, in place."""
        origin, direction, hits, weight, inside = rays
        d = direction[row].astype(np.float64)
        enters = np.sum(d * at.ng, axis=1) < 0.0
        # A ray that began inside leaves what it was not known to be in.
        medium = np.where((~enters & ~inside[row].any(axis=1))[:, None], at.absorption, inside[row])
        weight[row] *= np.exp(-medium * hits.t[row, None])
        side = np.where(enters, 1.0, -1.0)[:, None]
        ng, n = side * at.ng, side * at.n
        grazing = np.sum(d * n, axis=1) > -1e-4
        n = np.where(grazing[:, None], ng, n)
        eta = np.where(enters, at.ior, 1.0 / at.ior)
        passes = u >= fresnel(np.clip(-np.sum(d * n, axis=1), 0.0, 1.0), eta)
        out = _on_its_side(reflected(d, n), reflected(d, ng), ng)
        out[passes] = refracted(d, n, eta)[passes]
        weight[row[passes]] *= at.tint[passes]
        change = np.where(enters, 1.0, -1.0)[:, None] * at.absorption
        inside[row] = np.where(passes[:, None], np.maximum(medium + change, 0.0), medium)
        direction[row] = out
        origin[row] = stepped(at.x, at.ng, at.step, direction[row])
        behind = self._world.scene.intersect(origin[row], direction[row], rays=INDIRECT_RAY)
        for name in ("t", "instance", "geometry", "primitive", "u", "v", "ng"):
            getattr(hits, name)[row] = getattr(behind, name)
        if behind.weight is not None:
            weight[row] *= behind.weight

    def _on_glass(self, hits: ClosestHits, row: np.ndarray) -> np.ndarray:
        """Rows that meet solid glass."""
        met = np.zeros(len(row), bool)
        for number, mesh in self._meshes.items():
            here = np.flatnonzero(hits.instance[row] == number)
            met[here] = mesh.solid_ior[mesh.material_numbers[hits.primitive[row[here]]]] > 0.0
        return row[met]

    def _interfaces(self, rays: _Rays, row: np.ndarray) -> _Interfaces:
        world, count, hits = self._world, len(row), rays.hits
        x, n = np.empty((count, 3), np.float32), np.empty((count, 3), np.float32)
        ior, tint, absorption = np.empty(count), np.empty((count, 3)), np.empty((count, 3))
        step, instance = np.empty(count, np.float32), hits.instance[row]
        lines = world.lines(instance, rays.origin[row], rays.direction[row])
        for number, mesh in self._meshes.items():
            here = np.flatnonzero(instance == number)
            where = (values[row[here]] for values in (hits.primitive, hits.u, hits.v))
            triangle, u, v = where
            at = hit_points(mesh.positions, mesh.triangles, triangle, u, v, lines.rows(here))
            x[here], step[here] = at.x_world, at.step
            n[here] = interpolate_normals(mesh.normals, mesh.triangles, triangle, at.u, at.v)
            material = mesh.material_numbers[triangle]
            ior[here], tint[here] = mesh.solid_ior[material], mesh.solid_tint[material]
            absorption[here] = mesh.solid_absorption[material] / world.scale[number]
        ng = world.to_world_directions(instance, hits.ng[row])
        n = world.to_world_directions(instance, n)
        n = np.where(np.sum(n * ng, axis=1, keepdims=True) <= 0.0, ng, n)
        return _Interfaces(x, n, ng, ior, tint, absorption, step)


def _on_its_side(out: np.ndarray, otherwise: np.ndarray, ng: np.ndarray) -> np.ndarray:
    """Directions that leave the surface on the side of ng; `otherwise` where they do not."""
    return np.where(np.sum(out * ng, axis=1, keepdims=True) > 0.0, out, otherwise)

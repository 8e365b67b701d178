"""Light that a mesh sends along given rays, lit directly from one direction each."""

import numpy as np

from rna_render.materials import MeshObject
from rna_render.world.placements import Placement
from rna_render.world.world import World
from rna_trace.embree.instances import CAMERA_RAY
from rna_trace.points import Role


class DirectLight:
    """Light on one mesh, with its own shadows and what its materials let through."""

    def __init__(self, mesh: MeshObject) -> None:
        self._world = World([Placement(mesh, np.eye(4))])

    def radiance(self, x: np.ndarray, wo: np.ndarray, wi: np.ndarray) -> np.ndarray:
        """What comes along rays from outside through x to -wo, (n, 3) float32; 0 for a miss.

        x, wo, wi: (n, 3) float32; wo, wi unit, towards the viewer and the light, which has
        irradiance 1.
        """
        world, result = self._world, np.zeros_like(x)
        if not len(x):
            return result
        origin = x + np.float32(2.0 * world.radius + np.abs(x).max()) * wo
        hits = world.scene.intersect(origin, -wo, rays=CAMERA_RAY)
        at = world.vertices(Role.SCATTER, hits, origin, -wo, seen=True)
        wi, every = wi.take(at.ray, axis=0), np.arange(len(at))
        endless = np.full(len(at), np.inf, np.float32)
        light = world.scene.transmittance(world.origins(at, every, wi), wi, endless)
        for rows, place, points in at.local_rows(every):
            sent, _ = points.transport(place, wi[rows], endless[rows], None)
            result[at.ray[rows]] = sent * light[rows]
        return result if hits.weight is None else result * hits.weight

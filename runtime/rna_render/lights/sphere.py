"""A sphere that sends light outwards."""

from __future__ import annotations

import numpy as np
from numba import prange

from rna_render.embree import SphereScene
from rna_render.lights.area import AreaLight
from rna_render.lights.directions import cone_direction
from rna_render.lights.models import SphereModel
from rna_sdk.compiled import compiled


class SphereLight(AreaLight):
    """Sampled uniformly over the cone of directions that it fills; dark from within."""

    def __init__(self, model: SphereModel) -> None:
        super().__init__(model, 4.0 * np.pi * model.radius**2)
        self._radius = model.radius
        self._centre = np.asarray(model.position, np.float64)
        self.world_from_object = np.eye(4)
        self.world_from_object[:3, 3] = model.position
        self.scene = SphereScene(np.zeros((1, 3), np.float32), np.float32([model.radius]))

    def _sample(self, x_world, u, wi_world, distance, pdf) -> None:
        _sample_sphere(self._centre, self._radius, x_world, u, wi_world, distance, pdf)

    def _pdf(self, x_world, d_world, pdf) -> None:
        _sphere_pdf(self._centre, self._radius, x_world, pdf)


@compiled(fastmath=())
def _cone(centre, radius, x):
    """Vector from x to the centre, its length, and 1 - cos of the sphere's angular radius.

    The last is 0 where x is inside or on the sphere.
    """
    cx, cy, cz = centre[0] - x[0], centre[1] - x[1], centre[2] - x[2]
    squared = cx * cx + cy * cy + cz * cz
    if not squared > radius * radius:
        return cx, cy, cz, 0.0, 0.0
    sin2 = radius * radius / squared
    return cx, cy, cz, np.sqrt(squared), sin2 / (1.0 + np.sqrt(1.0 - sin2))


@compiled(fastmath=())
def _cone_pdf(one_minus_cosine):
    return 1.0 / (2.0 * np.pi * one_minus_cosine) if one_minus_cosine > 0.0 else 0.0


@compiled(fastmath=())
def _sphere_distance(cx, cy, cz, radius, wi):
    """Along the unit wi to the near side of a sphere whose centre is at (cx, cy, cz).

    Rounding may take wi past the rim: then to the point nearest to the sphere.
    """
    along = cx * wi[0] + cy * wi[1] + cz * wi[2]
    px, py, pz = cx - along * wi[0], cy - along * wi[1], cz - along * wi[2]
    return along - np.sqrt(max(0.0, radius * radius - (px * px + py * py + pz * pz)))


@compiled(parallel=True, fastmath=())
def _sample_sphere(centre, radius, x_world, u, wi_world, distance, pdf):
    for i in prange(len(x_world)):
        cx, cy, cz, length, one_minus_cosine = _cone(centre, radius, x_world[i])
        pdf[i] = _cone_pdf(one_minus_cosine)
        if length > 0.0:
            axis = cx / length, cy / length, cz / length
            wi = cone_direction(axis[0], axis[1], axis[2], one_minus_cosine, u[i, 0], u[i, 1])
            wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = wi
            distance[i] = _sphere_distance(cx, cy, cz, radius, wi_world[i])
        else:
            wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = 0.0, 0.0, 1.0
            distance[i] = 0.0


@compiled(parallel=True, fastmath=())
def _sphere_pdf(centre, radius, x_world, pdf):
    for i in prange(len(x_world)):
        pdf[i] = _cone_pdf(_cone(centre, radius, x_world[i])[4])

"""A sphere that sends light outwards."""

from __future__ import annotations

import numpy as np

from rna_render.lights.area import AreaLight
from rna_render.lights.directions import cone_direction
from rna_render.lights.kinds import SPHERE, row_places
from rna_render.scene.light_models import SphereModel
from rna_sdk.compiled import compiled
from rna_trace.embree import SphereScene
from rna_trace.vectors import Vector

_CENTRE, _RADIUS = (row_places("sphere")[name] for name in ("centre", "radius"))


class SphereLight(AreaLight):
    """Sampled uniformly over the cone of directions that it fills; dark from within."""

    def __init__(self, model: SphereModel) -> None:
        area = 4.0 * np.pi * model.radius**2
        super().__init__(model, area, SPHERE, centre=model.position, radius=model.radius)
        self.world_from_object = np.eye(4)
        self.world_from_object[:3, 3] = model.position
        self.scene = SphereScene(np.zeros((1, 3), np.float32), np.array([model.radius], np.float32))


@compiled(fastmath=())
def _shape(numbers: np.ndarray) -> tuple[np.ndarray, float]:
    """Centre and radius."""
    return numbers[_CENTRE : _CENTRE + 3], numbers[_RADIUS]


@compiled(fastmath=())
def _cone(centre: np.ndarray, radius: float, x: Vector) -> tuple[float, float, float, float, float]:
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
def _cone_pdf(one_minus_cosine: float) -> float:
    return 1.0 / (2.0 * np.pi * one_minus_cosine) if one_minus_cosine > 0.0 else 0.0


@compiled(fastmath=())
def _sphere_distance(cx: float, cy: float, cz: float, radius: float, wi: Vector) -> float:
    """Along the unit wi to the near side of a sphere whose centre is at (cx, cy, cz).

    Rounding may take wi past the rim: then to the point nearest to the sphere.
    """
    along = cx * wi[0] + cy * wi[1] + cz * wi[2]
    px, py, pz = cx - along * wi[0], cy - along * wi[1], cz - along * wi[2]
    return float(along - np.sqrt(max(0.0, radius * radius - (px * px + py * py + pz * pz))))


@compiled(fastmath=())
def sample_sphere(
    numbers: np.ndarray, x: Vector, u1: float, u2: float
) -> tuple[Vector, float, float]:
    """Direction, distance and density."""
    centre, radius = _shape(numbers)
    cx, cy, cz, length, one_minus_cosine = _cone(centre, radius, x)
    if not length > 0.0:
        return (0.0, 0.0, 1.0), 0.0, 0.0
    wi = cone_direction(cx / length, cy / length, cz / length, one_minus_cosine, u1, u2)
    return wi, _sphere_distance(cx, cy, cz, radius, wi), _cone_pdf(one_minus_cosine)


@compiled(fastmath=())
def sphere_density(numbers: np.ndarray, x: Vector) -> float:
    """Density of directions that meet the sphere."""
    centre, radius = _shape(numbers)
    return _cone_pdf(_cone(centre, radius, x)[4])

"""A sphere that sends light outwards."""

import numpy as np

from rna_render.lights.base import PlacedLight, light_numbers
from rna_render.lights.directions import cone_direction
from rna_render.scene.light_models import SphereModel
from rna_sdk.machine.compiled import compiled
from rna_trace.embree import SphereScene
from rna_trace.vectors import Vector, vector_at


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
def _sample(
    numbers: np.ndarray,
    x_world: np.ndarray,
    u: np.ndarray,
    wi_world: np.ndarray,
    distance: np.ndarray,
    pdf: np.ndarray,
) -> None:
    light = numbers[0]
    centre, radius = light.centre, light.radius
    for i in range(len(x_world)):
        cx, cy, cz, length, cone = _cone(centre, radius, vector_at(x_world, i))
        wi, r, density = (0.0, 0.0, 1.0), 0.0, 0.0
        if length > 0.0:
            wi = cone_direction(cx / length, cy / length, cz / length, cone, u[i, 0], u[i, 1])
            r, density = _sphere_distance(cx, cy, cz, radius, wi), _cone_pdf(cone)
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = wi
        distance[i], pdf[i] = r, density


@compiled(fastmath=())
def _densities(
    numbers: np.ndarray, x_world: np.ndarray, d_world: np.ndarray, pdf: np.ndarray
) -> None:
    light = numbers[0]
    for i in range(len(x_world)):
        pdf[i] = _cone_pdf(_cone(light.centre, light.radius, vector_at(x_world, i))[4])


class SphereLight(PlacedLight):
    """Sampled uniformly over the cone of directions that it fills; dark from within."""

    kind = "sphere"
    NUMBERS = light_numbers(("centre", 3), ("radius", ()))
    sample_kernel = staticmethod(_sample)
    density_kernel = staticmethod(_densities)

    def __init__(self, model: SphereModel) -> None:
        area = 4.0 * np.pi * model.radius**2
        super().__init__(model, area, centre=model.position, radius=model.radius)
        self.world_from_object = np.eye(4)
        self.world_from_object[:3, 3] = model.position
        self.scene = SphereScene(np.zeros((1, 3), np.float32), np.array([model.radius], np.float32))


make = SphereLight

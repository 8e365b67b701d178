"""Light from one point to all sides."""

import numpy as np

from rna_render.lights.base import Light, LightSamples, light_numbers
from rna_render.lights.directions import luminance
from rna_render.scene.light_models import PointModel
from rna_sdk.machine.compiled import compiled
from rna_trace.vectors import Vector, vector_at


class PointLight(Light):
    """Intensity I, its colour: irradiance I / r^2 at distance r."""

    kind = "point"
    NUMBERS = light_numbers(("place", 3))
    delta = True

    def __init__(self, model: PointModel) -> None:
        super().__init__(model.group, colour=model.intensity, place=model.position)

    def power(self, scene_radius: float) -> float:
        return float(4.0 * np.pi * luminance(self.colour))

    def _fill(self, x_world: np.ndarray, u: np.ndarray, samples: LightSamples) -> None:
        _sample(
            self.numbers, x_world, samples.wi_world, samples.distance, samples.radiance, samples.pdf
        )


make = PointLight


@compiled(fastmath=())
def way_to(place: np.ndarray, x: Vector) -> tuple[Vector, float, float]:
    """Direction from x to a place, the distance r, and 1 / r.

    At r = 0 the last is 0: a light that stands on the surface lights nothing, since its direction
    does not exist.
    """
    dx, dy, dz = place[0] - x[0], place[1] - x[1], place[2] - x[2]
    r = np.sqrt(dx * dx + dy * dy + dz * dz)
    scale = 1.0 / r if r > 0.0 else 0.0
    return (dx * scale, dy * scale, dz * scale), r, scale


@compiled(fastmath=())
def _sample(
    numbers: np.ndarray,
    x_world: np.ndarray,
    wi_world: np.ndarray,
    distance: np.ndarray,
    irradiance: np.ndarray,
    pdf: np.ndarray,
) -> None:
    light = numbers[0]
    for i in range(len(x_world)):
        wi, distance[i], scale = way_to(light.place, vector_at(x_world, i))
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = wi
        for channel in range(3):
            irradiance[i, channel] = scale * scale * light.colour[channel]
        pdf[i] = 1.0 if scale > 0.0 else 0.0

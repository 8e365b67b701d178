"""Light from far away: from one direction, or from a small disk of the sky as the sun's."""

import numpy as np

from rna_render.lights.base import InfiniteLight, Light, LightSamples, light_numbers
from rna_render.lights.directions import cone_direction, luminance, unit
from rna_render.scene.light_models import DirectionalModel
from rna_sdk.machine.compiled import compiled
from rna_trace.vectors import vector_at

# Radians from the axis to the rim. Below it float32 directions no longer tell the rim apart.
MIN_ANGLE = 1e-5


def make(model: DirectionalModel) -> Light:
    """A DirectionalLight, or a SunLight where the model has an angular diameter."""
    large = np.radians(model.angular_diameter_deg) / 2.0 >= MIN_ANGLE
    return SunLight(model) if large else DirectionalLight(model)


class DirectionalLight(Light):
    """Irradiance, its colour, from one direction."""

    kind = "directional"
    NUMBERS = light_numbers(("axis", 3))
    delta = True

    def __init__(self, model: DirectionalModel) -> None:
        irradiance = np.asarray(model.irradiance, np.float32)
        super().__init__(model.group, colour=irradiance, axis=unit(model.direction))

    def power(self, scene_radius: float) -> float:
        return float(np.pi * scene_radius**2 * luminance(self.colour))

    def _fill(self, x_world: np.ndarray, u: np.ndarray, samples: LightSamples) -> None:
        samples.wi_world[:], samples.radiance[:] = self.numbers["axis"], self.colour
        samples.distance[:], samples.pdf[:] = np.inf, 1.0


class SunLight(InfiniteLight):
    """Equal radiance, its colour, from all directions within an angle of an axis; no camera sees
    it.

    A plane that faces it gets the model's irradiance: the cone's projected solid angle about its
    axis is pi sin^2 of the angle from the axis to the rim.
    """

    kind = "sun"
    NUMBERS = light_numbers(("axis", 3), ("one_minus_cosine", ()))
    visible_to_camera = False

    def __init__(self, model: DirectionalModel) -> None:
        angle = np.radians(model.angular_diameter_deg) / 2.0
        self._irradiance = np.asarray(model.irradiance, np.float64)
        radiance = self._irradiance / (np.pi * np.sin(angle) ** 2)
        one_minus_cosine = 2.0 * np.sin(angle / 2.0) ** 2
        cone = {"axis": unit(model.direction), "one_minus_cosine": one_minus_cosine}
        super().__init__(model.group, colour=radiance, **cone)

    def power(self, scene_radius: float) -> float:
        return float(np.pi * scene_radius**2 * luminance(self._irradiance))

    def _fill(self, x_world: np.ndarray, u: np.ndarray, samples: LightSamples) -> None:
        _sample_sun(self.numbers, u, samples.wi_world, samples.pdf)
        samples.radiance[:], samples.distance[:] = self.colour, np.inf

    def eval_environment(self, d_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        radiance, pdf = np.empty((len(d_world), 3), np.float32), np.empty(len(d_world), np.float32)
        _look_up_sun(self.numbers, d_world, radiance, pdf)
        return radiance, pdf


@compiled(fastmath=())
def _sample_sun(numbers: np.ndarray, u: np.ndarray, wi_world: np.ndarray, pdf: np.ndarray) -> None:
    light = numbers[0]
    axis, one_minus_cosine = light.axis, light.one_minus_cosine
    for i in range(len(u)):
        wi = cone_direction(axis[0], axis[1], axis[2], one_minus_cosine, u[i, 0], u[i, 1])
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = wi
        pdf[i] = 1.0 / (2.0 * np.pi * one_minus_cosine)


@compiled(fastmath=())
def _look_up_sun(
    numbers: np.ndarray, d_world: np.ndarray, radiance: np.ndarray, pdf: np.ndarray
) -> None:
    light = numbers[0]
    axis, one_minus_cosine = light.axis, light.one_minus_cosine
    for i in range(len(d_world)):
        # |d - axis|^2 = 2 (1 - cos), without the rounding of a cosine near 1.
        d = vector_at(d_world, i)
        x, y, z = d[0] - axis[0], d[1] - axis[1], d[2] - axis[2]
        inside = not x * x + y * y + z * z > 2.0 * one_minus_cosine
        for channel in range(3):
            radiance[i, channel] = light.colour[channel] if inside else 0.0
        pdf[i] = 1.0 / (2.0 * np.pi * one_minus_cosine) if inside else 0.0

"""Light from one point within a cone."""

import numpy as np

from rna_render.lights.base import Light, LightSamples, light_numbers
from rna_render.lights.directions import luminance, unit
from rna_render.lights.kinds.point import way_to
from rna_render.scene.light_models import SpotModel
from rna_sdk.machine.compiled import compiled
from rna_trace.vectors import vector_at


class SpotLight(Light):
    """Intensity within a cone, with a soft rim.

    Towards the rim it falls as smoothstep(t), t = (cos - cos_outer) / (cos_inner - cos_outer), of
    the angle's cosine. That is the falloff of Blender's spot lamp (Cycles,
    kernel/light/spot.h: smoothstepf((cos - cos_half_spot_angle) * spot_smooth), with
    spot_smooth = 1 / ((1 - cos_half_spot_angle) * blend) in scene/light.cpp): one without size,
    spot_size = 2 outer_angle and spot_blend = (cos_inner - cos_outer) / (1 - cos_outer).
    """

    kind = "spot"
    NUMBERS = light_numbers(("place", 3), ("axis", 3), ("cos_inner", ()), ("cos_outer", ()))
    delta = True

    def __init__(self, model: SpotModel) -> None:
        axis = unit(np.subtract(model.look_at, model.position))
        inner, outer = np.cos(np.radians([model.inner_angle_deg, model.outer_angle_deg])).tolist()
        cone = {"place": model.position, "axis": axis, "cos_inner": inner, "cos_outer": outer}
        super().__init__(model.group, colour=model.intensity, **cone)
        # The integral of smoothstep(t) is half the integral of 1.
        self._cap = 1.0 - inner + (inner - outer) / 2.0

    def power(self, scene_radius: float) -> float:
        return float(2.0 * np.pi * self._cap * luminance(self.colour))

    def _fill(self, x_world: np.ndarray, u: np.ndarray, samples: LightSamples) -> None:
        _sample(
            self.numbers, x_world, samples.wi_world, samples.distance, samples.radiance, samples.pdf
        )


make = SpotLight


@compiled(fastmath=())
def _falloff(cosine: float, cos_inner: float, cos_outer: float) -> float:
    """1 within the inner cone, 0 without the outer one."""
    if cosine >= cos_inner:
        return 1.0
    if cosine <= cos_outer:
        return 0.0
    t = (cosine - cos_outer) / (cos_inner - cos_outer)
    return t * t * (3.0 - 2.0 * t)


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
    axis = light.axis
    for i in range(len(x_world)):
        wi, distance[i], scale = way_to(light.place, vector_at(x_world, i))
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = wi
        cosine = -(wi[0] * axis[0] + wi[1] * axis[1] + wi[2] * axis[2])
        factor = _falloff(cosine, light.cos_inner, light.cos_outer) * scale * scale
        for channel in range(3):
            irradiance[i, channel] = factor * light.colour[channel]
        pdf[i] = 1.0 if factor > 0.0 else 0.0

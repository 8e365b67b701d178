"""Light from one point: to all sides, or within a cone."""

from __future__ import annotations

import numpy as np
from numba import prange

from rna_render.lights.base import Light, LightSamples
from rna_render.lights.directions import luminance, unit
from rna_render.lights.models import PointModel, SpotModel
from rna_render.rays import vectors
from rna_sdk.compiled import compiled


class _PointLike(Light):
    """Intensity I within a cone: irradiance I / r^2 at distance r.

    Towards the rim it falls as smoothstep(t), t = (cos - cos_outer) / (cos_inner - cos_outer), of
    the angle's cosine. That is the falloff of Blender's spot lamp (Cycles,
    kernel/light/spot.h: smoothstepf((cos - cos_half_spot_angle) * spot_smooth), with
    spot_smooth = 1 / ((1 - cos_half_spot_angle) * blend) in scene/light.cpp).
    """

    delta = True

    def __init__(
        self,
        model: PointModel | SpotModel,
        axis: np.ndarray,
        cos_inner: float,
        cos_outer: float,
    ) -> None:
        self.group = model.group
        self._position = np.asarray(model.position, np.float64)
        self._intensity = np.asarray(model.intensity, np.float64)
        self._axis, self._cos_inner, self._cos_outer = axis, cos_inner, cos_outer

    def power(self, scene_radius: float) -> float:
        # The integral of smoothstep(t) is half that of 1.
        cap = 1.0 - self._cos_inner + (self._cos_inner - self._cos_outer) / 2.0
        return float(2.0 * np.pi * cap * luminance(self._intensity))

    def sample(self, x_world: np.ndarray, u: np.ndarray) -> LightSamples:
        x_world = vectors("x_world", x_world)
        n = len(x_world)
        wi_world, irradiance = np.empty((n, 3), np.float32), np.empty((n, 3), np.float32)
        distance, pdf = np.empty(n, np.float32), np.empty(n, np.float32)
        cone = self._axis, self._cos_inner, self._cos_outer
        out = wi_world, distance, irradiance, pdf
        _towards(self._position, self._intensity, *cone, x_world, *out)
        return LightSamples(*out)


class PointLight(_PointLike):
    """The same intensity to all sides."""

    def __init__(self, model: PointModel) -> None:
        super().__init__(model, np.zeros(3), -1.0, -1.0)


class SpotLight(_PointLike):
    """Intensity within a cone, with a soft rim.

    In Blender it is a spot lamp without size, spot_size = 2 outer_angle and
    spot_blend = (cos_inner - cos_outer) / (1 - cos_outer).
    """

    def __init__(self, model: SpotModel) -> None:
        axis = unit(np.subtract(model.look_at, model.position))
        inner, outer = np.cos(np.radians([model.inner_angle_deg, model.outer_angle_deg]))
        super().__init__(model, axis, float(inner), float(outer))


@compiled(fastmath=())
def _falloff(cosine, cos_inner, cos_outer):
    """1 within the inner cone, 0 without the outer one."""
    if cosine >= cos_inner:
        return 1.0
    if cosine <= cos_outer:
        return 0.0
    t = (cosine - cos_outer) / (cos_inner - cos_outer)
    return t * t * (3.0 - 2.0 * t)


@compiled(parallel=True, fastmath=())
def _towards(
    position, intensity, axis, cos_inner, cos_outer, x_world, wi_world, distance, irradiance, pdf
):
    for i in prange(len(x_world)):
        dx = position[0] - x_world[i, 0]
        dy = position[1] - x_world[i, 1]
        dz = position[2] - x_world[i, 2]
        r = np.sqrt(dx * dx + dy * dy + dz * dz)
        # A light that stands on the surface lights nothing: its direction does not exist.
        scale = 1.0 / r if r > 0.0 else 0.0
        dx, dy, dz = dx * scale, dy * scale, dz * scale
        cosine = -(dx * axis[0] + dy * axis[1] + dz * axis[2])
        factor = _falloff(cosine, cos_inner, cos_outer) * scale * scale
        distance[i] = r
        wi_world[i, 0], wi_world[i, 1], wi_world[i, 2] = dx, dy, dz
        pdf[i] = 1.0 if factor > 0.0 else 0.0
        for channel in range(3):
            irradiance[i, channel] = intensity[channel] * factor

"""Light from one point: to all sides, or within a cone."""

from __future__ import annotations

import numpy as np

from rna_render.lights.base import Light
from rna_render.lights.directions import luminance, unit
from rna_render.lights.kinds import POINT, light_row, row_places
from rna_render.scene.light_models import PointModel, SpotModel
from rna_sdk.compiled import compiled
from rna_trace.vectors import Vector

_AT = row_places("point")
_PLACE, _AXIS, _INNER, _OUTER = (_AT[name] for name in ("place", "axis", "cos_inner", "cos_outer"))


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
        self._intensity = np.asarray(model.intensity, np.float64)
        self._cos_inner, self._cos_outer = cos_inner, cos_outer
        self.row = light_row(
            POINT,
            self._intensity,
            place=model.position,
            axis=axis,
            cos_inner=cos_inner,
            cos_outer=cos_outer,
        )

    def power(self, scene_radius: float) -> float:
        # The integral of smoothstep(t) is half that of 1.
        cap = 1.0 - self._cos_inner + (self._cos_inner - self._cos_outer) / 2.0
        return float(2.0 * np.pi * cap * luminance(self._intensity))


class PointLight(_PointLike):
    """Equal intensity to all sides."""

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
def _falloff(cosine: float, cos_inner: float, cos_outer: float) -> float:
    """1 within the inner cone, 0 without the outer one."""
    if cosine >= cos_inner:
        return 1.0
    if cosine <= cos_outer:
        return 0.0
    t = (cosine - cos_outer) / (cos_inner - cos_outer)
    return t * t * (3.0 - 2.0 * t)


@compiled(fastmath=())
def sample_point_light(numbers: np.ndarray, x: Vector) -> tuple[Vector, float, Vector, float]:
    """Direction, distance, irradiance, and 1 for a density, or 0 without its cone."""
    place, axis = numbers[_PLACE : _PLACE + 3], numbers[_AXIS : _AXIS + 3]
    dx, dy, dz = place[0] - x[0], place[1] - x[1], place[2] - x[2]
    r = np.sqrt(dx * dx + dy * dy + dz * dz)
    # A light that stands on the surface lights nothing: its direction does not exist.
    scale = 1.0 / r if r > 0.0 else 0.0
    dx, dy, dz = dx * scale, dy * scale, dz * scale
    cosine = -(dx * axis[0] + dy * axis[1] + dz * axis[2])
    factor = _falloff(cosine, numbers[_INNER], numbers[_OUTER]) * scale * scale
    irradiance = factor * numbers[0], factor * numbers[1], factor * numbers[2]
    return (dx, dy, dz), r, irradiance, 1.0 if factor > 0.0 else 0.0

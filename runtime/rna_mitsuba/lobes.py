"""Directions for rays that leave assets, with their density: the lobes of rna-run in Dr.Jit.

A decoder cannot be sampled itself. Surfaces: all directions, the cosine lobe on the viewer's side,
and a lobe about the mirror direction. Fibers: all directions, the cone about the tangent that
specular reflection and transmission lie on, and a lobe about -wo.
"""

from __future__ import annotations

from dataclasses import dataclass

import drjit as dr
import mitsuba as mi

UNIFORM, COSINE, MIRROR = 0.2, 0.35, 0.45  # shares on surfaces
MIRROR_PARTS, MIRROR_KAPPAS = (0.5, 0.3, 0.2), (20.0, 400.0, 8000.0)
FIBER_UNIFORM, CONE, FORWARD = 0.3, 0.45, 0.25  # shares on fibers
CONE_SCALE, FORWARD_KAPPA = 0.06, 5.0


@dataclass
class Lobes:
    """The lobes at points; everything in one space, unit.

    axis: normal of surfaces, tangent of fibers; zero counts as some direction.
    """

    is_fiber: mi.Bool
    axis: mi.Vector3f
    wo: mi.Vector3f

    def __post_init__(self) -> None:
        cosine = dr.dot(self.axis, self.wo)
        turned = dr.select(cosine < 0, -self.axis, self.axis)
        self.axis = dr.select(self.is_fiber, self.axis, turned)
        self.mirror = 2 * dr.abs(cosine) * turned - self.wo
        self.middle = -cosine  # sine of inclination of the cone

    def sample(self, choice: mi.Float, u: mi.Point2f) -> mi.Vector3f:
        """Unit directions from three numbers in [0, 1)."""
        uniform = 1 - 2 * u.x
        on_surface = dr.select(choice < UNIFORM + COSINE, dr.sqrt(1 - u.x), _mirror(u.x))
        on_surface = dr.select(choice < UNIFORM, uniform, on_surface)
        surface_axis = dr.select(choice < UNIFORM + COSINE, self.axis, self.mirror)
        sine = self._cone_sine(u.x)
        on_fiber = dr.select(choice < FIBER_UNIFORM + CONE, sine, _fisher(u.x, FORWARD_KAPPA))
        on_fiber = dr.select(choice < FIBER_UNIFORM, uniform, on_fiber)
        fiber_axis = dr.select(choice < FIBER_UNIFORM + CONE, self.axis, -self.wo)
        axis = dr.select(self.is_fiber, fiber_axis, surface_axis)
        cosine = dr.select(self.is_fiber, on_fiber, on_surface)
        sine = dr.sqrt(dr.maximum(0, 1 - cosine * cosine))
        s, c = dr.sincos(2 * dr.pi * u.y)
        local = mi.Vector3f(sine * c, sine * s, cosine)
        return dr.normalize(mi.Frame3f(_some(axis)).to_world(local))

    def pdf(self, wi: mi.Vector3f) -> mi.Float:
        """Density of `sample` in unit wi, per steradian."""
        surface = UNIFORM / (4 * dr.pi)
        surface += COSINE * dr.maximum(0, dr.dot(self.axis, wi)) / dr.pi
        surface += MIRROR * _mirror_pdf(dr.dot(self.mirror, wi))
        fiber = FIBER_UNIFORM / (4 * dr.pi)
        fiber += CONE * self._cone_pdf(dr.dot(self.axis, wi))
        fiber += FORWARD * _fisher_pdf(-dr.dot(self.wo, wi), FORWARD_KAPPA)
        return dr.select(self.is_fiber, fiber, surface)

    def _cone_limits(self) -> tuple[mi.Float, mi.Float]:
        return (
            _logistic((-1 - self.middle) / CONE_SCALE),
            _logistic((1 - self.middle) / CONE_SCALE),
        )

    def _cone_sine(self, u: mi.Float) -> mi.Float:
        """Sine of inclination: logistic about the middle, cut off at -1 and 1."""
        low, high = self._cone_limits()
        p = dr.clip(low + u * (high - low), 1e-7, 1 - 1e-7)
        return dr.clip(self.middle + CONE_SCALE * dr.log(p / (1 - p)), -1, 1)

    def _cone_pdf(self, sine: mi.Float) -> mi.Float:
        low, high = self._cone_limits()
        p = _logistic((sine - self.middle) / CONE_SCALE)
        return p * (1 - p) / (CONE_SCALE * (high - low) * 2 * dr.pi)


def _some(axis: mi.Vector3f) -> mi.Vector3f:
    return dr.select(dr.dot(axis, axis) > 0.25, axis, mi.Vector3f(0, 1, 0))


def _mirror(u: mi.Float) -> mi.Float:
    """Cosine to the mirror direction; u chooses the width, too."""
    first, second, third = MIRROR_PARTS
    broad, last = u < first, u >= first + second
    low = dr.select(broad, 0.0, dr.select(last, first + second, first))
    left = (u - low) / dr.select(broad, first, dr.select(last, third, second))
    kappas = [mi.Float(kappa) for kappa in MIRROR_KAPPAS]
    kappa = dr.select(broad, kappas[0], dr.select(last, kappas[2], kappas[1]))
    return _fisher(dr.minimum(left, 1 - 2**-24), kappa)


def _mirror_pdf(cosine: mi.Float) -> mi.Float:
    parts = zip(MIRROR_PARTS, MIRROR_KAPPAS, strict=True)
    return sum((part * _fisher_pdf(cosine, kappa) for part, kappa in parts), mi.Float(0))


def _fisher(u: mi.Float, kappa: float | mi.Float) -> mi.Float:
    """Cosine to the axis of a von Mises-Fisher direction; Jakob, Numerically stable sampling of
    the von Mises-Fisher distribution on S2 (2012)."""
    return dr.maximum(-1, 1 + dr.log(u + (1 - u) * dr.exp(-2 * kappa)) / kappa)


def _fisher_pdf(cosine: mi.Float, kappa: float) -> mi.Float:
    scale = kappa / (2 * dr.pi * (1 - dr.exp(-2 * kappa)))
    return scale * dr.exp(kappa * (cosine - 1))


def _logistic(x: mi.Float) -> mi.Float:
    return 1 / (1 + dr.exp(-x))

"""Directions for rays that leave a neural asset: a mixture of lobes, with its density.

The decoder cannot be sampled itself, but most of what it sends comes from a few places: from all
around (light that is scattered inside), from the side of the normal (diffuse reflection), from
the mirror direction (highlights), for fibers from the cone about the tangent that specular
reflection and transmission both lie on, and from straight behind (light that goes through).
Weights and widths of the lobes were chosen by `benchmarks/importance.py`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numba import prange

from rna_sdk.compiled import compiled

UNIFORM, COSINE, MIRROR, CONE, FORWARD = range(5)


@dataclass(frozen=True)
class LobeMixture:
    """Shares and widths of the lobes; shares add up to 1.

    uniform: all directions alike. cosine: about the normal, turned to the viewer. mirror: about
    the mirror direction, von Mises-Fisher with concentration mirror_kappa. cone: about the cone
    of specular reflection from a fiber, sine of inclination logistic with scale cone_scale
    about its value there, all azimuths alike. forward: about -wo, von Mises-Fisher with
    concentration forward_kappa.
    """

    uniform: float = 0.0
    cosine: float = 0.0
    mirror: float = 0.0
    cone: float = 0.0
    forward: float = 0.0
    mirror_kappa: float = 20.0
    cone_scale: float = 0.1
    forward_kappa: float = 20.0

    def sample(
        self, n: np.ndarray, tangents: np.ndarray, wo: np.ndarray, u: np.ndarray
    ) -> np.ndarray:
        """Directions wi: (m, 3) float32, unit.

        n, tangents, wo: (m, 3) float32, unit; a zero normal or tangent counts as some direction.
        u: (m, 3) float64 in [0, 1); the last one chooses the lobe.
        """
        wi = np.empty((len(n), 3), np.float32)
        _sample(*self._numbers(), n, tangents, wo, u, wi)
        return wi

    def pdf(
        self, n: np.ndarray, tangents: np.ndarray, wo: np.ndarray, wi: np.ndarray
    ) -> np.ndarray:
        """Density of `sample` in wi, per steradian: (m,) float32; all but u as there."""
        pdf = np.empty(len(n), np.float32)
        _pdf(*self._numbers(), n, tangents, wo, wi, pdf)
        return pdf

    def _numbers(self) -> tuple[np.ndarray, float, float, float]:
        shares = np.array([self.uniform, self.cosine, self.mirror, self.cone, self.forward])
        return shares / shares.sum(), self.mirror_kappa, self.cone_scale, self.forward_kappa


@compiled(fastmath=())
def _unit_or(x, y, z, otherwise):
    length = np.sqrt(x * x + y * y + z * z)
    return (x / length, y / length, z / length) if length > 0.5 else otherwise


@compiled(fastmath=())
def _about(axis, cosine, phi):
    """The direction at that cosine to a unit axis, and that azimuth."""
    x, y, z = axis
    sine = np.sqrt(max(0.0, 1.0 - cosine * cosine))
    a, b = sine * np.cos(phi), sine * np.sin(phi)
    # Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017).
    sign = np.copysign(1.0, z)
    c = -1.0 / (sign + z)
    d = x * y * c
    return (
        a * (1.0 + sign * x * x * c) + b * d + cosine * x,
        a * sign * d + b * (sign + y * y * c) + cosine * y,
        -a * sign * x - b * y + cosine * z,
    )


@compiled(fastmath=())
def _fisher_cosine(u, kappa):
    """Cosine to the axis of a von Mises-Fisher direction; Jakob, Numerically stable sampling of
    the von Mises-Fisher distribution on S2 (2012)."""
    return max(-1.0, 1.0 + np.log(u + (1.0 - u) * np.exp(-2.0 * kappa)) / kappa)


@compiled(fastmath=())
def _fisher_pdf(cosine, kappa):
    """Density per steradian at that cosine to the axis."""
    return kappa * np.exp(kappa * (cosine - 1.0)) / (2.0 * np.pi * (1.0 - np.exp(-2.0 * kappa)))


@compiled(fastmath=())
def _logistic(x):
    return 1.0 / (1.0 + np.exp(-x))


@compiled(fastmath=())
def _cone_sine(u, middle, scale):
    """Sine of inclination: logistic about `middle`, cut off at -1 and 1."""
    low, high = _logistic((-1.0 - middle) / scale), _logistic((1.0 - middle) / scale)
    p = low + u * (high - low)
    return min(1.0, max(-1.0, middle + scale * np.log(p / (1.0 - p))))


@compiled(fastmath=())
def _cone_pdf(sine, middle, scale):
    """Density per steradian; solid angle is d(sine) d(azimuth)."""
    low, high = _logistic((-1.0 - middle) / scale), _logistic((1.0 - middle) / scale)
    p = _logistic((sine - middle) / scale)
    return p * (1.0 - p) / (scale * (high - low) * 2.0 * np.pi)


@compiled(fastmath=())
def _frame(n, tangents, wo, i):
    """Viewer, normal turned to it, tangent, and mirror direction, in float64."""
    o = np.float64(wo[i, 0]), np.float64(wo[i, 1]), np.float64(wo[i, 2])
    up = (0.0, 1.0, 0.0)
    nx, ny, nz = np.float64(n[i, 0]), np.float64(n[i, 1]), np.float64(n[i, 2])
    normal = _unit_or(nx, ny, nz, up)
    cosine = normal[0] * o[0] + normal[1] * o[1] + normal[2] * o[2]
    if cosine < 0.0:
        cosine, normal = -cosine, (-normal[0], -normal[1], -normal[2])
    tx, ty, tz = np.float64(tangents[i, 0]), np.float64(tangents[i, 1]), np.float64(tangents[i, 2])
    tangent = _unit_or(tx, ty, tz, up)
    twice = 2.0 * cosine
    mirror = (
        twice * normal[0] - o[0],
        twice * normal[1] - o[1],
        twice * normal[2] - o[2],
    )
    return o, normal, tangent, mirror


@compiled(fastmath=())
def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@compiled(parallel=True, fastmath=())
def _sample(shares, mirror_kappa, cone_scale, forward_kappa, n, tangents, wo, u, wi):
    for i in prange(len(n)):
        o, normal, tangent, mirror = _frame(n, tangents, wo, i)
        u1, phi, choice = u[i, 0], 2.0 * np.pi * u[i, 1], u[i, 2]
        lobe = UNIFORM
        for k in range(len(shares)):
            if shares[k] > 0.0:
                lobe = k
                if choice < shares[k]:
                    break
            choice -= shares[k]
        if lobe == UNIFORM:
            direction = _about(normal, 1.0 - 2.0 * u1, phi)
        elif lobe == COSINE:
            direction = _about(normal, np.sqrt(1.0 - u1), phi)
        elif lobe == MIRROR:
            direction = _about(mirror, _fisher_cosine(u1, mirror_kappa), phi)
        elif lobe == CONE:
            direction = _about(tangent, _cone_sine(u1, -_dot(tangent, o), cone_scale), phi)
        else:
            backward = (-o[0], -o[1], -o[2])
            direction = _about(backward, _fisher_cosine(u1, forward_kappa), phi)
        length = np.sqrt(_dot(direction, direction))
        for axis in range(3):
            wi[i, axis] = direction[axis] / length


@compiled(parallel=True, fastmath=())
def _pdf(shares, mirror_kappa, cone_scale, forward_kappa, n, tangents, wo, wi, pdf):
    for i in prange(len(n)):
        o, normal, tangent, mirror = _frame(n, tangents, wo, i)
        w = np.float64(wi[i, 0]), np.float64(wi[i, 1]), np.float64(wi[i, 2])
        density = shares[UNIFORM] / (4.0 * np.pi)
        density += shares[COSINE] * max(0.0, _dot(normal, w)) / np.pi
        if shares[MIRROR] > 0.0:
            density += shares[MIRROR] * _fisher_pdf(_dot(mirror, w), mirror_kappa)
        if shares[CONE] > 0.0:
            density += shares[CONE] * _cone_pdf(_dot(tangent, w), -_dot(tangent, o), cone_scale)
        if shares[FORWARD] > 0.0:
            density += shares[FORWARD] * _fisher_pdf(-_dot(o, w), forward_kappa)
        pdf[i] = density

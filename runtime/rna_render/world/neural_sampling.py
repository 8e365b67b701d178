"""Directions for rays that leave a neural asset: a mixture of lobes, with its density.

The decoder cannot be sampled itself, but most of what it sends comes from a few places: from all
around (light that is scattered inside), from the side of the normal (diffuse reflection), from
the mirror direction (highlights), for fibers from the cone about the tangent that specular
reflection and transmission both lie on, and from straight behind (light that goes through).
Weights and widths of the lobes: docs/decisions/renderer.md,
"Rays leave assets in a mixture of lobes".
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from rna_sdk.compiled import compiled
from rna_trace.angles import sine_and_cosine
from rna_trace.vectors import Vector, along, dot, unit, vector_at

# Places in a mixture's numbers: shares of the lobes, then their widths.
UNIFORM, COSINE, MIRROR, CONE, FORWARD, CONE_SCALE, FORWARD_KAPPA, MIRROR_PARTS = range(8)
LOBES = 5
WIDTHS = 3  # of the mirror lobe
MIRROR_KAPPAS = MIRROR_PARTS + WIDTHS

BELOW_ONE = 1.0 - 2.0**-53


@dataclass(frozen=True)
class LobeMixture:
    """Shares and widths of the lobes; shares add up to 1.

    uniform: all directions alike. cosine: about the normal, turned to the viewer. mirror: about
    the mirror direction, a mixture of von Mises-Fisher lobes with concentrations mirror_kappas, of
    which each is the given part: highlights of rough and of smooth materials. cone: about the cone
    of specular reflection from a fiber, sine of inclination logistic with scale cone_scale
    about its value there, all azimuths alike. forward: about -wo, von Mises-Fisher with
    concentration forward_kappa.
    """

    uniform: float = 0.0
    cosine: float = 0.0
    mirror: float = 0.0
    cone: float = 0.0
    forward: float = 0.0
    mirror_kappas: tuple[float, float, float] = (20.0, 400.0, 8000.0)
    mirror_parts: tuple[float, float, float] = (0.5, 0.3, 0.2)
    cone_scale: float = 0.1
    forward_kappa: float = 20.0

    def sample(
        self,
        n: np.ndarray,
        tangents: np.ndarray,
        wo: np.ndarray,
        u: np.ndarray,
        row: np.ndarray | None = None,
    ) -> np.ndarray:
        """Directions wi: (k, 3) float32, unit.

        n, tangents, wo: (m, 3) float32, unit; a zero normal or tangent counts as some direction.
        u: (k, 2) float64 in [0, 1). The first one chooses the lobe, and what is left of it the
        direction there: points that are spread evenly are so over lobes and directions at once.
        row: (k,) which points the numbers are for; None for all, in order.
        """
        wi = np.empty((len(u), 3), np.float32)
        _sample(self.numbers, n, tangents, wo, _rows(row, n), u, wi)
        return wi

    def pdf(
        self,
        n: np.ndarray,
        tangents: np.ndarray,
        wo: np.ndarray,
        wi: np.ndarray,
        row: np.ndarray | None = None,
    ) -> np.ndarray:
        """Density of `sample` in wi, per steradian: (k,) float32; all but u as there."""
        pdf = np.empty(len(wi), np.float32)
        _pdf(self.numbers, n, tangents, wo, _rows(row, n), wi, pdf)
        return pdf

    @cached_property
    def numbers(self) -> np.ndarray:
        """Shares and widths for compiled code, (13,) float64."""
        shares = np.array([self.uniform, self.cosine, self.mirror, self.cone, self.forward])
        mirrors = *self.mirror_parts, *self.mirror_kappas
        return np.append(shares / shares.sum(), [self.cone_scale, self.forward_kappa, *mirrors])


def _rows(row: np.ndarray | None, points: np.ndarray) -> np.ndarray:
    return np.arange(len(points)) if row is None else row


Frame = tuple[Vector, Vector, Vector, Vector]
"""What `lobe_frame` returns."""


@compiled(inline=True, fastmath=())
def _unit_or(x: float, y: float, z: float, otherwise: Vector) -> Vector:
    length = np.sqrt(x * x + y * y + z * z)
    return (x / length, y / length, z / length) if length > 0.5 else otherwise


@compiled(inline=True, fastmath=())
def _about(axis: Vector, cosine: float, turns: float) -> Vector:
    """The direction at that cosine to a unit axis, and that azimuth, in turns."""
    sine = np.sqrt(max(0.0, 1.0 - cosine * cosine))
    sin_phi, cos_phi = sine_and_cosine(turns)
    return along(axis, sine * cos_phi, sine * sin_phi, cosine)


@compiled(inline=True, fastmath=())
def _fisher_cosine(u: float, kappa: float) -> float:
    """Cosine to the axis of a von Mises-Fisher direction; Jakob, Numerically stable sampling of
    the von Mises-Fisher distribution on S2 (2012)."""
    return float(max(-1.0, 1.0 + np.log(u + (1.0 - u) * np.exp(-2.0 * kappa)) / kappa))


@compiled(inline=True, fastmath=())
def _fisher_pdf(cosine: float, kappa: float) -> float:
    """Density per steradian at that cosine to the axis."""
    return float(
        kappa * np.exp(kappa * (cosine - 1.0)) / (2.0 * np.pi * (1.0 - np.exp(-2.0 * kappa)))
    )


@compiled(inline=True, fastmath=())
def _mirror_cosine(numbers: np.ndarray, u: float) -> float:
    """Cosine to the mirror direction; u chooses the width, too."""
    k, left = 0, u
    while k < WIDTHS - 1 and left >= numbers[MIRROR_PARTS + k]:
        left -= numbers[MIRROR_PARTS + k]
        k += 1
    left = min(left / numbers[MIRROR_PARTS + k], BELOW_ONE)
    return _fisher_cosine(left, numbers[MIRROR_KAPPAS + k])


@compiled(inline=True, fastmath=())
def _mirror_pdf(numbers: np.ndarray, cosine: float) -> float:
    density = 0.0
    for k in range(WIDTHS):
        density += numbers[MIRROR_PARTS + k] * _fisher_pdf(cosine, numbers[MIRROR_KAPPAS + k])
    return density


@compiled(inline=True, fastmath=())
def _logistic(x: float) -> float:
    return float(1.0 / (1.0 + np.exp(-x)))


@compiled(inline=True, fastmath=())
def _cone_sine(u: float, middle: float, scale: float) -> float:
    """Sine of inclination: logistic about `middle`, cut off at -1 and 1."""
    low, high = _logistic((-1.0 - middle) / scale), _logistic((1.0 - middle) / scale)
    p = low + u * (high - low)
    return float(min(1.0, max(-1.0, middle + scale * np.log(p / (1.0 - p)))))


@compiled(inline=True, fastmath=())
def _cone_pdf(sine: float, middle: float, scale: float) -> float:
    """Density per steradian; solid angle is d(sine) d(azimuth)."""
    low, high = _logistic((-1.0 - middle) / scale), _logistic((1.0 - middle) / scale)
    p = _logistic((sine - middle) / scale)
    return p * (1.0 - p) / (scale * (high - low) * 2.0 * np.pi)


@compiled(inline=True, fastmath=())
def lobe_frame(n: Vector, tangent: Vector, o: Vector) -> Frame:
    """Frame of a point for the functions below: viewer, normal turned to it, tangent, and mirror
    direction."""
    up = (0.0, 1.0, 0.0)
    normal = _unit_or(n[0], n[1], n[2], up)
    cosine = dot(normal, o)
    if cosine < 0.0:
        cosine, normal = -cosine, (-normal[0], -normal[1], -normal[2])
    tangent = _unit_or(tangent[0], tangent[1], tangent[2], up)
    twice = 2.0 * cosine
    mirror = (twice * normal[0] - o[0], twice * normal[1] - o[1], twice * normal[2] - o[2])
    return o, normal, tangent, mirror


@compiled(inline=True, fastmath=())
def lobe_sample(numbers: np.ndarray, frame: Frame, u1: float, u2: float) -> Vector:
    """A direction, as often as `lobe_density` says: three float64. u1 chooses the lobe, too."""
    o, normal, tangent, mirror = frame
    lobe, choice = UNIFORM, u1
    for k in range(LOBES):
        if numbers[k] > 0.0:
            lobe = k
            u1 = min(choice / numbers[k], BELOW_ONE)
            if choice < numbers[k]:
                break
        choice -= numbers[k]
    if lobe == UNIFORM:
        direction = _about(normal, 1.0 - 2.0 * u1, u2)
    elif lobe == COSINE:
        direction = _about(normal, np.sqrt(1.0 - u1), u2)
    elif lobe == MIRROR:
        direction = _about(mirror, _mirror_cosine(numbers, u1), u2)
    elif lobe == CONE:
        direction = _about(tangent, _cone_sine(u1, -dot(tangent, o), numbers[CONE_SCALE]), u2)
    else:
        backward = (-o[0], -o[1], -o[2])
        direction = _about(backward, _fisher_cosine(u1, numbers[FORWARD_KAPPA]), u2)
    return unit(direction)


@compiled(inline=True, fastmath=())
def lobe_density(numbers: np.ndarray, frame: Frame, w: Vector) -> float:
    """Density per steradian in w."""
    o, normal, tangent, mirror = frame
    density: float = numbers[UNIFORM] / (4.0 * np.pi)
    density += numbers[COSINE] * max(0.0, dot(normal, w)) / np.pi
    if numbers[MIRROR] > 0.0:
        density += numbers[MIRROR] * _mirror_pdf(numbers, dot(mirror, w))
    if numbers[CONE] > 0.0:
        density += numbers[CONE] * _cone_pdf(dot(tangent, w), -dot(tangent, o), numbers[CONE_SCALE])
    if numbers[FORWARD] > 0.0:
        density += numbers[FORWARD] * _fisher_pdf(-dot(o, w), numbers[FORWARD_KAPPA])
    return density


@compiled(rows="row u wi", fastmath=())
def _sample(
    numbers: np.ndarray,
    n: np.ndarray,
    tangents: np.ndarray,
    wo: np.ndarray,
    row: np.ndarray,
    u: np.ndarray,
    wi: np.ndarray,
) -> None:
    for i in range(len(row)):
        at = row[i]
        frame = lobe_frame(vector_at(n, at), vector_at(tangents, at), vector_at(wo, at))
        wi[i, 0], wi[i, 1], wi[i, 2] = lobe_sample(numbers, frame, u[i, 0], u[i, 1])


@compiled(rows="row wi pdf", fastmath=())
def _pdf(
    numbers: np.ndarray,
    n: np.ndarray,
    tangents: np.ndarray,
    wo: np.ndarray,
    row: np.ndarray,
    wi: np.ndarray,
    pdf: np.ndarray,
) -> None:
    for i in range(len(row)):
        at = row[i]
        frame = lobe_frame(vector_at(n, at), vector_at(tangents, at), vector_at(wo, at))
        pdf[i] = lobe_density(numbers, frame, vector_at(wi, i))

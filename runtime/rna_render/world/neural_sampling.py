"""Directions for rays that leave a neural asset: a mixture of lobes, with its density.

The decoder cannot be sampled itself, but most of what it sends comes from a few places: from all
around (light that is scattered inside), from the side of the normal (diffuse reflection), from
about the mirror direction (highlights), for fibers from the cone about the tangent that specular
reflection and transmission both lie on, and from straight behind (light that goes through).
Packages say which lobes fit them (`RNA_sampling`): docs/decisions/renderer.md,
"Rays leave assets in a mixture of lobes".
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from rna_render.materials.ggx import reflected_density, sample_reflection
from rna_sdk.machine.compiled import compiled
from rna_sdk.package import Mixture
from rna_trace.angles import sine_and_cosine
from rna_trace.vectors import Vector, along, dot, tangents_of, unit, vector_at

# Places in a mixture's numbers. Shares: of the broad lobe, which is the cosine lobe of surfaces
# and the forward lobe of fibers, and of the narrow ones; the uniform lobe has what they leave.
LOBES = len(Mixture().lobes)
IS_FIBER, SHARES, WIDTHS = 0, 1, 1 + LOBES

BELOW_ONE = 1.0 - 2.0**-53


class Lobe(NamedTuple):
    """A lobe of a mixture: how often it is chosen, and how wide it is."""

    share: float
    width: float


NO_LOBE = Lobe(0.0, 1.0)


@dataclass(frozen=True)
class LobeMixture:
    """Shares and widths of the lobes; all directions alike have the share that these leave.

    Surfaces. cosine: about the normal, turned to the viewer. mirror: half vectors of GGX, those
    that the viewer sees; width: its alpha.
    Fibers. forward: about -wo, von Mises-Fisher with concentration 1 / width^2. cone: about the
    cone of specular reflection from a fiber, sine of inclination logistic with scale width about
    its value there, all azimuths alike.
    """

    cosine: float = 0.0
    mirror: tuple[Lobe, ...] = ()
    forward: Lobe = NO_LOBE
    cone: tuple[Lobe, ...] = ()

    @classmethod
    def of(cls, record: Mixture) -> LobeMixture:
        """The mixture that a package has of a part."""
        forward = record.forward
        return cls(
            cosine=record.cosine or 0.0,
            mirror=tuple(Lobe(lobe.share, lobe.width) for lobe in record.mirror),
            forward=Lobe(forward.share, forward.width) if forward else NO_LOBE,
            cone=tuple(Lobe(lobe.share, lobe.width) for lobe in record.cone),
        )

    @cached_property
    def numbers(self) -> np.ndarray:
        """For compiled code, (1 + 2 LOBES,) float64: is it of fibers, then shares, then widths."""
        is_fiber = bool(self.cone) or self.forward.share > 0.0
        broad = self.forward if is_fiber else Lobe(self.cosine, 1.0)
        narrow = self.cone if is_fiber else self.mirror
        lobes = [broad, *narrow, *[NO_LOBE] * (LOBES - 1 - len(narrow))]
        shares, widths = zip(*lobes, strict=True)
        return np.array([is_fiber, *shares, *widths], np.float64)

    @property
    def everywhere(self) -> PlacedLobes:
        """This mixture at any points."""
        return PlacedLobes(self.numbers[None], None)


class PlacedLobes(NamedTuple):
    """The mixtures at points.

    numbers: (k, 1 + 2 LOBES) float64, of the mixtures. which: (m,) int64, of each point; None for
    the first one at all of them.
    """

    numbers: np.ndarray
    which: np.ndarray | None

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
        _sample(self.numbers, self._which(n), n, tangents, wo, _rows(row, n), u, wi)
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
        _pdf(self.numbers, self._which(n), n, tangents, wo, _rows(row, n), wi, pdf)
        return pdf

    def _which(self, points: np.ndarray) -> np.ndarray:
        return np.zeros(len(points), np.int64) if self.which is None else self.which


class PartLobes(NamedTuple):
    """The mixtures of a part. numbers: as of `PlacedLobes`. firsts: the first triangle of each."""

    numbers: np.ndarray
    firsts: np.ndarray

    @classmethod
    def of(cls, mixtures: Sequence[Mixture]) -> PartLobes:
        """Lobes that a package has for a part."""
        numbers = np.stack([LobeMixture.of(mixture).numbers for mixture in mixtures])
        return cls(numbers, np.array([mixture.first for mixture in mixtures]))

    def at(self, triangle: np.ndarray) -> PlacedLobes:
        """At points on triangles, (m,) of their numbers."""
        if len(self.firsts) == 1:
            return PlacedLobes(self.numbers, None)
        return PlacedLobes(self.numbers, np.searchsorted(self.firsts, triangle, side="right") - 1)


def _rows(row: np.ndarray | None, points: np.ndarray) -> np.ndarray:
    return np.arange(len(points)) if row is None else row


Frame = tuple[Vector, Vector, Vector]
"""The results of `lobe_frame`."""


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
def _mirrored(o: Vector, normal: Vector, alpha: float, u1: float, u2: float) -> Vector:
    """wo mirrored at a half vector that is seen from there."""
    s, t = tangents_of(normal)
    local = sample_reflection(alpha, dot(s, o), dot(t, o), dot(normal, o), u2, u1)
    return along(normal, local[0], local[1], local[2])


@compiled(inline=True, fastmath=())
def _mirrored_pdf(o: Vector, normal: Vector, alpha: float, w: Vector) -> float:
    """Density of `_mirrored` in w."""
    h = (o[0] + w[0], o[1] + w[1], o[2] + w[2])
    nh = dot(normal, unit(h))
    return reflected_density(alpha, dot(normal, o), min(nh, 1.0)) if nh > 0.0 else 0.0


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
    """Frame of a point for the functions below: viewer, normal turned to it, and tangent."""
    up = (0.0, 1.0, 0.0)
    o, normal = unit(o), _unit_or(n[0], n[1], n[2], up)
    if dot(normal, o) < 0.0:
        normal = (-normal[0], -normal[1], -normal[2])
    return o, normal, _unit_or(tangent[0], tangent[1], tangent[2], up)


@compiled(inline=True, fastmath=())
def lobe_sample(numbers: np.ndarray, frame: Frame, u1: float, u2: float) -> Vector:
    """A direction, as often as `lobe_density` says: three float64. u1 chooses the lobe, too."""
    o, normal, tangent = frame
    lobe, left = 0, u1
    while lobe < LOBES and left >= numbers[SHARES + lobe]:
        left -= numbers[SHARES + lobe]
        lobe += 1
    width = numbers[WIDTHS + min(lobe, LOBES - 1)]
    if lobe == LOBES:
        rest = max(u1 - left, 0.0)  # the shares before
        axis, cosine = normal, 1.0 - 2.0 * min(left / (1.0 - rest), BELOW_ONE)
    else:
        u1 = min(left / numbers[SHARES + lobe], BELOW_ONE)
        if numbers[IS_FIBER] == 0.0:
            if lobe > 0:
                return unit(_mirrored(o, normal, width, u1, u2))
            axis, cosine = normal, np.sqrt(1.0 - u1)
        elif lobe == 0:
            axis, cosine = (-o[0], -o[1], -o[2]), _fisher_cosine(u1, 1.0 / (width * width))
        else:
            axis, cosine = tangent, _cone_sine(u1, -dot(tangent, o), width)
    return unit(_about(axis, cosine, u2))


@compiled(inline=True, fastmath=())
def lobe_density(numbers: np.ndarray, frame: Frame, w: Vector) -> float:
    """Density per steradian in w."""
    o, normal, tangent = frame
    density, rest = 0.0, 1.0
    for lobe in range(LOBES):
        share, width = numbers[SHARES + lobe], numbers[WIDTHS + lobe]
        rest -= share
        if share == 0.0:
            continue
        if numbers[IS_FIBER] == 0.0:
            if lobe == 0:
                density += share * max(0.0, dot(normal, w)) / np.pi
            else:
                density += share * _mirrored_pdf(o, normal, width, w)
        elif lobe == 0:
            density += share * _fisher_pdf(-dot(o, w), 1.0 / (width * width))
        else:
            density += share * _cone_pdf(dot(tangent, w), -dot(tangent, o), width)
    return density + max(rest, 0.0) / (4.0 * np.pi)


@compiled(rows="row u wi", fastmath=())
def _sample(
    numbers: np.ndarray,
    which: np.ndarray,
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
        wi[i, 0], wi[i, 1], wi[i, 2] = lobe_sample(numbers[which[at]], frame, u[i, 0], u[i, 1])


@compiled(rows="row wi pdf", fastmath=())
def _pdf(
    numbers: np.ndarray,
    which: np.ndarray,
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
        pdf[i] = lobe_density(numbers[which[at]], frame, vector_at(wi, i))

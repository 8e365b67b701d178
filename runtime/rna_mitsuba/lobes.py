"""Directions for rays that leave assets, with their density: the lobes of rna-run in Dr.Jit.

Surfaces: the cosine lobe on the viewer's side, and half vectors of GGX. Fibers: a lobe about -wo,
and cones about the tangent that specular reflection and transmission lie on. All directions alike
have the share that these leave; see rna_render.world.neural_sampling.
"""

from dataclasses import dataclass
from typing import ClassVar

import drjit as dr
import mitsuba as mi

from rna_sdk.package import Mixture

LOBES = len(Mixture().lobes)


class PointMixture:
    """Shares and widths of the lobes at points, by their triangles."""

    DRJIT_STRUCT: ClassVar = {
        "is_fiber": mi.Bool,
        **{f"share_{k}": mi.Float for k in range(LOBES)},
        **{f"width_{k}": mi.Float for k in range(LOBES)},
    }

    @classmethod
    def of(cls, mixture: Mixture, kind: str) -> "PointMixture":
        """The same at all points. kind: of the part."""
        result = cls()
        result.is_fiber = mi.Bool(kind == "fiber")
        for k, (share, width) in enumerate(mixture.lobes):
            setattr(result, f"share_{k}", mi.Float(share))
            setattr(result, f"width_{k}", mi.Float(width))
        return result

    @property
    def lobes(self) -> list[tuple[mi.Float, mi.Float]]:
        """Share and width of each."""
        return [(getattr(self, f"share_{k}"), getattr(self, f"width_{k}")) for k in range(LOBES)]


@dataclass
class Lobes:
    """The lobes at points; everything in one space, unit.

    axis: normal of surfaces, tangent of fibers; zero counts as some direction.
    """

    mixture: PointMixture
    axis: mi.Vector3f
    wo: mi.Vector3f

    def __post_init__(self) -> None:
        self.is_fiber = self.mixture.is_fiber
        self.axis = dr.select(dr.dot(self.axis, self.axis) > 0.25, self.axis, mi.Vector3f(0, 1, 0))
        cosine = dr.dot(self.axis, self.wo)
        turned = dr.select(cosine < 0, -self.axis, self.axis)
        self.axis = dr.select(self.is_fiber, self.axis, turned)
        self.middle = -cosine  # sine of inclination of the cone
        self.up = dr.clip(dr.abs(cosine), 0, 1)

    def sample(self, choice: mi.Float, u: mi.Point2f) -> mi.Vector3f:
        """Unit directions from three numbers in [0, 1)."""
        axis, cosine = mi.Vector3f(self.axis), mi.Float(1 - 2 * u.x)
        mirrored, alpha, below = mi.Bool(False), mi.Float(1), mi.Float(0)
        for k, (share, width) in enumerate(self.mixture.lobes):
            here = (choice >= below) & (choice < below + share)
            below = below + share
            if k == 0:
                forward = here & self.is_fiber
                straight = _fisher(u.x, 1 / dr.square(width))
                cosine = dr.select(
                    here, dr.select(self.is_fiber, straight, dr.sqrt(1 - u.x)), cosine
                )
                axis = dr.select(forward, -self.wo, axis)
            else:
                cosine = dr.select(here & self.is_fiber, self._cone_sine(u.x, width), cosine)
                mirrored |= here & ~self.is_fiber
                alpha = dr.select(here, width, alpha)
        sine = dr.sqrt(dr.maximum(0, 1 - cosine * cosine))
        s, c = dr.sincos(2 * dr.pi * u.y)
        wi = mi.Frame3f(axis).to_world(mi.Vector3f(sine * c, sine * s, cosine))
        return dr.normalize(dr.select(mirrored, self._mirrored(alpha, u), wi))

    def pdf(self, wi: mi.Vector3f) -> mi.Float:
        """Density of `sample` in unit wi, per steradian."""
        pdf, rest = mi.Float(0), mi.Float(1)
        for k, (share, width) in enumerate(self.mixture.lobes):
            rest = rest - share
            if k == 0:
                surface = dr.maximum(0, dr.dot(self.axis, wi)) / dr.pi
                fiber = _fisher_pdf(-dr.dot(self.wo, wi), 1 / dr.square(width))
            else:
                surface = self._mirrored_pdf(wi, width)
                fiber = self._cone_pdf(dr.dot(self.axis, wi), width)
            pdf += dr.select(share > 0, share * dr.select(self.is_fiber, fiber, surface), 0)
        return pdf + dr.maximum(rest, 0) / (4 * dr.pi)

    def _mirrored(self, alpha: mi.Float, u: mi.Point2f) -> mi.Vector3f:
        """Reflected at a half vector of GGX that wo sees; Dupuy and Benyoub, Sampling Visible GGX
        Normals with Spherical Caps (HPG 2023)."""
        frame = mi.Frame3f(self.axis)
        o = frame.to_local(self.wo)
        stretched = dr.normalize(mi.Vector3f(alpha * o.x, alpha * o.y, o.z))
        height = u.x * (1 + stretched.z)
        z = height - stretched.z
        radius = dr.sqrt(dr.maximum(0, 1 - z * z))
        s, c = dr.sincos(2 * dr.pi * u.y)
        across = mi.Vector2f(radius * c + stretched.x, radius * s + stretched.y)
        h = dr.normalize(mi.Vector3f(alpha * across.x, alpha * across.y, dr.maximum(height, 1e-20)))
        return frame.to_world(2 * dr.dot(o, h) * h - o)

    def _mirrored_pdf(self, wi: mi.Vector3f, alpha: mi.Float) -> mi.Float:
        h = self.wo + wi
        size, cosine = dr.squared_norm(h), dr.dot(self.axis, h)
        a2 = dr.square(alpha)
        spread = dr.squared_norm(h - cosine * self.axis) + a2 * dr.square(cosine)
        root = dr.sqrt(a2 + (1 - a2) * dr.square(self.up))
        pdf = a2 * dr.square(size) / (2 * dr.pi * dr.square(spread) * (self.up + root))
        return dr.select((cosine > 0) & (size > 1e-12), pdf, 0)

    def _cone_limits(self, scale: mi.Float) -> tuple[mi.Float, mi.Float]:
        return _logistic((-1 - self.middle) / scale), _logistic((1 - self.middle) / scale)

    def _cone_sine(self, u: mi.Float, scale: mi.Float) -> mi.Float:
        """Sine of inclination: logistic about the middle, cut off at -1 and 1."""
        low, high = self._cone_limits(scale)
        p = dr.clip(low + u * (high - low), 1e-7, 1 - 1e-7)
        return dr.clip(self.middle + scale * dr.log(p / (1 - p)), -1, 1)

    def _cone_pdf(self, sine: mi.Float, scale: mi.Float) -> mi.Float:
        low, high = self._cone_limits(scale)
        p = _logistic((sine - self.middle) / scale)
        return p * (1 - p) / (scale * (high - low) * 2 * dr.pi)


def _fisher(u: mi.Float, kappa: mi.Float) -> mi.Float:
    """Cosine to the axis of a von Mises-Fisher direction; Jakob, Numerically stable sampling of
    the von Mises-Fisher distribution on S2 (2012)."""
    return dr.maximum(-1, 1 + dr.log(u + (1 - u) * dr.exp(-2 * kappa)) / kappa)


def _fisher_pdf(cosine: mi.Float, kappa: mi.Float) -> mi.Float:
    scale = kappa / (2 * dr.pi * (1 - dr.exp(-2 * kappa)))
    return scale * dr.exp(kappa * (cosine - 1))


def _logistic(x: mi.Float) -> mi.Float:
    return 1 / (1 + dr.exp(-x))

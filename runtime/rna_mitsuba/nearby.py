"""Nearby light (spec/RNA.md, 7.3) in Dr.Jit; `tests/reference/nearby.py` has it in numpy."""

from __future__ import annotations

import drjit as dr
import mitsuba as mi

from rna_mitsuba.tracing import PackageScene

_FAR = 2.0  # times the diagonal of the asset: where columns of distant light begin


def nearby_estimate(
    scene: PackageScene,
    lengths: tuple[float, float, float],
    x: mi.Point3f,
    wi: mi.Vector3f,
    far: mi.Float,
    u: mi.Point2f,
    active: mi.Bool,
) -> mi.Vector3f:
    """An unbiased estimate by one ray a lane, object space; far: distance of the light."""
    x, wi, far = dr.detach(x), dr.detach(wi), dr.detach(far)
    scaled = 3 * u.x
    k = dr.minimum(mi.UInt32(scaled), 2)
    length = dr.select(k == 0, lengths[0], dr.select(k == 1, lengths[1], lengths[2]))
    rho = length * _gamma_quantile(scaled - mi.Float(k))
    sine, cosine = dr.sincos(2 * dr.pi * u.y)
    reach = dr.minimum(far, _FAR * scene.diagonal)
    beside = mi.Frame3f(wi).to_world(mi.Vector3f(rho * cosine, rho * sine, reach))
    height = reach - scene.first_opaque(x + beside, -wi, active)
    met = active & dr.isfinite(height)
    distance = dr.sqrt(dr.square(rho) + dr.square(dr.select(met, height, 0)))
    density = mi.Float(0)
    for one in lengths:
        density += dr.exp(-rho / one) / (3 * one**2)
    weights = (dr.exp(-distance / one) / one**2 for one in lengths)
    return dr.select(met, mi.Vector3f(*weights) / density, 0)


def _gamma_quantile(share: mi.Float) -> mi.Float:
    """r with 1 - (1 + r) exp(-r) = share, of the Gamma distribution of shape 2."""
    c = dr.sqrt(-2 * dr.log(1 - dr.minimum(share, 1 - 2**-24)))
    rest = 0.0278336 + c * (-0.00385199 + c * (0.00038292 + c * (-2.2748e-05 + c * 5.68073e-07)))
    return c * (1 + c * (1 / 3 + c * rest))

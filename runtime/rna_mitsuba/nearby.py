"""Nearby light (spec/RNA.md, 7.3) in Dr.Jit; `tests/reference/nearby.py` has it in numpy."""

import drjit as dr
import mitsuba as mi

from rna_mitsuba.tracing import PackageScene

_OF_LENGTHS, _SHAPE = 1.2, 1.5  # of the distances of columns: spec/RNA.md, 7.3
_LEAST = 2**-24  # of a random number
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
    share = dr.clip(u.x, _LEAST, 1 - _LEAST)
    median = _OF_LENGTHS * (lengths[0] * lengths[2]) ** 0.5
    rho = median * (share / (1 - share)) ** (1 / _SHAPE)
    sine, cosine = dr.sincos(2 * dr.pi * u.y)
    reach = dr.minimum(far, _FAR * scene.diagonal)
    beside = mi.Frame3f(wi).to_world(mi.Vector3f(rho * cosine, rho * sine, reach))
    height = reach - scene.first_opaque(x + beside, -wi, active)
    met = active & dr.isfinite(height)
    distance = dr.sqrt(dr.square(rho) + dr.square(dr.select(met, height, 0)))
    density = _SHAPE * share * (1 - share)
    weights = (dr.exp(-distance / one) * dr.square(rho / one) for one in lengths)
    return dr.select(met, mi.Vector3f(*weights) / density, 0)

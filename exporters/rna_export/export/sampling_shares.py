"""Shares of lobes of many widths, and the few of them that a package has."""

import numpy as np
from numpy.typing import NDArray

from rna_render.world.neural_sampling import Lobe, LobeMixture
from rna_sdk.package.limits import MAX_NARROW_LOBES
from rna_sdk.package.manifest.extensions import FiberLobe, MirrorLobe, Mixture
from rna_sdk.package.manifest.manifest_fields import Kind

Array = NDArray[np.float64]

STEPS = 200
_LEAST_UNIFORM, _LEAST = 0.02, 0.005  # shares: of all directions, and of a lobe that is kept

_ALPHAS = np.geomspace(2e-4, 0.5, 16)
_CONES = np.geomspace(0.02, 0.3, 7)
_FORWARD = 0.15, 0.25, 0.4, 0.7
LOBES: dict[Kind, list[LobeMixture]] = {
    "surface": [
        LobeMixture(),
        LobeMixture(cosine=1.0),
        *(LobeMixture(mirror=(Lobe(1.0, alpha),)) for alpha in _ALPHAS),
    ],
    "fiber": [
        LobeMixture(),
        *(LobeMixture(forward=Lobe(1.0, width)) for width in _FORWARD),
        *(LobeMixture(cone=(Lobe(1.0, width),)) for width in _CONES),
    ],
}
"""Mixtures of one lobe each, which are mixed; the uniform one is first."""


def fitted_shares(kind: Kind, weight: Array, densities: Array, steps: int = STEPS) -> Array:
    """Shares of LOBES with the least sum of weight / density that a package may have: (lobes,).

    weight: (k,), positive. densities: (k, lobes), of each lobe.
    """
    kept, shares = np.arange(densities.shape[1]), np.ones(densities.shape[1])
    while True:
        shares = _shares(weight, densities[:, kept], shares, steps)
        fewer = _worth_keeping(kind, kept, shares)
        if fewer.all():
            result = np.zeros(densities.shape[1])
            result[kept] = shares
            return result
        kept, shares = kept[fewer], shares[fewer]


def _shares(weight: Array, densities: Array, start: Array, steps: int) -> Array:
    """By a multiplicative algorithm of optimal design that never ascends (Silvey, Titterington and
    Torsney 1978)."""
    shares: Array = start / start.sum()
    for _ in range(steps):
        shares = shares * np.sqrt((weight / np.square(densities @ shares)) @ densities)
        shares /= shares.sum()
        shares[0] = max(shares[0], _LEAST_UNIFORM)
        shares[1:] *= (1.0 - shares[0]) / max(shares[1:].sum(), 1e-30)
    return shares


def _worth_keeping(kind: Kind, kept: NDArray[np.int64], shares: Array) -> NDArray[np.bool_]:
    """Which lobes stay: all with some share, then of a form as many as a package may have."""
    stay = shares >= _LEAST
    stay[0] = True
    forms = [_form(LOBES[kind][k]) for k in kept.tolist()]
    for form, most in (("mirror", MAX_NARROW_LOBES), ("cone", MAX_NARROW_LOBES), ("forward", 1)):
        of_form = [k for k, name in enumerate(forms) if name == form and stay[k]]
        if stay.all() and len(of_form) > most:
            stay[min(of_form, key=lambda k: shares[k])] = False
    return stay


def _form(lobe: LobeMixture) -> str:
    """Form of the lobe of a mixture of one lobe."""
    if lobe.forward.share:
        return "forward"
    return "mirror" if lobe.mirror else "cone" if lobe.cone else "broad"


def mixture_of(kind: Kind, shares: Array, first: int = 0) -> Mixture:
    """Shares of LOBES as a package has them."""
    rounded = [round(share, 4) for share in shares.tolist()]
    found = [(lobe, share) for lobe, share in zip(LOBES[kind], rounded, strict=True) if share]
    mirrors = [(m.mirror[0].width, share) for m, share in found if m.mirror]
    cones = [(m.cone[0].width, share) for m, share in found if m.cone]
    forward = [(m.forward.width, share) for m, share in found if m.forward.share]
    return Mixture(
        first=first,
        cosine=next((share for lobe, share in found if lobe.cosine), None),
        mirror=tuple(MirrorLobe(share=share, width=_digits(width)) for width, share in mirrors),
        forward=next((FiberLobe(share=share, width=width) for width, share in forward), None),
        cone=tuple(FiberLobe(share=share, width=_digits(width)) for width, share in cones),
    )


def _digits(width: float) -> float:
    return float(f"{width:.3g}")

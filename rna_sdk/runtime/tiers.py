"""Which of a package's tiers to evaluate."""

from __future__ import annotations

import math

from rna_sdk.errors import QueryError
from rna_sdk.package import Package, Tier


def choose_tier(package: Package, name: str | None, min_psnr: float | None) -> Tier:
    """The tier of this name; or the cheapest that reaches min_psnr; or the first.

    min_psnr: dB. Cheapest is fewest multiply-adds a query, which no machine or load changes,
    those of an int8 decoder counted half; among equals the package's order decides. A tier
    without a recorded validation reaches no limit, and one without a recorded cost counts as
    dearest.

    Raises:
        QueryError: both choices are given, or no tier is as asked.
    """
    if name is not None and min_psnr is not None:
        raise QueryError("tier and min_psnr: give one of them, not both")
    if name is not None:
        return package.tier(name)
    tiers = package.manifest.tiers
    return tiers[0] if min_psnr is None else _cheapest(tiers, min_psnr)


def _cheapest(tiers: tuple[Tier, ...], min_psnr: float) -> Tier:
    if not isinstance(min_psnr, int | float):
        raise QueryError(f"min_psnr: expected a number of dB, found {min_psnr!r}")
    good = [tier for tier in tiers if _psnr(tier) >= min_psnr]
    if not good:
        recorded = ", ".join(
            f"{tier.name} {tier.validation.psnr:g} dB" if tier.validation else f"{tier.name} none"
            for tier in tiers
        )
        raise QueryError(f"min_psnr: found no tier of {min_psnr:g} dB; recorded are: {recorded}")
    return min(good, key=_work)


def _work(tier: Tier) -> float:
    """Multiply-adds of a query, as many float32 ones as take about as long.

    Measured, the whole of a query with an int8 decoder is 1.7 to 4 times as fast as in float32,
    the more the wider (docs/decisions.md).
    """
    if tier.cost is None:
        return math.inf
    return tier.cost.multiply_adds * (0.5 if tier.decoder_precision == "int8" else 1.0)


def _psnr(tier: Tier) -> float:
    return tier.validation.psnr if tier.validation else -math.inf

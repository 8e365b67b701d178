"""Selection of one of a package's tiers."""

import math
from collections.abc import Callable

import numpy as np

from rna_sdk.errors import QueryError
from rna_sdk.package import Package, Tier

_SAME_PSNR = 0.1  # dB


def choose_tier(
    package: Package,
    name: str | None = None,
    min_psnr: float | None = None,
    max_error: float | None = None,
    pixels: float | None = None,
    variant: str | None = None,
) -> Tier:
    """The tier of this name; or the cheapest within a limit; or, with neither, the first.

    min_psnr: smallest recorded PSNR, dB. max_error: largest mean FLIP, as `expected_error` for
    `pixels`. Cheapest is fewest multiply-adds per query, those of int8 decoders counted half, so
    that the choice is the same on all machines; ties go to the package's first. A tier without a
    recorded validation meets no limit; one without a recorded cost is chosen last.
    variant: the variant to be shown, for which the tier must have base colour.

    Raises:
        QueryError: more than one criterion is given, no tier meets it, a limit is not a number, or
            the tier has no base colour for the variant.

    Examples:
        >>> with Package.open("toy.rna") as package:
        ...     choose_tier(package, max_error=0.09, pixels=60).name
        'small'
    """
    if sum(choice is not None for choice in (name, min_psnr, max_error)) > 1:
        raise QueryError("tier, min_psnr and max_error: give only one of them")
    tier = _chosen(package, name, min_psnr, max_error, pixels)
    if variant is not None and not any(part.uses_base_color for part in tier.parts):
        raise QueryError(f"variant {variant!r}: tier {tier.name!r} has no base colour")
    return tier


def _chosen(
    package: Package,
    name: str | None,
    min_psnr: float | None,
    max_error: float | None,
    pixels: float | None,
) -> Tier:
    if name is not None:
        return package.tier(name)
    tiers = package.manifest.tiers
    if min_psnr is not None:
        limit = _number("min_psnr", min_psnr, "dB")
        request = f"min_psnr: found no tier of {limit:g} dB"
        return _cheapest(tiers, lambda tier: _psnr(tier) >= limit, request, _psnr, " dB")
    if max_error is not None:
        limit = _number("max_error", max_error, "mean FLIP")
        height = image_height(pixels)
        at = f" at {height:.0f} pixels" if height < math.inf else ""
        request = f"max_error: found no tier within {limit:g}{at}"

        def error(tier: Tier) -> float:
            return expected_error(tier, height)

        return _cheapest(tiers, lambda tier: error(tier) <= limit, request, error)
    return tiers[0]


def expected_error(tier: Tier, pixels: float | None = None) -> float:
    """Mean FLIP of the tier for an asset that is `pixels` high in the image; inf if not recorded.

    pixels: height of the sphere about the package's bounds; None, or more than the validation
    images have, means their full height. Between recorded heights the error is interpolated
    linearly in the logarithm of the height; below the smallest it is constant.

    Raises:
        QueryError: `pixels` is negative or not a number.

    Examples:
        >>> tier = load("toy.rna").tier
        >>> expected_error(tier, 40) < expected_error(tier) < 0.1
        True
    """
    validation = tier.validation
    height = image_height(pixels)
    if validation is None:
        return math.inf
    table = validation.flip_at_height[::-1]
    if not table:
        return validation.flip
    heights = [math.log(at.height) for at in table]
    return float(np.interp(math.log(max(height, 1.0)), heights, [at.flip for at in table]))


def is_no_worse(tier: Tier, other: Tier) -> bool:
    """Whether the tier's recorded PSNR is at least the other's, to within 0.1 dB.

    Examples:
        >>> tier = load("toy.rna").tier
        >>> is_no_worse(tier, tier)
        True
    """
    return tier.validation is not None and _psnr(tier) >= _psnr(other) - _SAME_PSNR


def _cheapest(
    tiers: tuple[Tier, ...],
    is_good: Callable[[Tier], bool],
    request: str,
    measure: Callable[[Tier], float],
    unit: str = "",
) -> Tier:
    good = [tier for tier in tiers if is_good(tier)]
    if not good:
        recorded = ", ".join(
            f"{tier.name} {measure(tier):.3g}{unit}" if tier.validation else f"{tier.name} none"
            for tier in tiers
        )
        raise QueryError(f"{request}; recorded are: {recorded}")
    return min(good, key=_work)


def _work(tier: Tier) -> float:
    """Multiply-adds per query; int8 decoders count half.

    Half is between the measured extremes: a query with an int8 decoder takes 1/1.05 (AVX2, width
    64) to 1/5 (AVX-512 VNNI, width 512) of the time in float32 (docs/results.md).
    """
    if tier.cost is None:
        return math.inf
    is_int8 = all(part.decoder_precision == "int8" for part in tier.parts)
    return tier.cost.multiply_adds * (0.5 if is_int8 else 1.0)


def _number(name: str, value: object, unit: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise QueryError(f"{name}: expected a number of {unit}, found {value!r}")
    return value


def image_height(pixels: float | None) -> float:
    """`pixels`, infinity for None. Raises QueryError: negative or not a number."""
    if pixels is None or pixels == math.inf:
        return math.inf
    if not _number("pixels", pixels, "pixels") >= 0.0:
        raise QueryError(f"pixels: expected 0 or more, found {pixels!r}")
    return pixels


def _psnr(tier: Tier) -> float:
    return tier.validation.psnr if tier.validation else -math.inf

"""From the file of a package to an asset that can be evaluated."""

from __future__ import annotations

from os import PathLike

from rna_sdk.package import Package, Tier
from rna_sdk.runtime.arguments import thread_count
from rna_sdk.runtime.asset import CompositeAsset
from rna_sdk.runtime.fiber_asset import FiberAsset
from rna_sdk.runtime.surface_asset import SurfaceAsset
from rna_sdk.runtime.tiers import choose_tier, image_height


def load(
    path: str | PathLike[str],
    tier: str | None = None,
    threads: int | None = None,
    *,
    min_psnr: float | None = None,
    max_error: float | None = None,
    pixels: float | None = None,
) -> SurfaceAsset | FiberAsset | CompositeAsset:
    """Open the package at `path` for evaluation. Its planes stay in the file, mapped to memory.

    A package of one part gives that part, as its kind says; one of several a CompositeAsset, whose
    `parts` are such.

    tier: name of a tier; None takes the package's first.
    threads: threads of an evaluation; None takes one for each core this process may use.
    min_psnr: instead of a name: takes the tier with the fewest multiply-adds per query, those of
        an int8 decoder counted half, among those whose recorded validation PSNR is at least
        this many dB.
    max_error: likewise, whose recorded mean FLIP is at most this.
    pixels: how high the asset is in the image: the sphere about its bounds. A small asset is
        content with a cheaper tier (with max_error), and has the geometry of a proxy, if there is
        one for its size. None: as high as the validation images.

    Raises:
        PackageError: the file cannot be read or breaks the format.
        QueryError: there is no such tier, none is good enough, or an argument is no such value.

    Examples:
        >>> asset = load("toy.rna", min_psnr=30.0)
        >>> asset.tier.name
        'small'
        >>> asset.mesh.positions.dtype
        dtype('float32')
    """
    count = thread_count(threads)
    with Package.open(path) as package:
        record = choose_tier(package, tier, min_psnr, max_error, pixels)
        height = image_height(pixels)
        if len(package.manifest.parts) == 1:
            return _part(package, record, count, 0, package.manifest.name, height)
        parts = tuple(
            _part(package, record, count, k, part.name, height)
            for k, part in enumerate(package.manifest.parts)
        )
        return CompositeAsset(package.manifest.name, parts)


def _part(
    package: Package, tier: Tier, threads: int, part: int, name: str, pixels: float
) -> SurfaceAsset | FiberAsset:
    kind = package.manifest.parts[part].kind
    cls = SurfaceAsset if kind == "surface" else FiberAsset
    return cls(package, tier, threads, part, name, pixels)

"""Load a package for evaluation."""

from os import PathLike

from rna_sdk.errors import QueryError
from rna_sdk.machine.cpu import thread_count
from rna_sdk.package import Package
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
    variant: str | None = None,
) -> SurfaceAsset | FiberAsset | CompositeAsset:
    """Open the package at `path` for evaluation. The file may be replaced afterwards.

    A package of one part is returned as a SurfaceAsset or FiberAsset, one of several parts as a
    CompositeAsset with such `parts`.

    tier: name of a tier; None selects the package's first.
    threads: number of threads per evaluation; None uses all cores available to this process.
    min_psnr: dB. Instead of a name: selects the cheapest tier whose recorded validation PSNR is at
        least this. Cheapest is fewest multiply-adds per query, those of int8 decoders counted half.
    max_error: likewise, the cheapest tier whose recorded mean FLIP is at most this.
    pixels: height in the image of the sphere about the asset's bounds. For a small asset a cheaper
        tier meets `max_error`, and the geometry is a proxy's if the package has one for this
        size. None: as high as the validation images.
    variant: name of a variant of the base colours, see `Package.variants`; None: the default ones.

    Raises:
        PackageError: the file cannot be read or violates the format.
        QueryError: no tier has this name or is good enough, the package has no such variant, the
            tier has no base colour for it, or an argument is invalid.

    Examples:
        >>> asset = load("toy.rna", min_psnr=30.0)
        >>> asset.tier.name
        'small'
        >>> asset.mesh.positions.dtype
        dtype('float32')
    """
    if not isinstance(path, str | PathLike):
        raise QueryError(f"path: expected the name of a package, found {type(path).__name__}")
    count = thread_count(threads)
    with Package.open(path) as package:
        record = choose_tier(package, tier, min_psnr, max_error, pixels, variant)
        height, records = image_height(pixels), package.manifest.parts

        def part(k: int, name: str) -> SurfaceAsset | FiberAsset:
            kind = SurfaceAsset if records[k].kind == "surface" else FiberAsset
            return kind(package, record, count, k, name, height, variant)

        if len(records) == 1:
            return part(0, package.manifest.name)
        parts = tuple(part(k, of.name) for k, of in enumerate(records))
        return CompositeAsset(package.manifest.name, parts)

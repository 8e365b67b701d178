"""Loading of packages onto the GPU."""

from os import PathLike

from rna_gpu.asset import GpuAsset, GpuFiber, GpuSurface
from rna_gpu.device import Device, open_device
from rna_sdk.package import Package
from rna_sdk.package.manifest.manifest_fields import Kind
from rna_sdk.runtime import choose_tier


def load(
    path: str | PathLike[str],
    tier: str | None = None,
    device: Device | None = None,
    *,
    min_psnr: float | None = None,
    max_error: float | None = None,
) -> GpuSurface | GpuFiber | GpuAsset:
    """Open the package at `path` on a GPU.

    Args:
        path: the `.rna` file.
        tier: see `rna_sdk.runtime.load`.
        device: the GPU; None opens the fastest one.
        min_psnr: dB, see `rna_sdk.runtime.load`.
        max_error: mean FLIP, see `rna_sdk.runtime.load`.

    Returns:
        A `GpuSurface` or `GpuFiber` for a package of one part, else a `GpuAsset` with such `parts`.

    Raises:
        PackageError: the file cannot be read or violates the format.
        QueryError: no such tier.
        GpuError: no GPU, or the asset does not fit on it.

    Example:
        >>> asset = load("toy.rna", min_psnr=30.0)
        >>> visible, shadowed = asset.evaluate(positions, normals, wo, wi)
    """
    with Package.open(path) as package:
        record = choose_tier(package, tier, min_psnr, max_error)
        device = device or open_device()
        parts = package.manifest.parts
        names = [part.name for part in parts] if len(parts) > 1 else [package.manifest.name]
        kinds: dict[Kind, type[GpuSurface] | type[GpuFiber]]
        kinds = {"surface": GpuSurface, "fiber": GpuFiber}
        loaded = tuple(
            kinds[part.kind](device, package, record, k, name)
            for k, (part, name) in enumerate(zip(parts, names, strict=True))
        )
        if len(loaded) == 1:
            return loaded[0]
        return GpuAsset(package.manifest.name, record, loaded, device)

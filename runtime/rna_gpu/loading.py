"""From the file of a package to an asset on the GPU."""

from __future__ import annotations

from os import PathLike

from rna_gpu.asset import GpuAsset, GpuFiber, GpuPart, GpuSurface
from rna_gpu.device import Device, open_device
from rna_sdk.package import Package
from rna_sdk.runtime import choose_tier


def load(
    path: str | PathLike[str],
    tier: str | None = None,
    device: Device | None = None,
    *,
    min_psnr: float | None = None,
    max_error: float | None = None,
) -> GpuPart | GpuAsset:
    """Open the package at `path` on a GPU.

    A package of one part gives that part, a `GpuSurface` or `GpuFiber`; one of several a
    `GpuAsset`, whose `parts` are such. tier, min_psnr, max_error: as of `rna_sdk.runtime.load`.
    device: None opens the fastest one.

    Raises:
        PackageError: the file cannot be read or breaks the format.
        QueryError: there is no such tier, or a decoder is outside the decoder profile.
        GpuError: there is no GPU, or the asset does not fit on it.
    """
    with Package.open(path) as package:
        record = choose_tier(package, tier, min_psnr, max_error)
        device = device or open_device()
        parts = package.manifest.parts
        names = [part.name for part in parts] if len(parts) > 1 else [package.manifest.name]
        kinds = {"surface": GpuSurface, "fiber": GpuFiber}
        loaded = tuple(
            kinds[part.kind](device, package, record, k, name)
            for k, (part, name) in enumerate(zip(parts, names, strict=True))
        )
        if len(loaded) == 1:
            return loaded[0]
        return GpuAsset(package.manifest.name, record, loaded, device)

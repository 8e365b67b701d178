"""Poster, stand-in materials and compression of an exported package."""

from collections.abc import Callable, Sequence
from pathlib import Path

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.export.poster_rendering import render_poster
from rna_export.export.proxy import proxy_of
from rna_export.export.sampling_fit import fitted_sampling
from rna_export.export.standin_fit import textures_within
from rna_export.export.standin_textures import standin_material, textures_of
from rna_export.training.checkpoint import Trained
from rna_sdk.errors import ExportError
from rna_sdk.package import Package
from rna_sdk.package.geometry.geometry_files import Geometry
from rna_sdk.package.manifest.extensions import Standin, Variant, Variants
from rna_sdk.package.manifest.pictures import png_size
from rna_sdk.package.packing import Unpacked

_SHARDS = 12  # of training samples that a stand-in is estimated from


def add_extras(
    package: Path,
    dataset: Dataset,
    poster: Path | None,
    proxies: Sequence[int],
    deflate: bool,
    say: Callable[[str], None],
    source: bool = False,
    analytic: Sequence[Trained] | None = None,
) -> None:
    """Add poster, stand-ins, lobes for rays and proxies to the package; code it if `deflate`.

    poster: a PNG; None: one is rendered. proxies: their heights in pixels, each below the one
    before. source: whether to add the source's vertices. analytic: trainings that the stand-ins'
    textures are baked from, none for no textures; None: see `textures_within`. Raises ExportError
    where the poster is no PNG, the dataset does not have these vertices, or a training is not one
    of its analytic ones.
    """
    png = render_poster(package) if poster is None else _read_png(poster)
    materials = [standin_material(part.training_samples(_SHARDS)) for part in dataset.parts]
    standin = Standin(parts=tuple(materials))
    unpacked = Unpacked.read(package).with_poster(png).with_extension(standin, {})
    if (sampling := fitted_sampling(package, say)) is not None:
        unpacked = unpacked.with_extension(sampling, {})
    if analytic is None:
        textures = textures_within(dataset, package.stat().st_size, say)
    else:
        textures = _given(analytic, dataset, say)
    if any(textures):
        unpacked = unpacked.with_standin_textures(textures)
    if dataset.manifest.variants:
        unpacked = unpacked.with_extension(*variants_of(dataset))
    with Package.open(package) as opened:
        levels = [_proxies(opened, k, proxies, say) for k in range(len(materials))]
    if any(levels):
        unpacked = unpacked.with_proxies(levels)
    if source:
        result = [part.source_vertices() for part in dataset.parts]
        if not any(result):
            raise ExportError(
                f"{dataset.folder}: has no numbers of the source's vertices, expected a surface "
                "that is not cut, captured by this version (--source-vertices)"
            )
        unpacked = unpacked.with_source(result)
    (unpacked.deflated() if deflate else unpacked).write(package)


def _given(
    analytic: Sequence[Trained], dataset: Dataset, say: Callable[[str], None]
) -> list[dict[str, bytes] | None]:
    if not analytic:
        return []
    textures, lines = textures_of(analytic, dataset)
    say("\n".join([*lines, f"stand-in: textures of {sum(map(bool, textures))} parts"]))
    return textures


def variants_of(dataset: Dataset) -> tuple[Variants, dict[str, bytes]]:
    """The prints by name, and the images that they alone have."""
    names = dataset.manifest.variants
    files: dict[str, bytes] = {}
    for part in dataset.parts:
        files |= part.variant_files()
    changes = [[part.captured.variants[k] for part in dataset.parts] for k in range(len(names))]
    variants = (
        Variant(name=name, parts=tuple(one if any(one) else None for one in of_parts))
        for name, of_parts in zip(names, changes, strict=True)
    )
    return Variants(variants=tuple(variants)), files


def _proxies(
    package: Package, part: int, heights: Sequence[int], say: Callable[[str], None]
) -> list[tuple[Geometry, int]]:
    """The part's proxies with their heights, without those that save nothing."""
    record = package.manifest.parts[part]
    if not heights or record.kind != "surface":
        return []
    if record.transmittance or record.normal_maps or record.base_color:
        say(f"{record.name}: no proxy, its textures are mapped to its triangles")
        return []
    mesh = package.mesh(part)
    result: list[tuple[Geometry, int]] = []
    for pixels in heights:
        proxy = proxy_of(mesh, pixels)
        whole = f"{record.name}: {len(mesh.triangles):,} triangles"
        if proxy is None:
            say(f"{whole} are sufficient at {pixels} pixels, no proxy")
            continue
        say(f"{whole}, proxy at {pixels} pixels: {len(proxy.triangles):,}")
        result.append((proxy, pixels))
    return result


def _read_png(path: Path) -> bytes:
    try:
        data = path.read_bytes()
    except OSError as error:
        raise ExportError(f"{path}: found {error.strerror}, expected a PNG (--poster)") from error
    if png_size(data) is None:
        raise ExportError(f"{path}: found no PNG, expected one (--poster)")
    return data

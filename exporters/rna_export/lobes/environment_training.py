"""Lobes of a package's parts: trained from the package, measured, and written into a copy of it."""

import re
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from time import monotonic

import numpy as np
import torch
from tqdm import tqdm

from rna_export.lobes.lobe_error import generated_environments, grid_of, lobe_pictures
from rna_export.lobes.lobe_fit import exported_lobes, fit_lobes
from rna_export.lobes.lobe_model import LobeModel
from rna_export.lobes.lobe_queries import QueryRows
from rna_export.lobes.view_points import LobesAt, PartViews, Rows, ViewPoints, part_views
from rna_export.training.optimization.pace import StepPace, TimePace
from rna_render import read_environment
from rna_sdk.errors import ExportError
from rna_sdk.package import EnvironmentValidation, Lobes, Package, Unpacked
from rna_sdk.package.geometry.vertex_visibility import Harmonics
from rna_sdk.package.manifest.extensions import Deflate
from rna_sdk.runtime import Asset, FiberAsset, SurfaceAsset, load
from rna_work.bar import Bar

STEPS = 10_000
"""Training steps of all parts together."""
ROUGH_DB = 25.0
"""dB with bright directions, below which a user is warned that the look is rough."""

BAR = "{desc}: {percentage:3.0f}%|{bar}| {elapsed}<{remaining}"
"""Format of a progress bar whose total is 1."""

_TRAINED, _MEASURED = 0.8, 0.2  # shares of the time


def add_lobes(package: Path, out: Path, minutes: float, files: Sequence[Path]) -> list[str]:
    """Write a copy of a package with the form `environment`; returns lines that tell its error.

    out: may be the package itself, which stays as it was until the copy is whole. minutes: limit;
    a training takes STEPS steps, if they take no longer. files: environments to measure under,
    beside the generated ones. Lobes learn the default tier, and read its planes.

    Raises ExportError where nothing of the asset can be seen, or an exported decoder is not the
    trained one.
    """
    begun, environments = monotonic(), generated_environments() | _read(files)
    with Package.open(package) as opened:
        is_deflated = Deflate.NAME in opened.manifest.extensions_required
    unpacked = Unpacked.read(package)
    lines: list[str] = []
    with Bar(total=1.0, desc="environment", bar_format=BAR, mininterval=0.5) as bar:
        asset = load(package, threads=1)
        views = part_views(asset)
        lobes = _trained(
            package, asset, views, begun + _TRAINED * 60.0 * minutes, bar, lines.append
        )
        result = _measured(unpacked.with_environment(lobes), views, environments, bar)
    whole = unpacked.with_environment(lobes, result)
    (whole.deflated() if is_deflated else whole).write(out)
    return [*lines, *_told(result)]


def _trained(
    package: Path,
    asset: Asset,
    views: Sequence[PartViews],
    end: float,
    bar: tqdm,
    say: Callable[[str], None],
) -> list[Lobes | None]:
    """Lobes of each part; None for invisible parts. end: time limit, as `monotonic` has it."""
    seen = [k for k, one in enumerate(views) if not one.is_hidden]
    if not seen:
        raise ExportError(f"{package}: no ray from outside meets the asset; it needs no lobes")
    lobes: list[Lobes | None] = [None] * len(views)
    share, usual = _TRAINED / len(seen), max(STEPS // len(seen), 1)
    for k in sorted(set(range(len(views))) - set(seen)):
        say(f"environment: no lobes of {views[k].part.name}, which no viewer sees")
    for done, k in enumerate(seen):
        part_views, now = views[k], monotonic()
        with Package.open(package) as opened:
            queries = QueryRows(opened, asset.tier.name, k, part_views.visibility_columns)
        torch.manual_seed(k)
        model = LobeModel(queries.columns)
        seconds = max((end - now) / (len(seen) - done), 0.1)
        paces = StepPace(usual), TimePace(seconds, now)
        steps = fit_lobes(model, part_views, queries, paces, k, filling(bar, share))
        spent = f"{steps:,} of {usual:,} steps, {model.multiply_adds:,} multiply-adds a query"
        say(f"environment: lobes of {part_views.part.name}: {spent}")
        lobes[k] = exported_lobes(model, part_views, queries, asset.tier.name)
    return lobes


def _measured(
    package: Unpacked, views: Sequence[PartViews], environments: dict[str, np.ndarray], bar: tqdm
) -> list[EnvironmentValidation]:
    """Errors of a package's lobes, as the runtime answers."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "measured.rna"
        package.write(path)
        pairs = parts_with_lobes(load(path), [one.visibility for one in views])
        pictures = lobe_pictures(pairs, environments, grid_of(pairs), filling(bar, _MEASURED))
        return pictures.of_pixels().errors()


def parts_with_lobes(
    asset: Asset, visibility: Sequence[Harmonics | None] = ()
) -> list[tuple[PartViews, LobesAt]]:
    """The measurement by `lobe_pictures` of a loaded asset. visibility: as of `part_views`."""
    views = part_views(asset, visibility)
    return [
        (part_views, _lobes_of(part))
        for part_views, part in zip(views, asset.parts, strict=True)
        if part.environment_form is not None
    ]


def filling(bar: tqdm, share: float = 1.0) -> Callable[[float], None]:
    """Fills a share of a bar by parts of its work; sums may be rounded up."""
    return lambda part: bar.update(min(share * part, bar.total - bar.n))


def _lobes_of(part: SurfaceAsset | FiberAsset) -> LobesAt:
    def lobes(at: ViewPoints) -> tuple[Rows, Rows]:
        if isinstance(part, FiberAsset):
            return part.lobes(at.position, at.axis, at.h, at.wo, at.free, at.visibility)
        return part.lobes(at.position, at.axis, at.wo, at.free, at.visibility)

    return lobes


def _read(files: Sequence[Path]) -> dict[str, np.ndarray]:
    """Texels by name, which is made of the file's."""
    names = (re.sub("[^A-Za-z0-9]+", "-", path.stem).strip("-")[:64] for path in files)
    return {name or "file": read_environment(path) for name, path in zip(names, files, strict=True)}


def _told(result: Sequence[EnvironmentValidation]) -> list[str]:
    lines = [
        f"environment {one.environment}: PSNR {one.psnr_with_lights:.1f} dB, FLIP {one.flip:.3f}, "
        f"brightness {' '.join(f'{share:.2f}' for share in one.brightness)}; PSNR {one.psnr:.1f} "
        "dB without its brightest directions asked of the transport"
        for one in result
    ]
    worst = min(result, key=lambda one: one.psnr_with_lights)
    if worst.psnr_with_lights < ROUGH_DB:
        lines.append(
            f"warning: the first look by lobes is rough: {worst.psnr_with_lights:.1f} dB under "
            f"{worst.environment}, below {ROUGH_DB:g} dB; pictures converge to the asset's own all "
            "the same"
        )
    return lines

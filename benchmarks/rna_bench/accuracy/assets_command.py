"""Error of packages, in figures and words: the table of README.

    rna-bench assets toy.rna curls.rna --out benchmarks/results/assets.json

Takes what each package records of its tiers and prints a Markdown table. With --datasets, one for
each package, the error is measured anew on their validation images, and by itself for images lit
from the front and from behind: at least 120 degrees from the camera.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.bench_options import add_out
from rna_bench.results import write_results
from rna_export.albedo import albedo, white_views
from rna_export.asset_flip import DEFINITION, AssetFlip
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.validation_view import WholeView
from rna_export.capture.rays.capture_directions import BEHIND
from rna_export.training.asset_error import asset_error, worse_error
from rna_export.training.validation import mean_psnr
from rna_sdk.commands.error_words import error_in_words
from rna_sdk.errors import RnaError
from rna_sdk.package import Albedo, Package, Tier
from rna_sdk.runtime import Asset, load

Row = dict[str, Any]


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of the command."""
    parser.add_argument("packages", type=Path, nargs="+", help="packages (paths)")
    parser.add_argument(
        "--datasets",
        type=Path,
        nargs="+",
        metavar="FOLDER",
        help="dataset of each package, to measure on (paths, default: the records of the packages)",
    )
    add_out(parser)


def run(args: argparse.Namespace) -> None:
    """Print the table; write it as JSON."""
    datasets = args.datasets or [None] * len(args.packages)
    if len(datasets) != len(args.packages):
        found = f"{len(datasets)} datasets, {len(args.packages)} packages"
        raise RnaError(f"--datasets: found {found}; expected one for each")
    rows = [row for each in zip(args.packages, datasets, strict=True) for row in _rows(*each)]
    print(table(rows))
    if args.out:
        write_results(args.out, args.stamp, {"definition": DEFINITION, "assets": rows})
        print(f"wrote {args.out}")


def table(rows: Sequence[Row]) -> str:
    """Markdown."""
    heads = ["asset, tier", "FLIP", "95th percentile", "in words", "light", "PSNR", "ns/query"]
    lines = [f"| {' | '.join(heads)} |", "| --- " * len(heads) + "|"]
    for row in rows:
        words = error_in_words(row["flip"]).partition(":")[0]
        ns = f"{row['ns_per_query']:.0f}" if row["ns_per_query"] else "not measured"
        light = "not measured" if row["albedo"] is None else f"{row['albedo']['ratio']:.1%}"
        error = f"{row['flip']:.3f}", f"{row['flip_p95']:.2f}", words
        cells = [*error, light, f"{row['psnr']:.1f} dB", ns]
        lines.append(f"| {row['asset']}, `{row['tier']}` | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _rows(path: Path, folder: Path | None) -> list[Row]:
    """A row for each tier of a package."""
    with Package.open(path) as package:
        manifest = package.manifest
    dataset = None if folder is None else Dataset(folder)
    rows = []
    for tier in manifest.tiers:
        error = _recorded(path, tier) if dataset is None else _measured(path, tier, dataset)
        rows.append({"asset": manifest.name, "tier": tier.name, **_others(tier), **error})
    return rows


def _others(tier: Tier) -> Row:
    validation, cost = tier.validation, tier.cost
    return {
        "psnr": validation and validation.psnr,
        "ns_per_query": cost and cost.ns_per_query,
        "multiply_adds": cost and cost.multiply_adds,
    }


def _recorded(path: Path, tier: Tier) -> Row:
    validation = tier.validation
    if validation is None or validation.flip_p95 is None:
        found = f"{path}: found no FLIP of the asset's pixels of tier {tier.name}"
        raise RnaError(f"{found}; export it again, or give --datasets")
    error = AssetFlip(validation.flip, validation.flip_p95, validation.images)
    return {**_figures(error), "albedo": _albedo(validation.albedo)}


def _measured(path: Path, tier: Tier, dataset: Dataset) -> Row:
    asset, views = load(path, tier=tier.name), dataset.whole_views()
    radiance = [_shaded(asset, view) for view in views]
    emitted = [
        (view.shaded_by(part), view)
        for part, of_part in zip(asset.parts, dataset.parts, strict=True)
        for view in of_part.emission_views()
    ]
    lit = {}
    for name, is_behind in (("from_front", False), ("from_behind", True)):
        chosen = [k for k, view in enumerate(views) if (_cosine(view) <= BEHIND) == is_behind]
        if chosen:
            error = asset_error([radiance[k] for k in chosen], [views[k] for k in chosen])
            lit[name] = _figures(error)
    error = worse_error(asset_error(radiance, views), emitted)
    returned = None
    if (white := white_views(dataset.parts)) is not None:
        pairs = zip(asset.parts, white, strict=True)
        returned = albedo((view.shaded_by(part), view) for part, view in pairs)
    psnr = mean_psnr(radiance, views)
    return {**_figures(error), "albedo": _albedo(returned), "psnr": psnr, **lit}


def _albedo(returned: Albedo | None) -> Row | None:
    if returned is None:
        return None
    return {name: round(ratio, 4) for name, ratio in returned.model_dump().items()}


def _figures(error: AssetFlip) -> Row:
    figures = round(error.mean, 4), round(error.p95, 4), error.images
    return dict(zip(("flip", "flip_p95", "images"), figures, strict=True))


def _shaded(asset: Asset, view: WholeView) -> np.ndarray:
    pairs = zip(view.parts, asset.parts, strict=True)
    return np.concatenate([part.shaded_by(part_asset) for part, part_asset in pairs])


def _cosine(view: WholeView) -> float:
    """Cosine of the angle between light and camera at the middle of an image."""
    wo, wi = (np.concatenate([p.samples[name] for p in view.parts]) for name in ("wo", "wi"))
    to_eye = wo.mean(axis=0)
    return float(wi[0] @ to_eye / np.linalg.norm(to_eye))

"""PSNR of a package on validation images: as captured, and with the exposure of scenes.

    rna-bench exposure toy.rays --package examples/quickstart/toy.rna --out exposure.json

Under one light of irradiance pi most of an asset is dim; in a scene it fills the range, and the
same errors are larger. The exposure is that of `rna-bench scenes`.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.one_part import load_one_part
from rna_bench.options import add_out
from rna_bench.results import publish
from rna_bench.scenes.beside_cycles import EXPOSURE_DEFINITION, Beside
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.validation_view import ValidationView, is_lit
from rna_export.metrics import IRRADIANCE, WITHOUT_NOISE_DEFINITION, psnr_without_noise
from rna_sdk.package import Package


def run(args: argparse.Namespace) -> None:
    views = Dataset(args.dataset).only.validation_views()
    with Package.open(args.package) as package:
        names = [tier.name for tier in package.manifest.tiers]
    assets = {name: load_one_part(args.package, name) for name in names}
    report = {
        "package": args.package.name,
        "psnr": WITHOUT_NOISE_DEFINITION,
        "exposed": EXPOSURE_DEFINITION,
        "tiers": {
            name: [scores(view, view.shaded_by(asset)) for view in views]
            for name, asset in assets.items()
        },
    }
    publish(report, args)


def scores(view: ValidationView, shaded: np.ndarray) -> dict[str, Any]:
    """Scores of radiance (n, 3) of a view's rows. `exposure` scales the displayed image."""
    halves = np.stack([view.image(half) for half in view.halves])
    in_scene = Beside.of(halves, view.image(np.ones_like(shaded))[..., 0] > 0.0)
    return {
        "view": view.index,
        "lit": float(is_lit(view.visible).mean()),
        "psnr": psnr_without_noise(shaded, *view.halves).db,
        "exposure": in_scene.exposure / IRRADIANCE,
        "psnr_exposed": in_scene.psnr(view.image(shaded)).db,
    }


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("dataset", type=Path, help="capture of the asset, of one part")
    parser.add_argument("--package", type=Path, required=True, help="package of the asset")
    add_out(parser)

"""Gain of `rna-capture --for`: two captures of equal size, one of them for a scene.

    rna-capture examples/quickstart/toy.py --out with/toy.rays --for benchmarks/product_shot.yaml \\
        --lights 400 --samples 8
    rna-capture examples/quickstart/toy.py --out without/toy.rays --lights 400 --samples 8
    rna-train with/toy.rays --preset small --steps 12000 --out with/small
    rna-train without/toy.rays --preset small --steps 12000 --out without/small
    rna-bench for-scene --limited with/toy.rays with/small/best.ckpt \\
        --everywhere without/toy.rays without/small/best.ckpt \\
        --out benchmarks/results/for-scene-toy.json

Prints JSON: the error of both models on the validation images of both captures.
"""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.options import add_out
from rna_bench.results import publish
from rna_bench.scores import scores_of
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.rays.directions import light_direction
from rna_export.metrics import FLIP_DEFINITION, PSNR_DEFINITION
from rna_export.training.checkpoint import load_checkpoint
from rna_sdk.package.manifest.manifest_fields import Region
from rna_sdk.runtime import in_region


def run(args: argparse.Namespace) -> None:
    captures = {"limited": args.limited, "everywhere": args.everywhere}
    datasets = {name: Dataset(Path(paths[0])).only for name, paths in captures.items()}
    trained = {name: load_checkpoint(Path(paths[1])) for name, paths in captures.items()}
    domain = datasets["limited"].manifest.domain
    report: dict[str, Any] = {
        "source": datasets["limited"].manifest.source,
        "settings": {
            name: dataset.manifest.settings.model_dump() for name, dataset in datasets.items()
        },
        "steps": {name: one.steps for name, one in trained.items()},
        "share_of_views": share(domain.wo),
        "share_of_lights": share(domain.wi),
        "psnr": PSNR_DEFINITION,
        "flip": FLIP_DEFINITION,
        "in_the_domain": errors(trained, datasets["limited"]),
        "everywhere": errors(trained, datasets["everywhere"]),
    }
    publish(report, args)


def add_options(parser: argparse.ArgumentParser) -> None:
    for name in ("limited", "everywhere"):
        parser.add_argument(
            f"--{name}", nargs=2, required=True, metavar=("RAYS", "CKPT"), help="dataset, model"
        )
    add_out(parser)


def share(region: Region) -> float:
    """Fraction of all directions."""
    spread = np.array([light_direction(k, 0, "sphere") for k in range(20_000)])
    return float(in_region(region, spread).mean())


def errors(trained: dict[str, Any], dataset: DatasetPart) -> dict[str, dict[str, float]]:
    """Scores of each model on the dataset's validation images."""
    views = dataset.validation_views()
    return {name: asdict(scores_of(one.model, views)) for name, one in trained.items()}

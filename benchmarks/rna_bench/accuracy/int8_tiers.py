"""Accuracy and size of int8: one checkpoint in every precision.

    rna-bench int8-tiers runs/toy/best.ckpt --out benchmarks/results/quality-int8.json

Each checkpoint is exported with a tier for each pair of decoder and planes; the errors are those
of the dataset's validation images, evaluated by the runtime from the package. Sizes are of a
package with that tier alone.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from typing import Any

from rna_bench.bench_options import add_out
from rna_bench.results import publish
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.export.package_build import build_package
from rna_export.export.precision import Precision
from rna_export.metrics import FLIP_DEFINITION, PSNR_DEFINITION
from rna_export.training.checkpoint import load_checkpoint
from rna_sdk.package import Manifest, Tier

PAIRS = (
    Precision("float32", "float16"),
    Precision("int8", "float16"),
    Precision("float32", "int8"),
    Precision("int8", "int8"),
)


def run(args: argparse.Namespace) -> None:
    results: dict[str, Any] = {"psnr": PSNR_DEFINITION, "flip": FLIP_DEFINITION}
    results["checkpoints"] = [_measured(path) for path in args.checkpoints]
    for record in results["checkpoints"]:
        for tier in record["tiers"]:
            print(
                f"{record['asset']} {tier['name']}: {tier['psnr']:.2f} dB "
                f"({tier['psnr_lost']:+.2f} lost), FLIP {tier['flip']:.4f}, {tier['bytes']:,} bytes"
            )
    publish(results, args)


def _measured(checkpoint: Path) -> dict[str, Any]:
    trained = load_checkpoint(checkpoint)
    dataset = Dataset(trained.dataset)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "every.rna"
        manifest = build_package([trained], dataset, path, None, "NOASSERTION", print, PAIRS)
    return {
        "asset": dataset.manifest.name,
        "preset": trained.preset_name,
        "width": trained.preset.model.width,
        "tiers": [_record(manifest, tier) for tier in manifest.tiers],
    }


def _record(manifest: Manifest, tier: Tier) -> dict[str, Any]:
    """The tier's errors, and its loss against the first tier."""
    first, own = manifest.tiers[0].validation, tier.validation
    assert first is not None and own is not None  # the exporter validates every tier
    return {
        "name": tier.name,
        "psnr": round(own.psnr, 3),
        "psnr_lost": round(first.psnr - own.psnr, 3),
        "flip": round(own.flip, 5),
        "relative_mse": round(own.relative_mse, 5),
        "bytes": _bytes_alone(manifest, tier),
    }


def _bytes_alone(manifest: Manifest, tier: Tier) -> int:
    """Entries that a package with this tier alone has, without its manifest."""
    names = (manifest.parts[0].geometry, tier.parts[0].planes, tier.parts[0].decoder)
    return sum(manifest.entries[name].size for name in names)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("checkpoints", nargs="+", type=Path, help="checkpoints of rna-train")
    add_out(parser)

"""Train presets on one dataset for equal time and compare them on its validation images.

    rna-bench presets toy.rays --minutes 4 --presets small paper-small \\
        --runs runs/toy --out benchmarks/results/quality-toy.json

Trainings run sequentially in separate processes; use an otherwise idle machine.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

from rna_bench.results import write_results
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.metrics import FLIP_DEFINITION, PSNR_DEFINITION, psnr
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.validation import score, shade


def run(args: argparse.Namespace) -> None:
    dataset = Dataset(args.dataset).only
    results = {
        # What a source that is a script was given are paths of one machine.
        "dataset": dataset.manifest.model_dump(mode="json", by_alias=True, exclude={"arguments"}),
        "psnr": PSNR_DEFINITION,
        "flip": FLIP_DEFINITION,
        "minutes": args.minutes,
        "presets": _earlier(args.out, args.minutes),
    }
    for preset in args.presets:
        out = args.runs / preset
        command = [sys.executable, "-m", "rna_export.training.rna_train", str(args.dataset)]
        command += ["--preset", preset, "--out", str(out), "--minutes", str(args.minutes)]
        subprocess.run(command, check=True)
        results["presets"][preset] = _scores(out / "best.ckpt", dataset)
        write_results(args.out, args.stamp, results)
    for preset, result in results["presets"].items():
        print(f"{preset}: PSNR {result['psnr']:.2f} dB, FLIP {result['flip']:.4f}")
    print(f"wrote {args.out}")


def _earlier(path: Path, minutes: float) -> dict[str, Any]:
    """Results of other presets that an earlier call left, if they had the same time."""
    results: dict[str, Any] = json.loads(path.read_text()) if path.is_file() else {}
    return results["presets"] if results.get("minutes") == minutes else {}


def _scores(checkpoint: Path, dataset: DatasetPart) -> dict[str, object]:
    trained, views = load_checkpoint(checkpoint), dataset.validation_views()
    radiance = [shade(trained.model, view) for view in views]
    each = [psnr(r, view.samples["radiance"]) for r, view in zip(radiance, views, strict=True)]
    return {
        **asdict(score(radiance, views)),
        "psnr_of_each_image": each,
        "steps": trained.steps,
        "preset": trained.preset.model_dump(mode="json"),
    }


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("dataset", type=Path, help="dataset of rna-capture")
    parser.add_argument(
        "--presets", nargs="+", default=["small", "paper-small"], help="presets to train"
    )
    parser.add_argument("--minutes", type=float, default=4.0, help="minutes per training")
    parser.add_argument("--runs", type=Path, required=True, help="folder for the trainings")
    parser.add_argument("--out", type=Path, required=True, help="JSON to write")

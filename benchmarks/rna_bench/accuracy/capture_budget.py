"""Accuracy at a fixed number of paths, by paths per ray, rays per light, lights and planes.

    rna-bench capture-budget curly_ball.rays examples/fibers/curly_ball.py \
        --work budget/ --out benchmarks/results/capture-budget.json --chart docs/images/budget.png

Captures the source several times with the same number of paths, trains `small` on each with planes
of several resolutions, and scores all of them on the held-out validation images of the first
dataset. Existing captures and trainings are reused.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rna_bench.options import add_out
from rna_bench.plot_style import figure, save_chart
from rna_bench.results import publish
from rna_bench.scores import scores_of
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.memory import keep_freed_memory
from rna_export.metrics import WITHOUT_NOISE_DEFINITION
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.presets import PRESETS
from rna_export.training.training_run import Run, train

RESOLUTIONS = (16, 32, 128)


@dataclass(frozen=True)
class Plan:
    """One way to spend the paths."""

    samples: int  # paths a ray
    rays: int  # a light

    def lights(self, paths: float) -> int:
        return round(paths / (self.samples * self.rays))

    @property
    def name(self) -> str:
        return f"{self.samples} x {self.rays}"


PLANS = (
    Plan(1, 16384),
    Plan(2, 16384),
    Plan(4, 8192),
    Plan(16, 1024),
    Plan(16, 4096),
    Plan(64, 1024),
)


def run(args: argparse.Namespace) -> None:
    keep_freed_memory()
    views = Dataset(args.dataset).only.validation_views()
    rows = []
    for plan in PLANS:
        dataset = _capture(plan, args, args.script_arguments)
        for resolution in RESOLUTIONS:
            rows.append(_trained(plan, resolution, dataset, views, args))
    _draw(rows, args.chart)
    settings = {"paths": args.paths, "steps": args.steps, "psnr": WITHOUT_NOISE_DEFINITION}
    publish({**settings, "source": args.source.name, "rows": rows}, args)


def _capture(plan: Plan, args: argparse.Namespace, arguments: tuple[str, ...]) -> DatasetPart:
    out = args.work / f"{plan.samples}x{plan.rays}.rays"
    command = [sys.executable, "-m", "rna_export.capture.rna_capture", args.source, "--out", out]
    command += ["--samples", plan.samples, "--rays", plan.rays, "--lights", plan.lights(args.paths)]
    command += "--validation-views 1 --validation-resolution 32 --validation-samples 2".split()
    subprocess.run([*map(str, command), "--", *arguments], check=True)
    return Dataset(out).only


def _trained(
    plan: Plan,
    resolution: int,
    dataset: DatasetPart,
    views: list[ValidationView],
    args: argparse.Namespace,
) -> dict[str, Any]:
    preset = PRESETS[dataset.kind]["small"]
    out = args.work / f"{plan.samples}x{plan.rays}-{resolution}"
    checkpoint = out / "last.ckpt"  # not the best by its own few validation pixels
    if not (out / "best.ckpt").is_file():
        chosen = preset.with_model(resolution=resolution).with_training(steps=args.steps)
        train(Run(dataset, chosen, "small", out))
    trained = load_checkpoint(checkpoint).model
    scores = scores_of(trained, views)
    return {
        "paths_a_ray": plan.samples,
        "rays_a_light": plan.rays,
        "lights": plan.lights(args.paths),
        "planes": resolution,
        "psnr": scores.psnr_without_noise.db,
        "flip": scores.flip,
    }


def _draw(rows: list[dict[str, Any]], path: Path) -> None:
    drawn = figure(8, 4)
    axes = drawn.subplots()
    labels = [plan.name for plan in PLANS]
    for resolution in RESOLUTIONS:
        values = [row["psnr"] for row in rows if row["planes"] == resolution]
        axes.plot(labels, values, "o-", label=f"planes {resolution} squared")
    axes.set_xlabel("paths a ray x rays a light; the rest is lights")
    axes.set_ylabel("PSNR without noise, dB")
    axes.legend()
    save_chart(drawn, path)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("dataset", type=Path, help="dataset whose validation images are used")
    parser.add_argument("source", type=Path, help="model it was captured from")
    parser.add_argument("--paths", type=float, default=6e6, help="paths per capture")
    parser.add_argument("--steps", type=int, default=5000, help="steps per training")
    parser.add_argument("--work", type=Path, required=True, help="work folder")
    parser.add_argument("--chart", type=Path, required=True, help="PNG to write")
    add_out(parser)

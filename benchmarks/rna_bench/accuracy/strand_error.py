"""Where the error of hair and fur is: by kind of light, size of pixels, points, views and lights.

    rna-bench strand-error curls.rays runs/curls/best.ckpt --source examples/fibers/curly_ball.py \\
        --out strand-error-curls.json

Of each validation image: PSNR without noise as it is, with Cycles' direct light in the place of
the model's, of lit and of shadowed pixels, and of pixels that are the mean of 2 x 2, 4 x 4 and
8 x 8 rays, as those of a picture in which strands are thinner than a pixel.

With --source, Cycles renders 1,024 points of strands in 8 views each under 12 lights, and the error
of scattered light is divided into what belongs to a point, to a point in one view, to a point under
one light, and to all three together. Finer planes could learn the first; the last is light that
comes by way of the very next strands.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from rna_bench.accuracy.strand_points import point_parts
from rna_bench.accuracy.strand_views import SIZES, view_parts
from rna_bench.bench_options import add_out
from rna_bench.cycles_worker import cycles
from rna_bench.results import publish
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.training.checkpoint import load_checkpoint


def run(args: argparse.Namespace) -> None:
    dataset = Dataset(args.dataset)
    trained = load_checkpoint(args.checkpoint)
    results: dict[str, Any] = {
        "asset": dataset.manifest.name,
        "settings": dataset.manifest.settings.model_dump(mode="json", by_alias=True),
        "preset": trained.preset_name,
        "steps": trained.steps,
        "rays_along_a_pixel": list(SIZES),
        "images": [view_parts(trained.model, view) for view in dataset.only.validation_views()],
    }
    if args.source is not None:
        with cycles(args.source, tuple(args.script_arguments)) as worker:
            scene = scene_of(dataset)
            results["points"] = point_parts(trained.model, scene, worker, args.samples)
    publish(results, args)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("dataset", type=Path, help="dataset of rna-capture, of strands alone")
    parser.add_argument("checkpoint", type=Path, help="checkpoint of rna-train on it")
    parser.add_argument(
        "--source", type=Path, help="what was captured; arguments of a script go after --"
    )
    parser.add_argument("--samples", type=int, default=64, help="paths a ray of Cycles at points")
    add_out(parser)

"""Rays of `rna-make`, which go where the model is worst, against as many of a plain capture.

    rna-bench guided-capture toy.rays examples/quickstart/toy.py --work guided/ --lights 512

Runs `rna-make` on the source, then trains `small` on the rays of all its rounds, and on growing
parts of the plain dataset. All models have equal steps and are scored on the plain dataset's
validation images. The result says how many lights of the plain capture, with as many paths each,
give the accuracy of the guided one. The dataset should have four times as many lights.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np

from rna_bench.options import add_out
from rna_bench.results import publish
from rna_bench.scores import scores_of
from rna_export.capture.dataset import Dataset
from rna_export.capture.dataset_part import DatasetPart
from rna_export.memory import keep_freed_memory
from rna_export.metrics import WITHOUT_NOISE_DEFINITION
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.presets import PRESETS
from rna_export.training.run import Run, train
from rna_export.training.samples import SampleTable

_TIMES = (1, 2, 3, 4)
"""Lights of the plain capture, over those of the guided one."""

_OWN_VALIDATION = 32  # paths a pixel of the images of rna-make, which tell it when to stop

Row = dict[str, Any]


def run(args: argparse.Namespace) -> None:
    keep_freed_memory()
    plain = Dataset(args.dataset).only
    guided = _guided(plain, args)
    lights = guided.dataset.lights_finished()
    found = _trained(guided, plain, lights, "guided", args)
    rows = [
        _trained(plain, plain, times * lights, "plain", args)
        for times in _TIMES
        if times * lights <= plain.dataset.lights_finished()
    ]
    result = {
        "source": args.source.name,
        "steps": args.steps,
        "psnr": WITHOUT_NOISE_DEFINITION,
        "guided": found,
        "plain": rows,
        "plain_lights_for_the_same": lights_for(found["psnr"], rows),
    }
    publish(result, args)


def lights_for(psnr: float, rows: list[Row]) -> float | None:
    """Lights of a plain capture for that PSNR, between its measured ones; None beyond them.

    rows: by lights, ascending. Interpolated in the logarithm of the lights.
    """
    best, first = np.unique(np.maximum.accumulate([row["psnr"] for row in rows]), return_index=True)
    if not best[0] <= psnr <= best[-1]:
        return None
    return float(np.exp(np.interp(psnr, best, np.log([rows[k]["lights"] for k in first]))))


def _guided(plain: DatasetPart, args: argparse.Namespace) -> DatasetPart:
    """The rays of `rna-make`, with as many view rays a light and paths a ray as the plain ones."""
    work, like = args.work / "make", plain.manifest.settings
    out = args.work / "guided.rna"
    if not out.is_file():
        command = [sys.executable, "-m", "rna_export.make.cli", args.source, "--out", out]
        command += ["--lights", args.lights, "--steps", args.steps, "--work", work, "--keep"]
        command += ["--rays", like.rays, "--samples", like.samples]
        command += ["--validation-samples", _OWN_VALIDATION]
        command += ["--seed", args.seed, "--", *args.script_arguments]
        subprocess.run([*map(str, command)], check=True)
    return Dataset(work / "rays").only


def _trained(
    part: DatasetPart, judged_by: DatasetPart, lights: int, name: str, args: argparse.Namespace
) -> Row:
    """Scores of `small`, trained on the first lights of a dataset."""
    out = args.work / f"{name}-{lights}"
    if not (out / "best.ckpt").is_file():
        shards = lights // part.manifest.settings.lights_per_shard
        table = SampleTable(part.samples_of(part.dataset.finished_shards()[:shards]))
        preset = PRESETS[part.kind]["small"].with_training(steps=args.steps)
        train(Run(part, preset, "small", out, args.seed), table)
    trained = load_checkpoint(out / "last.ckpt")
    scores = scores_of(trained.model, judged_by.validation_views())
    return {"lights": lights, "psnr": scores.psnr_without_noise.db, "flip": scores.flip}


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("dataset", type=Path, help="plain capture of the source")
    parser.add_argument("source", type=Path, help="model it was captured from")
    parser.add_argument(
        "--lights", type=int, default=512, help="--lights of rna-make: its rounds begin with 1/8"
    )
    parser.add_argument("--steps", type=int, default=6000, help="steps per training")
    parser.add_argument("--seed", type=int, default=0, help="of captures and trainings")
    parser.add_argument("--work", type=Path, required=True, help="work folder")
    add_out(parser)

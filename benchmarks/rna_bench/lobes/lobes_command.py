"""Lobes of an asset's transport, trained from its package: error under whole environments.

    rna-bench lobes toy.rna --environments forest.hdr studio.hdr --out lobes-toy.json

A decoder of spherical lobes is trained on random points of random views, and compared with the
whole integral of transport and environment over 8,192 directions. Training sees no environment:
two generated ones are measured, and each file at three turns about the vertical. The decoder is
asked with the visibility along one direction, a ray a query, and with the visibility about the
mesh's vertices, which is traced once.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import numpy as np
import torch
from tqdm import tqdm

from rna_bench.bench_options import add_out
from rna_bench.results import publish
from rna_export.environment.environment_training import BAR, SIZE, STEPS, filling
from rna_export.environment.lobe_error import generated_environments, lobe_errors
from rna_export.environment.lobe_fit import fit_lobes
from rna_export.environment.lobe_model import HIDDEN_LAYERS, WIDTH, LobeModel
from rna_export.environment.lobe_queries import QueryRows
from rna_export.environment.view_points import part_views
from rna_export.training.optimization.pace import StepPace
from rna_render import read_environment
from rna_sdk.package import Package
from rna_sdk.package.manifest.extensions import EnvironmentValidation
from rna_sdk.runtime import load

_TURNS = 3


def run(args: argparse.Namespace) -> None:
    """Train and measure."""
    asset = load(args.package, args.tier, threads=1)
    part, tier = asset.parts[args.part], asset.tier.name
    begun = perf_counter()
    views = part_views(asset)[args.part]
    baked = perf_counter() - begun
    with Package.open(args.package) as package:
        queries = QueryRows(package, tier, args.part, views.visibility_columns)
    torch.manual_seed(args.seed)
    model = LobeModel(queries.columns, args.width, args.hidden_layers)
    begun, cpu = perf_counter(), process_time()
    pace = StepPace(args.steps)
    with tqdm(total=1.0, desc="lobes", bar_format=BAR) as bar:
        fit_lobes(model, views, queries, [pace], args.seed, filling(bar))
    report: dict[str, Any] = {
        "asset": part.name,
        "tier": tier,
        "width": args.width,
        "hidden_layers": args.hidden_layers,
        "steps": args.steps,
        "seed": args.seed,
        "visibility_seconds": round(baked, 2),
        "training_seconds": round(perf_counter() - begun, 1),
        "training_cpu_seconds": round(process_time() - cpu, 1),
        "multiply_adds": model.multiply_adds,
    }
    pairs = [(views, model.answering(queries))]
    report["environments"] = _rounded(lobe_errors(pairs, _environments(args.environments), SIZE))
    publish(report, args)


def _environments(files: list[Path]) -> dict[str, np.ndarray]:
    """Texels by name: the generated ones, and the files, each at several turns."""
    found = generated_environments()
    for path in files:
        texels = read_environment(path)
        for turn in range(_TURNS):
            columns = turn * texels.shape[1] // _TURNS
            found[f"{path.stem}-{360 * turn // _TURNS}"] = np.roll(texels, columns, axis=1)
    return found


def _rounded(errors: list[EnvironmentValidation]) -> list[dict[str, Any]]:
    return [
        {k: v if isinstance(v, str) else np.round(v, 3).tolist() for k, v in one} for one in errors
    ]


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of this command."""
    parser.add_argument("package", type=Path, help="an asset (path)")
    parser.add_argument("--tier", help="tier whose transport is learned (text, default: the first)")
    parser.add_argument("--part", type=int, default=0, help="number of the part")
    parser.add_argument(
        "--environments", type=Path, nargs="+", default=[], help=".hdr or .exr files (paths)"
    )
    parser.add_argument("--width", type=int, default=WIDTH, help="neurons of a hidden layer")
    parser.add_argument("--hidden-layers", type=int, default=HIDDEN_LAYERS, help="of the decoder")
    parser.add_argument("--steps", type=int, default=STEPS, help="of training")
    parser.add_argument("--seed", type=int, default=0, help="of training")
    add_out(parser)

"""Lobes of an asset's transport, trained from its package: error under whole environments.

    rna-bench lobes toy.rna --environments forest.hdr studio.hdr --out lobes-toy.json

A decoder of spherical lobes is trained on random points of random views, under random lights, and
compared with the whole integral of transport and environment over 8,192 directions. Training
never sees the environments; each is taken at three turns about the vertical. The decoder is
asked with the visibility along one direction, a ray a query, and with the visibility about the
mesh's vertices, which is traced once.
"""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import numpy as np

from rna_bench.bench_options import add_out
from rna_bench.lobes.full_integral import Integrals, cell_flux
from rna_bench.lobes.lobe_fit import fit_lobes
from rna_bench.lobes.lobe_model import LobeModel
from rna_bench.lobes.view_points import AssetViews
from rna_bench.one_part import load_one_part
from rna_bench.results import publish
from rna_render import read_environment
from rna_sdk.package import Package

_TURNS = (0.0, 2.1, 4.2)  # radians


def run(args: argparse.Namespace) -> None:
    """Train and measure."""
    part = load_one_part(args.package, args.tier)
    begun = perf_counter()
    views = AssetViews(part)
    baked = perf_counter() - begun
    with Package.open(args.package) as package:
        model = LobeModel(package, part.tier.name, args.width, args.hidden_layers)
    begun, cpu = perf_counter(), process_time()
    fit_lobes(model, views, args.steps, args.seed)
    report: dict[str, Any] = {
        "asset": part.name,
        "tier": part.tier.name,
        "width": args.width,
        "hidden_layers": args.hidden_layers,
        "steps": args.steps,
        "seed": args.seed,
        "visibility_seconds": round(baked, 2),
        "training_seconds": round(perf_counter() - begun, 1),
        "training_cpu_seconds": round(process_time() - cpu, 1),
        "multiply_adds": model.multiply_adds,
        "lights": args.lights,
        "environments": _scores(args, views, model),
    }
    publish(report, args)


def _scores(args: argparse.Namespace, views: AssetViews, model: LobeModel) -> list[dict[str, Any]]:
    integrals = Integrals(views)
    lobes, scores = integrals.densities(model), []
    for path in args.environments:
        texels = read_environment(path)
        for turn in _TURNS:
            score = asdict(integrals.score(lobes, cell_flux(texels, turn), args.lights))
            rounded = {name: np.round(value, 3).tolist() for name, value in score.items()}
            scores.append({"environment": path.stem, "turn": turn, **rounded})
    return scores


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of this command."""
    parser.add_argument("package", type=Path, help="an asset of one part (path)")
    parser.add_argument("--tier", help="tier whose transport is learned (text, default: the first)")
    parser.add_argument(
        "--environments", type=Path, nargs="+", required=True, help=".hdr or .exr files (paths)"
    )
    parser.add_argument("--width", type=int, default=96, help="neurons of a hidden layer")
    parser.add_argument("--hidden-layers", type=int, default=2, help="of the decoder")
    parser.add_argument("--steps", type=int, default=6000, help="of training")
    parser.add_argument("--lights", type=int, default=8, help="brightest cells taken exactly")
    parser.add_argument("--seed", type=int, default=0, help="of training")
    add_out(parser)

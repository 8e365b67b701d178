"""Close-ups of packages of one asset beside Cycles, where shading varies across a strand.

    rna-bench closeup examples/fibers/curly_ball.py with.rna without.rna \
        --out benchmarks/results/closeup.json --picture docs/images/closeup.jpg

One row per light, one column per package, Cycles last. PSNR excludes the noise of Cycles.
"""

from __future__ import annotations

import argparse
from dataclasses import asdict
from pathlib import Path

import numpy as np
from PIL import Image

from rna_bench.cycles import cycles
from rna_bench.options import add_out
from rna_bench.results import publish
from rna_export.compare.comparison_run import Pair, judge, render_cycles, render_ours
from rna_export.compare.views import shots_of
from rna_export.metrics import WITHOUT_NOISE_DEFINITION, NoiselessPsnr, to_png
from rna_render.paths.render import place_asset
from rna_render.world.world import World
from rna_sdk.runtime import load


def run(args: argparse.Namespace) -> None:
    assets = {package: load(package, threads=1) for package in args.packages}
    every = shots_of(assets[args.packages[0]], args.resolution, args.turn)
    near = [shot for shot in every if shot.camera_name == "strands"]
    with cycles(args.source, args.script_arguments) as worker:
        originals = [render_cycles(shot, worker, args.cycles_samples, False) for shot in near]
    pairs: dict[str, list[Pair]] = {}
    for package, asset in assets.items():
        world = World([place_asset(asset, np.eye(4))])
        pairs[package.stem] = [
            judge(shot, render_ours(shot, world, package, args.samples), original)
            for shot, original in zip(near, originals, strict=True)
        ]
    columns = [[pair.ours for pair in column] for column in pairs.values()]
    columns.append([pair.cycles for pair in pairs[args.packages[-1].stem]])
    picture = np.concatenate([np.concatenate(column) for column in columns], axis=1)
    Image.fromarray(to_png(picture)).save(args.picture)
    results = {
        name: {
            "psnr": asdict(NoiselessPsnr.mean([p.psnr_without_noise for p in column])),
            "flip": float(np.mean([p.flip for p in column])),
            "lights": {p.shot.light_name: asdict(p.psnr_without_noise) for p in column},
        }
        for name, column in pairs.items()
    }
    publish({"psnr": WITHOUT_NOISE_DEFINITION, "packages": results}, args)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", type=Path, help="model the packages were captured from")
    parser.add_argument("packages", nargs="+", type=Path, help=".rna files")
    parser.add_argument("--samples", type=int, default=64, help="rna-run samples per pixel")
    parser.add_argument("--cycles-samples", type=int, default=256, help="Cycles samples per pixel")
    parser.add_argument("--resolution", type=int, default=256, help="width and height, pixels")
    parser.add_argument(
        "--turn", type=float, default=0.0, help="camera rotation, as in rna-compare"
    )
    parser.add_argument("--picture", type=Path, required=True, help="PNG to write")
    add_out(parser)

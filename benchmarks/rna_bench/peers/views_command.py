"""Render an asset from many cameras under point lights with Cycles, for `rna-bench peers`.

    rna-bench peers-data examples/quickstart/toy.py --out bench/toy.views

Writes the layout that NRHints reads: `transforms_train.json`, `_val` and `_test`, with EXR images.
Train them with `rna-bench peers`; see docs/peers.md. The same command resumes.
"""

import argparse
from pathlib import Path


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of this command."""
    parser.add_argument("source", type=Path, help="model that Blender opens (path)")
    parser.add_argument(
        "--out", type=Path, required=True, help="folder of the views (path, required)"
    )
    parser.add_argument("--views", type=int, default=500, help="views to train on")
    parser.add_argument(
        "--collocated",
        type=int,
        default=0,
        help="views with the light at the camera to train on, for Neural Reflectance Fields",
    )
    parser.add_argument("--held-out", type=int, default=10, help="views each to validate and test")
    parser.add_argument("--resolution", type=int, default=512, help="width and height, pixels")
    parser.add_argument("--samples", type=int, default=128, help="Cycles samples per pixel")
    parser.add_argument(
        "--held-out-samples",
        type=int,
        default=512,
        help="Cycles samples per pixel of held-out views",
    )


def run(args: argparse.Namespace) -> None:
    """Render the missing images."""
    from tqdm import tqdm

    from rna_bench.cycles_worker import cycles
    from rna_bench.peers.views_plan import SPLITS, ViewsPlan
    from rna_bench.peers.views_rendering import render_views

    plan = ViewsPlan(
        args.views,
        args.collocated,
        args.held_out,
        args.resolution,
        args.samples,
        args.held_out_samples,
    )
    total = sum(plan.count(split) for split in SPLITS)
    with (
        cycles(args.source, args.script_arguments) as worker,
        tqdm(total=total, desc="views", unit="image") as bar,
    ):
        render_views(plan, worker, args.out, bar.update)
    print(f"wrote {total} views to {args.out}; next: rna-bench peers {args.out} --out bench/peers")

"""A package in the light of a point that comes near, beside Cycles with the original.

    python benchmarks/near_field.py examples/quickstart/toy.rna examples/quickstart/toy.py \
        --out benchmarks/results/near-field-toy.json --picture docs/images/near-field.png

The distances are those of the paper's near-field figure; `rna_bench.near_light` says where the
light stands. Transport was captured under light from far away: what it cannot know is how the
light's direction differs within the distance that light travels inside the asset.
"""

from __future__ import annotations

import argparse
import os
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image
from report import publish

from rna_bench.beside_cycles import EXPOSURE_DEFINITION
from rna_bench.near_light import near_lights
from rna_bench.stage import Stage
from rna_export.capture import blender_env
from rna_export.capture.worker import BlenderWorker, Source
from rna_export.machine import default_workers
from rna_sdk.console import split_script_arguments
from rna_sdk.runtime import load

DISTANCES = (8.66, 1.73, 0.86)  # of the asset's size


def main() -> None:
    own, arguments = split_script_arguments(None)
    args = _parser().parse_args(own)
    asset = load(args.package, tier=args.tier, threads=1)
    view = {"turn_deg": args.turn, "resolution": tuple(args.resolution), "margin": 0.95}
    stage = Stage.of(asset, args.package.resolve(), args.tier, **view)
    results, strips = [], []
    with (
        tempfile.TemporaryDirectory() as scratch,
        BlenderWorker(
            blender_env.find_python(),
            Source(args.source, arguments),
            Path(scratch),
            default_workers(),
        ) as worker,
    ):
        spent = args.samples, args.cycles_samples, args.bounces
        for near in near_lights(stage, worker, DISTANCES, *spent):
            names = ("distance", "psnr", "flip", "brightness")
            results.append({name: getattr(near, name) for name in names})
            strips.append(near.strip)
    Image.fromarray(np.concatenate(strips)).save(args.picture)
    report = {
        "package": args.package.name,
        "tier": args.tier or "default",
        "resolution": args.resolution,
        "samples": args.samples,
        "cycles_samples": 2 * args.cycles_samples,
        "cores": len(os.sched_getaffinity(0)),
        "psnr": f"PSNR without the noise of Cycles, over the asset's pixels, of "
        f"{EXPOSURE_DEFINITION}",
        "distances": results,
    }
    publish(report, args.out)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__.splitlines()[0],
        epilog="Arguments after -- go to a source that is a Python script.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("package", type=Path, help="the .rna file")
    parser.add_argument("source", type=Path, help="what it was captured from")
    parser.add_argument("--tier", help="of the package")
    parser.add_argument("--samples", type=int, default=64, help="ours a pixel")
    parser.add_argument("--cycles-samples", type=int, default=64, help="of each of two renders")
    parser.add_argument("--turn", type=float, default=0.0, help="as for rna-compare")
    parser.add_argument("--resolution", type=int, nargs=2, default=[256, 192])
    parser.add_argument("--bounces", type=int, help="of light in Cycles (default: the source's)")
    parser.add_argument("--picture", type=Path, required=True, help="PNG: ours, Cycles, FLIP")
    parser.add_argument("--out", type=Path, help="file for the JSON")
    return parser


if __name__ == "__main__":
    main()

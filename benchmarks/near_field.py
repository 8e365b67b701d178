"""A package in the light of a point that comes near, beside Cycles with the original.

    python benchmarks/near_field.py examples/quickstart/toy.rna examples/quickstart/toy.py \
        --out benchmarks/results/near-field-toy.json --picture docs/images/near-field.png

The light stands at 8.66, 1.73 and 0.86 times the asset's size from its middle (the paper's
near-field figure), towards (1, 1, 1) as the camera sees it; the size is the longest side of the
bounding box, so the last one is a corner of the cube about the asset. Its intensity goes with the
square of the distance. Transport was captured under light from far away: what it cannot know is how
the light's direction differs within the distance that light travels inside the asset.
"""

from __future__ import annotations

import argparse
import os
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from beside_cycles import EXPOSURE_DEFINITION, Beside, CyclesScene, OurScene
from PIL import Image
from report import publish
from stage import Stage

from rna_export.capture import blender_env
from rna_export.capture.run import default_workers
from rna_export.capture.worker import BlenderWorker, Source
from rna_sdk.console import split_script_arguments
from rna_sdk.runtime import load

DISTANCES = (8.66, 1.73, 0.86)  # of the asset's size


def main() -> None:
    own, arguments = split_script_arguments(None)
    args = _parser().parse_args(own)
    asset = load(args.package, tier=args.tier, threads=1)
    view = {"turn_deg": args.turn, "resolution": tuple(args.resolution), "margin": 0.95}
    stage = Stage.of(asset, args.package.resolve(), args.tier, **view)
    covered = OurScene(stage.scene()).channels(8)["A"] > 0.0
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
        for distance in DISTANCES:
            scene = stage.scene(_light(stage, distance))
            cycles = CyclesScene(worker, scene, args.bounces)
            halves = [cycles.render(args.cycles_samples, seed).pixels for seed in (2, 3)]
            beside = Beside.of(np.stack(halves), covered)
            ours = OurScene(scene).render(args.samples).pixels
            results.append(
                {
                    "distance": distance,
                    "psnr": beside.psnr(ours),
                    "flip": beside.flip(ours)[0],
                    "brightness": float(ours[covered].mean() / beside.reference[covered].mean()),
                }
            )
            strips.append(beside.strip(ours))
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


def _light(stage: Stage, distance: float) -> dict[str, Any]:
    length = distance * stage.size
    # As seen from the camera: (1, 1, 1) is to the right, above and in front.
    camera = np.asarray(stage.camera["position"]) - stage.centre
    front = np.array([camera[0], 0.0, camera[2]]) / np.hypot(camera[0], camera[2])
    right = np.cross([0.0, 1.0, 0.0], front)
    towards = (front + right + [0.0, 1.0, 0.0]) / np.sqrt(3.0)
    position = stage.centre + length * towards
    intensity = (np.pi * length**2,) * 3
    return {"type": "point", "position": tuple(position.tolist()), "intensity": intensity}


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

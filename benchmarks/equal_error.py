"""How long Cycles takes for the error that a package has: one image, one light, one machine.

    python benchmarks/equal_error.py blonde.rna examples/recipes/ponytail.py --tiers small hq \
        --out benchmarks/results/equal-error-blonde.json -- FOLDER --hair blonde

Cycles renders the original at doubling sample counts, and two independent references. The error of
an image is its squared error over the asset's pixels as displayed (PSNR as everywhere here),
without the references' noise: the product of the differences to each. Cycles' own error falls as
one over its samples; its time grows as a line. So the count of samples with our error, and its
time, follow from the fits of both; where that count lies above the largest rendered one, the result
says so. Times are of rendering alone: both programs have the asset loaded. Run it on an idle
machine.
"""

from __future__ import annotations

import argparse
import os
import tempfile
import time
from pathlib import Path

import numpy as np
from equality import equal_error
from report import publish, report_parser

from rna_export.capture import blender_env
from rna_export.capture.worker import BlenderWorker, Source
from rna_export.compare.run import Timed, render_ours
from rna_export.compare.views import FOV_Y, Shot, shots_of
from rna_export.machine import default_workers
from rna_export.metrics import IRRADIANCE, WITHOUT_NOISE_DEFINITION, display, psnr_without_noise
from rna_render.render import place_asset
from rna_render.world import World
from rna_sdk.console import split_script_arguments
from rna_sdk.runtime import Asset, load


def main() -> None:
    own, arguments = split_script_arguments(None)
    args = _parser().parse_args(own)
    assets = {tier: load(args.package, tier=tier, threads=1) for tier in args.tiers}
    standard = shots_of(assets[args.tiers[0]], args.resolution, args.turn)
    shot = next(s for s in standard if s.name == args.shot)
    with tempfile.TemporaryDirectory() as scratch:
        source = Source(args.source, arguments)
        python = blender_env.find_python()
        with BlenderWorker(python, source, Path(scratch), default_workers()) as worker:
            cycles = _Cycles(worker, shot, args.reference_samples)
            counts = [2**k for k in range(1, args.doublings + 1)]
            rendered = {n: cycles.render(n, seed=100 + n) for n in counts}
    report = {
        "package": args.package.name,
        "shot": shot.name,
        "resolution": args.resolution,
        "cores": len(os.sched_getaffinity(0)),
        "psnr": WITHOUT_NOISE_DEFINITION,
        "reference_samples": 2 * args.reference_samples,
        "cycles": [
            {"samples": n, "seconds": image.seconds, "psnr": cycles.psnr(image.pixels)}
            for n, image in rendered.items()
        ],
    }
    report["ours"] = []
    for tier, asset in assets.items():
        for samples in args.samples:
            ours = _ours(asset, shot, samples, args)
            equal = equal_error(cycles.psnr(ours.pixels), ours.seconds, report["cycles"])
            report["ours"].append({"tier": tier, "samples": samples, **equal})
    publish(report, args.out)


class _Cycles:
    """The original, and what its renders are compared with."""

    def __init__(self, worker: BlenderWorker, shot: Shot, reference_samples: int):
        self._worker, self._shot = worker, shot
        self.render(1, seed=1)  # the first one also builds the scene
        halves = [self.render(reference_samples, seed).pixels for seed in (2, 3)]
        self._covered = halves[0][..., 3] > 0.0
        self._halves = [half[self._covered][:, :3] for half in halves]

    def render(self, samples: int, seed: int) -> Timed:
        """RGBA. The worker starts anew for another count, so that time is not here."""
        n = self._shot.resolution
        view = self._shot.to_world, FOV_Y, self._shot.wi
        self._worker.render_view(*view, samples, seed, 8, 8)
        begun = time.perf_counter()
        image = self._worker.render_view(*view, samples, seed, n, n)
        return Timed(image, time.perf_counter() - begun)

    def psnr(self, image: np.ndarray) -> float:
        ours = display(image[self._covered][:, :3]) / IRRADIANCE  # its noise, too, as displayed
        return psnr_without_noise(ours, *self._halves).db


def _ours(asset: Asset, shot: Shot, samples: int, args: argparse.Namespace) -> Timed:
    """RGBA, and the median time of the renders after one that warms up."""
    world = World([place_asset(asset, np.eye(4))])
    renders = [render_ours(shot, world, args.package, samples) for _ in range(1 + args.repeats)]
    return Timed(renders[-1].pixels, float(np.median([r.seconds for r in renders[1:]])))


def _parser() -> argparse.ArgumentParser:
    parser = report_parser(
        description="Time to equal error of a package against Cycles; prints JSON.",
        epilog="Arguments after -- go to a source that is a Python script.",
    )
    parser.add_argument("package", type=Path, help="the .rna file")
    parser.add_argument("source", type=Path, help="what it was captured from")
    parser.add_argument("--tiers", nargs="+", required=True, help="of the package")
    parser.add_argument("--samples", type=int, nargs="+", default=[16], help="ours a pixel")
    parser.add_argument("--shot", default="front, key light", help="as rna-compare calls it")
    parser.add_argument("--turn", type=float, default=0.0, help="as for rna-compare")
    parser.add_argument("--resolution", type=int, default=256, help="pixels a side")
    parser.add_argument("--doublings", type=int, default=7, help="Cycles renders 2, 4, ... 2^this")
    parser.add_argument(
        "--reference-samples", type=int, default=256, help="of each of the two references"
    )
    return parser


if __name__ == "__main__":
    main()

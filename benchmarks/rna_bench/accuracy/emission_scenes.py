"""Illumination of the surroundings by an emissive asset, against Cycles with the original.

    rna-bench emission lamp.rna examples/recipes/lamp.py --bounces 12 \\
        --out benchmarks/results/emission-lamp.json --picture docs/images/emission-lamp.jpg

Two scenes on a grey ground, with a red wall beside the asset: a dark room, and a dim sky.
Brightness is the mean radiance over Cycles', per channel: of the surroundings, and of the asset.

Bounce limits count from the camera: for light reflected by the ground, Cycles traces one bounce
less inside the asset than in the capture. --bounces raises the limits.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from rna_bench.bench_options import add_out
from rna_bench.bench_pages import save_picture
from rna_bench.cycles_worker import cycles
from rna_bench.results import publish
from rna_bench.scenes.beside_cycles import EXPOSURE_DEFINITION, Beside, CyclesScene, OurScene
from rna_bench.scenes.stage import Stage
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_render.scene import Scene
from rna_sdk.runtime import load


def run(args: argparse.Namespace) -> None:
    asset = load(args.package, tier=args.tier, threads=1)
    resolution = tuple(args.resolution)
    stage = Stage.of(asset, args.package.resolve(), args.tier, turn_deg=0.0, resolution=resolution)
    rows, strips = {}, []
    with (
        tempfile.TemporaryDirectory() as folder,
        cycles(args.source, args.script_arguments) as worker,
    ):
        for name, scene in _scenes(stage, args.sky, Path(folder)).items():
            rows[name], strip = _measured(scene, worker, args)
            strips.append(strip)
            print(name, rows[name], flush=True)
    if args.picture is not None:
        save_picture(Image.fromarray(np.concatenate(strips)), args.picture)
    report = {
        "package": args.package.name,
        "tier": args.tier or "default",
        "resolution": args.resolution,
        "samples": args.samples,
        "cycles_samples": 2 * args.cycles_samples,
        "sky": args.sky,
        "psnr": f"PSNR without the noise of Cycles, of {EXPOSURE_DEFINITION}",
        "scenes": rows,
    }
    publish(report, args)


def _scenes(stage: Stage, sky: float, folder: Path) -> dict[str, Scene]:
    settings = {"ground": stage.ground, "objects": [stage.wall(folder)]}
    dim = {"type": "environment", "radiance": (sky, sky, sky)}
    return {"dark room": stage.scene(**settings), "dim sky": stage.scene(dim, **settings)}


def _measured(
    scene: Scene, worker: BlenderWorker, args: argparse.Namespace
) -> tuple[dict[str, Any], np.ndarray]:
    original = CyclesScene(worker, scene, args.bounces, emission=True)
    halves = np.stack([original.render(args.cycles_samples, seed).pixels for seed in (2, 3)])
    channels = OurScene(scene).channels(args.samples)
    ours = np.stack([channels[name] for name in "RGB"], axis=-1)
    covered = channels["assetId"] == 1
    beside = Beside.of(halves, covered)
    found = {
        name: {
            "brightness": beside.brightness(ours, where).round(4).tolist(),
            "psnr": beside.psnr(ours, where).db,
        }
        for name, where in (("asset", covered), ("things", ~covered))
    }
    return found, beside.strip(ours)


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("package", type=Path, help="the .rna file")
    parser.add_argument("source", type=Path, help="model it was captured from")
    parser.add_argument("--tier", help="tier of the package")
    parser.add_argument("--sky", type=float, default=0.1, help="radiance of the dim sky")
    parser.add_argument("--samples", type=int, default=128, help="rna-run samples per pixel")
    parser.add_argument(
        "--cycles-samples",
        type=int,
        default=256,
        help="Cycles samples per pixel, in each of two renders",
    )
    parser.add_argument(
        "--resolution", type=int, nargs=2, default=[192, 144], help="width, height, pixels"
    )
    parser.add_argument(
        "--bounces", type=int, help="Cycles' bounce limit (int, default: the source's)"
    )
    parser.add_argument("--picture", type=Path, help="JPEG or PNG: ours, Cycles, FLIP")
    add_out(parser)

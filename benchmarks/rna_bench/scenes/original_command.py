"""A scene beside Cycles, which has the original in the place of the asset and of its glass.

    rna-bench original bottle.yaml examples/recipes/bottle.py --picture bottle.jpg

The scene is a scene file, or a package in its starter scene. In Cycles the original is as its file
has it, with smooth glass that `rna-run` shows as a mesh, and with its emission. FLIP and PSNR are
of the whole image, ours with its noise; for Cycles' noise there is FLIP of half of its paths.
"""

from __future__ import annotations

import argparse
from io import BytesIO
from pathlib import Path

import numpy as np
from PIL import Image

from rna_bench.bench_options import add_out
from rna_bench.cycles_worker import cycles
from rna_bench.results import publish
from rna_bench.scenes.beside_cycles import Beside, CyclesScene, OurScene
from rna_render.scene import Scene, read_scene
from rna_sdk.atomic_file import write_atomically


def run(args: argparse.Namespace) -> None:
    """Render both, and judge."""
    scene = read_scene(args.scene).resolved
    if args.resolution is not None:
        width, height = args.resolution
        scene = scene.model_copy(update={"resolution": (width, height)})
    ours = OurScene(scene)
    channels = ours.channels(args.samples)
    image = np.stack([channels[c] for c in "RGB"], axis=-1)
    with cycles(args.source, tuple(args.script_arguments), glass="show") as worker:
        theirs = CyclesScene(worker, _without_glass(scene), emits=True)
        half = args.cycles_samples // 2
        halves = np.stack([theirs.render(half, seed).pixels for seed in (2, 3)])
    beside = Beside.of(halves, np.ones(image.shape[:2], bool))
    report = {
        "scene": args.scene.name,
        "resolution": scene.resolution,
        "samples": args.samples,
        "cycles_samples": args.cycles_samples,
        "flip": round(float(beside.flip_map(image).mean()), 4),
        "flip_of_cycles_noise": round(float(beside.flip_map(halves[0]).mean()), 4),
        "psnr_without_noise": round(beside.psnr(image).db, 2),
    }
    if args.picture is not None:
        row = [beside.picture(image), beside.picture(beside.reference), beside.flip_picture(image)]
        data = BytesIO()
        Image.fromarray(np.concatenate(row, axis=1)).save(data, "JPEG", quality=90)
        write_atomically(args.picture, data.getvalue())
    publish(report, args)


def _without_glass(scene: Scene) -> Scene:
    """The original has its own."""
    others = [o for o in scene.objects if not o.path.name.endswith(".glass.glb")]
    return scene.model_copy(update={"objects": tuple(others)})


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of this command."""
    parser.add_argument("scene", type=Path, help="scene file or package (path)")
    parser.add_argument("source", type=Path, help="what the package was captured from (path)")
    parser.add_argument("--samples", type=int, default=128, help="paths a pixel of ours")
    parser.add_argument("--cycles-samples", type=int, default=256, help="paths a pixel of Cycles")
    parser.add_argument(
        "--resolution", type=int, nargs=2, metavar=("W", "H"), help="in the place of the scene's"
    )
    parser.add_argument("--picture", type=Path, help="JPEG to write: ours, Cycles, FLIP (path)")
    add_out(parser)

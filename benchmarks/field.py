"""A field of one asset, from near to far: the tiers that `quality` picks against one for all.

    python benchmarks/field.py toy.rna examples/quickstart/toy.py --tier hq --max-error 0.04 \\
        --out benchmarks/results/field-toy.json --picture docs/images/field-toy.png

Prints JSON: seconds of both renders, how much of them the decoders took, the FLIP of each against
Cycles with the original, and that between them, beside that between two renders of the one tier
with other random numbers; with --seconds also what `quality` makes of time limits. Runs alternate,
and medians are compared; loading and compiling are left out. On a machine that does other work,
too, compare the processor's seconds, those of all threads.
"""

from __future__ import annotations

import argparse
import os
import platform
import tempfile
import time
from collections import Counter
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
from PIL import Image
from report import publish, report_parser

from rna_bench.beside_cycles import CyclesScene
from rna_export.capture.blender_env import find_python
from rna_export.capture.worker import BlenderWorker, Source
from rna_export.machine import default_workers
from rna_export.metrics import IRRADIANCE, flip
from rna_render.render import load_world, make_integrator, render
from rna_render.scene_file import SceneFile
from rna_render.scene_model import QualityModel, Scene
from rna_render.srgb import encode_srgb
from rna_render.world import World

ROWS = ((4.1, 1), (4.8, 4), (6.5, 5), (8.5, 6), (11.0, 7), (15.0, 8), (21.0, 9))
"""Distance from the camera and number of assets of each row: 40 in all."""

MOST_SAMPLES = 4096
"""A pixel, under a time limit."""

MIDDLE = (0.4, -0.16)
"""x and z of the middle of the toy, object space."""


def main() -> None:
    args = arguments()
    named = field(args, tier=args.tier, quality=None)
    chosen = field(args, tier=None, quality=QualityModel(max_error=args.max_error))
    renders = {"one tier": Render(named, args), "quality": Render(chosen, args)}
    for _ in range(args.repeats):
        for one in renders.values():
            one.run()
    image = {name: one.image for name, one in renders.items()}
    other = Render(named.with_changes(seed=1), args)
    other.run()
    image["Cycles"] = cycles(named.scene, args)
    difference, error = flip_of(image["quality"], image["one tier"])
    of_cycles = {name: flip_of(image[name], image["Cycles"])[0] for name in renders}
    report: dict[str, Any] = {
        "package": args.package.name,
        "tier": args.tier,
        "max_error": args.max_error,
        "resolution": list(named.scene.resolution),
        "samples": args.samples,
        "processor": platform.processor() or platform.machine(),
        "load": [round(load, 2) for load in os.getloadavg()],
        "tiers": renders["quality"].tiers(),
        **{name: one.report() for name, one in renders.items()},
        "speedup": median(renders["one tier"].seconds) / median(renders["quality"].seconds),
        "speedup_in_processor_time": median(renders["one tier"].processor_seconds)
        / median(renders["quality"].processor_seconds),
        "flip_against_cycles": of_cycles,
        "flip_between": difference,
        "flip_of_other_seed": flip_of(other.image, image["one tier"])[0],
        "time_limits": [within(seconds, args, image["Cycles"]) for seconds in args.seconds],
    }
    publish(report, args.out)
    if args.picture:
        write_picture(args.picture, list(image.values()), error)


def arguments() -> argparse.Namespace:
    parser = report_parser(
        description="Render a field of an asset with one tier and with tiers chosen; prints JSON.",
        epilog="example: python benchmarks/field.py toy.rna toy.py --tier hq --max-error 0.04",
    )
    parser.add_argument("package", type=Path, help="with several tiers")
    parser.add_argument("source", type=Path, help="what it was captured from")
    parser.add_argument("--tier", default="hq", help="of all assets in the render to beat")
    parser.add_argument("--max-error", type=float, default=0.04, help="of the other render")
    parser.add_argument(
        "--seconds", type=float, nargs="*", default=(), help="time limits to render within, too"
    )
    parser.add_argument("--width", type=int, default=640, help="of the image, pixels")
    parser.add_argument("--cycles-samples", type=int, default=128, help="a pixel")
    parser.add_argument("--samples", type=int, default=64, help="a pixel")
    parser.add_argument("--picture", type=Path, help="file for both images and their difference")
    parser.set_defaults(repeats=3)
    return parser.parse_args()


def field(args: argparse.Namespace, tier: str | None, quality: QualityModel | None) -> SceneFile:
    """40 assets on a ground under four lamps far away."""
    assets = [
        {
            "path": args.package.resolve(),
            "tier": tier,
            "transform": standing(spread(k, count, distance), -distance, 137.5 * (10 * row + k)),
        }
        for row, (distance, count) in enumerate(ROWS)
        for k in range(count)
    ]
    scene = Scene.model_validate(
        {
            "assets": assets,
            "ground": {},
            "camera": {"position": (0, 1.1, 0), "look_at": (0, 0.35, -5), "vertical_fov_deg": 15},
            "lights": [
                {"type": "directional", "direction": (0.5, 0.7, 0.4), "irradiance": (2, 1.9, 1.7)},
                {
                    "type": "directional",
                    "direction": (-0.7, 0.5, 0.5),
                    "irradiance": (0.5, 0.6, 0.7),
                },
                {
                    "type": "directional",
                    "direction": (0.1, 0.6, -0.8),
                    "irradiance": (0.6, 0.6, 0.7),
                },
                {"type": "directional", "direction": (0, 1, 0.2), "irradiance": (0.4, 0.45, 0.5)},
            ],
            "resolution": (args.width, 3 * args.width // 8),
            "max_depth": 4,
            "clamp_indirect": 1.0,
            "samples": args.samples,
        }
    )
    return SceneFile(Path("field"), scene.model_copy(update={"quality": quality}), {})


def within(seconds: float, args: argparse.Namespace, reference: np.ndarray) -> dict[str, Any]:
    """The field under a time limit: what was taken, and how near it is to the reference."""
    file = field(args, tier=None, quality=QualityModel(seconds=seconds))
    one = Render(file.with_changes(samples=MOST_SAMPLES), args)
    one.run()
    return {
        "limit": seconds,
        "seconds": one.seconds[0],
        "samples": one.samples,
        "tiers": one.tiers(),
        "flip_against_cycles": flip_of(one.image, reference)[0],
    }


def standing(x: float, z: float, turn_deg: float) -> dict[str, Any]:
    """The transform of a toy with its middle over (x, z)."""
    c, s = np.cos(np.radians(turn_deg)), np.sin(np.radians(turn_deg))
    middle_x, middle_z = MIDDLE
    moved = x - c * middle_x - s * middle_z, 0.0, z + s * middle_x - c * middle_z
    return {"translation": moved, "rotation_deg": (0.0, turn_deg, 0.0)}


def spread(k: int, count: int, distance: float) -> float:
    """x of the k-th of `count` assets that fill the image's width at this distance."""
    return 0.8 * distance * ((k + 0.5) / count - 0.5)


class Render:
    """One way to render the field, timed run after run."""

    def __init__(self, file: SceneFile, args: argparse.Namespace) -> None:
        self.scene = file.scene
        self.world = load_world(file)
        self.integrator = make_integrator(file.scene, self.world)
        self.decoding = decoder_clock(self.world)
        render(file.scene.model_copy(update={"samples": 1}), self.integrator)
        self.seconds: list[float] = []
        self.processor_seconds: list[float] = []
        self.decoder_seconds: list[float] = []

    def run(self) -> None:
        self.decoding.clear()
        start, busy = time.perf_counter(), time.process_time()
        film = render(self.scene, self.integrator)
        self.seconds.append(time.perf_counter() - start)
        self.processor_seconds.append(time.process_time() - busy)
        self.decoder_seconds.append(sum(self.decoding))
        self.samples = film.samples
        channels = film.channels()
        self.image = np.stack([channels[c] for c in "RGB"], axis=-1)

    def tiers(self) -> dict[str, int]:
        names = [thing.tier.name for thing in self.world.things if hasattr(thing, "tier")]
        return dict(Counter(names).most_common())

    def report(self) -> dict[str, Any]:
        return {
            "seconds": self.seconds,
            "processor_seconds": self.processor_seconds,
            "median_seconds": median(self.seconds),
            "processor_seconds_in_evaluate": median(self.decoder_seconds),
        }


def decoder_clock(world: World) -> list[float]:
    """Processor seconds of every call of `evaluate` from now on, each in its thread."""
    calls: list[float] = []

    def timed(evaluate):
        def call(*arguments):
            start = time.thread_time()
            result = evaluate(*arguments)
            calls.append(time.thread_time() - start)
            return result

        return call

    for thing in {id(thing): thing for thing in world.things}.values():
        if hasattr(thing, "evaluate"):
            thing.evaluate = timed(thing.evaluate)
    return calls


def flip_of(image: np.ndarray, reference: np.ndarray) -> tuple[float, np.ndarray]:
    """Mean and map of the images as shown; the metric's radiance is at irradiance 1."""
    return flip(image / IRRADIANCE, reference / IRRADIANCE)


def cycles(scene: Scene, args: argparse.Namespace) -> np.ndarray:
    """The field as Cycles renders it, with the original in place of each asset."""
    source = Source(args.source, ())
    with (
        tempfile.TemporaryDirectory() as scratch,
        BlenderWorker(find_python(), source, Path(scratch), default_workers()) as worker,
    ):
        return CyclesScene(worker, scene, bounces=None).render(args.cycles_samples, 1).pixels


def write_picture(path: Path, images: list[np.ndarray], error: np.ndarray) -> None:
    """The images, and ten times the FLIP map, below each other."""
    shown = [255.0 * encode_srgb(np.clip(image, 0.0, 1.0)) for image in images]
    shown.append(np.repeat(np.clip(2550.0 * error, 0.0, 255.0)[..., None], 3, axis=2))
    Image.fromarray((np.concatenate(shown) + 0.5).clip(0, 255).astype(np.uint8)).save(path)


if __name__ == "__main__":
    main()

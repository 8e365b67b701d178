"""A package in scenes, beside Cycles with the original in the same scenes.

    python benchmarks/in_scene.py examples/quickstart/toy.rna examples/quickstart/toy.py \
        --environments forest.hdr studio.hdr sunset courtyard --work runs/in-scene-toy \
        --out benchmarks/results/in-scene-toy.json --picture docs/images/in-scene-toy.png

Scenes: each environment over a ground; an area lamp over a ground; a red wall beside the asset in
the lamp's light. Cycles renders doubling sample counts and two independent references. Time to
equal error is fitted as in `equal_error.py`. Scenes that are finished lie in --work, and are not
rendered again: both programs' times of a scene are always of one run. Run it on an idle machine.
"""

from __future__ import annotations

import argparse
import json
import os
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from bleeding import bleeding
from equality import equal_error
from PIL import Image
from report import publish

from rna_bench.beside_cycles import EXPOSURE_DEFINITION, Beside, CyclesScene, OurScene
from rna_bench.stage import Stage
from rna_export.capture import blender_env
from rna_export.capture.worker import BlenderWorker, Source
from rna_export.machine import default_workers
from rna_export.metrics import FLIP_DEFINITION
from rna_render.scene_model import Scene
from rna_sdk.console import split_script_arguments
from rna_sdk.runtime import load

WALL = "wall"

# Of Cycles: with fewer, clamping hides so much of the noise that error no longer goes as one over
# the samples, which the fit of equal error takes for granted.
FEWEST = 4


def main() -> None:
    own, arguments = split_script_arguments(None)
    args = _parser().parse_args(own)
    args.work.mkdir(parents=True, exist_ok=True)
    python = blender_env.find_python()
    asset = load(args.package, tier=args.tier, threads=1)
    view = {"turn_deg": args.turn, "resolution": tuple(args.resolution)}
    stage = Stage.of(asset, args.package.resolve(), args.tier, **view)
    environments = [_environment(name, python) for name in args.environments]
    scenes = _scenes(stage, environments, args.work)
    left = [name for name in scenes if not (args.work / f"{name}.json").is_file()]
    if left:
        source = Source(args.source, arguments)
        with (
            tempfile.TemporaryDirectory() as scratch,
            BlenderWorker(python, source, Path(scratch), default_workers()) as worker,
        ):
            covered = OurScene(stage.scene()).channels(8)["A"] > 0.0
            for name in left:
                _measure(name, scenes[name], covered, stage, worker, args)
    results = {name: json.loads((args.work / f"{name}.json").read_text()) for name in scenes}
    strips = [np.asarray(Image.open(args.work / f"{name}.png")) for name in scenes]
    Image.fromarray(np.concatenate(strips)).save(args.picture)
    report = {
        "package": args.package.name,
        "tier": args.tier or "default",
        "resolution": args.resolution,
        "cores": len(os.sched_getaffinity(0)),
        "psnr": f"PSNR without the noise of Cycles, of {EXPOSURE_DEFINITION}",
        "flip": FLIP_DEFINITION.replace("sRGB image over black", "image shown so, as sRGB"),
        "reference_samples": 2 * args.reference_samples,
        "scenes": results,
    }
    publish(report, args.out)


def _scenes(stage: Stage, environments: list[Path], work: Path) -> dict[str, Scene]:
    scenes = {
        path.stem: stage.scene(stage.environment(path), ground=stage.ground)
        for path in environments
    }
    scenes["lamp"] = stage.scene(stage.lamp, ground=stage.ground)
    objects = [stage.wall(work.resolve())]
    scenes[WALL] = stage.scene(stage.lamp, ground=stage.ground, objects=objects)
    return scenes


def _measure(
    name: str,
    scene: Scene,
    covered: np.ndarray,
    stage: Stage,
    worker: BlenderWorker,
    args: argparse.Namespace,
) -> None:
    """Both programs, one after the other; writes the scene's numbers and its strip of pictures."""
    cycles = CyclesScene(worker, scene, args.bounces)
    halves = np.stack([cycles.render(args.reference_samples, seed).pixels for seed in (2, 3)])
    beside = Beside.of(halves, covered)
    rows = []
    for samples in (FEWEST * 2**k for k in range(args.doublings + 1)):
        image = cycles.render(samples, seed=100 + samples)
        rows.append(
            {"samples": samples, "seconds": image.seconds, **_quality(beside, image.pixels)}
        )
    ours, results = OurScene(scene), []
    ours.render(1)
    for samples in args.samples:
        image = ours.render(samples, args.repeats)
        quality = _quality(beside, image.pixels)
        results.append({"samples": samples, "seconds": image.seconds, **quality})
        for where in ("asset", "everywhere"):
            of_cycles = [{**row, "psnr": row[f"psnr_{where}"]} for row in rows]
            equal = equal_error(quality[f"psnr_{where}"], image.seconds, of_cycles)
            kept = ("cycles_samples", "cycles_seconds", "extrapolated", "times_as_fast")
            results[-1][f"equal_error_{where}"] = {key: equal[key] for key in kept}
    found: dict[str, Any] = {"exposure": beside.exposure, "cycles": rows, "ours": results}
    if name == WALL:
        found["bleeding"] = bleeding(stage, scene, worker, args, beside.exposure)
    np.savez(args.work / f"{name}.npz", ours=image.pixels, halves=halves, covered=covered)
    Image.fromarray(beside.strip(image.pixels)).save(args.work / f"{name}.png")
    (args.work / f"{name}.json").write_text(json.dumps(found) + "\n")
    print(name, json.dumps(results[-1]), flush=True)


def _quality(beside: Beside, image: np.ndarray) -> dict[str, float]:
    return {
        "psnr_asset": beside.psnr(image).db,
        "psnr_everywhere": beside.psnr(image, np.ones_like(beside.asset)).db,
        "flip": beside.flip(image)[0],
    }


def _environment(name: str, python: Path) -> Path:
    """A file, or one of the images that come with Blender, by its name."""
    path = Path(name)
    if path.is_file():
        return path.resolve()
    folder = "lib/python*/site-packages/bpy/*/datafiles/studiolights/world"
    for found in python.parent.parent.glob(f"{folder}/{name}.exr"):
        return found
    raise SystemExit(f"{name}: neither a file nor one of Blender's environments")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        description=__doc__.splitlines()[0],
        epilog="Arguments after -- go to a source that is a Python script.",
        formatter_class=argparse.ArgumentDefaultsHelpFormatter,
    )
    parser.add_argument("package", type=Path, help="the .rna file")
    parser.add_argument("source", type=Path, help="what it was captured from")
    parser.add_argument("--tier", help="of the package")
    parser.add_argument("--environments", nargs="+", default=["forest", "studio", "sunset", "city"])
    parser.add_argument("--samples", type=int, nargs="+", default=[4, 16, 64], help="ours a pixel")
    parser.add_argument("--repeats", type=int, default=1, help="of ours; the median counts")
    parser.add_argument("--turn", type=float, default=0.0, help="as for rna-compare")
    parser.add_argument("--resolution", type=int, nargs=2, default=[192, 144])
    parser.add_argument(
        "--doublings", type=int, default=3, help="Cycles renders 4, 8, ... 4 * 2^this"
    )
    parser.add_argument("--reference-samples", type=int, default=64, help="of each of the two")
    parser.add_argument("--bounces", type=int, help="of light in Cycles (default: the source's)")
    parser.add_argument("--work", type=Path, required=True, help="folder for finished scenes")
    parser.add_argument("--picture", type=Path, required=True, help="PNG: ours, Cycles, FLIP")
    parser.add_argument("--out", type=Path, help="file for the JSON")
    return parser


if __name__ == "__main__":
    main()

"""All scenes of one asset: the measurements, their settings and the written result."""

import argparse
import hashlib
import json
from contextlib import ExitStack
from functools import cache, partial
from pathlib import Path
from typing import Any

from rna_bench.cycles_worker import cycles
from rna_bench.results import write_results
from rna_bench.scenes.beside_cycles import EXPOSURE_DEFINITION
from rna_bench.scenes.filled import filled
from rna_bench.scenes.judge import judge
from rna_bench.scenes.measured_scene import MeasuredScene, Plan
from rna_bench.scenes.scene_list import BESIDE_ENVIRONMENTS, find_environment, scenes
from rna_bench.scenes.scenes_sheet import draw_sheet
from rna_bench.scenes.stage import Stage
from rna_bench.scenes.stored import StoredResults
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_sdk.errors import SceneError
from rna_sdk.runtime import load
from rna_work.progress import Progress

DEFINITIONS = {
    "psnr": "PSNR without the noise of Cycles' references over the asset's pixels, dB, of "
    + EXPOSURE_DEFINITION,
    "floor": "the same of our image with so many samples that hardly any noise is left: the "
    "package's own error",
    "brightness": "light from the asset's pixels in that image over Cycles', red, green, blue",
    "noise": "PSNR of our image against that one: what more samples take away",
    "flip": "mean FLIP of the image shown so, as sRGB, over the asset's pixels, without the "
    "references' noise; flip_p95 is the 95th percentile of these pixels",
    "equal error": "the time that Cycles takes for the PSNR of our raw image over our time; its "
    "error is fitted as one over its samples, its time as a line",
    "seconds": "of rendering, and of denoising where that is said; nothing is loaded meanwhile",
}


def study(args: argparse.Namespace) -> str:
    """Measure the scenes that the options ask for; write `scenes.json` and `scenes.png`.

    With `references_only` nothing is timed. Returns what was written, for a person.
    """
    environments = [find_environment(name) for name in args.environment]
    _check(args, environments)
    stage, plan = _stage(args), _plan(args)
    args.out.mkdir(parents=True, exist_ok=True)
    every = scenes(stage, environments, args.out.resolve())
    chosen = {name: every[name] for name in every if args.scenes is None or name in args.scenes}
    references, measured = _stored_results(args, stage, environments)
    done, result = [], {}
    with Progress(len(chosen), "scene", "measuring") as progress:
        for name, scene in chosen.items():
            # A Blender of its own for each: one that builds many scenes may crash.
            with ExitStack() as stack:
                worker = cache(partial(_enter, stack, args))
                one = MeasuredScene(
                    name,
                    scene,
                    plan,
                    references=references,
                    measured=measured,
                    worker=worker,
                    say=progress.tell,
                )
                if args.references_only:
                    _ = one.halves
                else:
                    result[name] = judge(one)
            done.append(one)
            progress.advance({})
    if args.references_only:
        return str(args.out / "references")
    report = {
        "asset": args.asset.name,
        "tier": args.tier or "default",
        "resolution": args.resolution,
        "definitions": DEFINITIONS,
        "scenes": result,
    }
    write_results(args.out / "scenes.json", args.stamp, report)
    draw_sheet(done, result, args.out / "scenes.png")
    return f"{args.out / 'scenes.json'}, {args.out / 'scenes.png'}"


def _enter(stack: ExitStack, args: argparse.Namespace) -> BlenderWorker:
    return stack.enter_context(cycles(args.source, args.script_arguments))


def _stage(args: argparse.Namespace) -> Stage:
    asset = load(args.asset, tier=args.tier, threads=1)
    view = {"turn_deg": args.turn, "resolution": tuple(args.resolution)}
    return filled(Stage.of(asset, args.asset.resolve(), args.tier, **view), args.share)


def _plan(args: argparse.Namespace) -> Plan:
    samples, cycles_samples = sorted(args.samples), sorted(args.cycles_samples)
    if len(cycles_samples) < 2:
        raise SceneError("--cycles-samples: found one number; expected two, to fit its error")
    return Plan(samples, cycles_samples, args.reference_samples, args.floor_samples)


def _stored_results(
    args: argparse.Namespace, stage: Stage, environments: list[Path]
) -> tuple[StoredResults, StoredResults]:
    """Stores of Cycles' references, and of measurements on one commit and CPU."""
    shared: dict[str, Any] = {
        "source": _digest(args.source),
        "script_arguments": list(args.script_arguments),
        "environments": {path.name: _digest(path) for path in environments},
        "resolution": list(args.resolution),
        "camera": json.loads(json.dumps(stage.camera)),
        "reference_samples": args.reference_samples,
    }
    values = {
        "asset": _digest(args.asset),
        "tier": args.tier,
        "samples": args.samples,
        "cycles_samples": args.cycles_samples,
        "floor_samples": args.floor_samples,
        "commit": args.stamp["commit"].removesuffix("+changes"),
        "cpu": args.stamp["cpu"],
    }
    elsewhere = "choose another --out"
    return (
        StoredResults(args.out / "references", shared, False, elsewhere),
        StoredResults(args.out / "measured", values, args.again, f"{elsewhere}, or --again"),
    )


def _digest(path: Path) -> str:
    if not path.is_file():
        raise SceneError(f"{path}: no such file")
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16]


def _check(args: argparse.Namespace, environments: list[Path]) -> None:
    """Raises SceneError for scenes that there are not, or a source; before anything is rendered."""
    every = [*(path.stem for path in environments), *BESIDE_ENVIRONMENTS]
    unknown = sorted(set(args.scenes or ()) - set(every))
    if unknown:
        raise SceneError(f"--scenes: found {', '.join(unknown)}; expected of {', '.join(every)}")
    _digest(args.source)

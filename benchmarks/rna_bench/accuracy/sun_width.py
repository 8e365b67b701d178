"""Energy lost behind smooth glass with a zero-width sun: one asset under suns of several widths.

    rna-bench sun-width examples/recipes/bottle.py examples/recipes/lantern.py \
        --out benchmarks/results/sun-width.json

Capture lights assets with suns of no width. A path that leaves a diffuse point through smooth
refraction or by a mirror can meet only a light that has some: what such a sun makes inside glass
is missing from the captured light. Cycles renders each source under suns of equal irradiance from
three sides; brightness is the mean radiance over the picture, over that under the widest sun.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from rna_bench.cycles import cycles
from rna_bench.options import add_out
from rna_bench.results import publish
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.geometry.mesh_cleanup import weld
from rna_export.compare.cycles_scene import cycles_scene
from rna_export.compare.views import FOV_Y, Shot, shots
from rna_render.scene.light_models import DirectionalModel
from rna_render.scene.scene_model import Scene

WIDTHS_DEG = (0.0, 0.53, 2.0, 10.0)


def run(args: argparse.Namespace) -> None:
    rows = {}
    for path in args.sources:
        with cycles(path) as worker:
            rows[path.stem] = _brightness(worker, args)
        print(path.stem, rows[path.stem], flush=True)
    report = {
        "resolution": args.resolution,
        "samples": args.samples,
        "brightness_by_width_deg": rows,
    }
    publish(report, args)


def _brightness(worker: BlenderWorker, args: argparse.Namespace) -> dict[str, float]:
    """Mean brightness for each width of the sun over that for the widest; three suns, front."""
    meshes = [weld(worker.export_corners(part.owner)) for part in worker.parts]
    front = shots(meshes, args.resolution, 0.0)[:3]
    means = {
        width: np.mean([_mean(worker, shot, width, args.samples) for shot in front])
        for width in WIDTHS_DEG
    }
    return {f"{width:g}": round(float(means[width] / means[WIDTHS_DEG[-1]]), 4) for width in means}


def _mean(worker: BlenderWorker, shot: Shot, width_deg: float, samples: int) -> float:
    sun = DirectionalModel(
        type="directional",
        direction=tuple(shot.wi),
        irradiance=(1.0, 1.0, 1.0),
        angular_diameter_deg=width_deg,
    )
    plain = shot.scene(Path("original.rna"), samples)
    scene = Scene.model_validate({**dict(plain), "lights": (sun,)})
    size = shot.resolution, shot.resolution
    described = cycles_scene(scene)
    view = shot.to_world, float(FOV_Y)
    return float(worker.render_scene(described, *view, samples, 1, *size)[..., :3].mean())


def add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("sources", nargs="+", type=Path, help="scripts or models of surfaces")
    parser.add_argument("--resolution", type=int, default=160, help="width and height, pixels")
    parser.add_argument("--samples", type=int, default=512, help="paths per pixel")
    add_out(parser)

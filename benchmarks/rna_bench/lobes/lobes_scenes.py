"""Path tracing with the environment by rays and by lobes: error over time of both.

    rna-bench lobes-scenes toy.rna fox.rna --environment forest studio --out bench/lobes

Packages with lobes (`RNA_environment`), alone and on a grey ground, under each environment, are
rendered both ways by turns with rising sample counts. Errors are those against a long image by
rays: relative squared error over the pixels that the asset covers, their PSNR, FLIP of the image.
The error of many samples by lobes is their bias. Writes JSON, a chart of error over CPU time, and a
sheet of images. Run it on an idle machine.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from PIL import Image

from rna_bench.lobes.lobes_scenes_chart import draw_errors
from rna_bench.plot_style import save_chart
from rna_bench.results import write_results
from rna_bench.scenes.scene_list import find_environment
from rna_bench.scenes.stage import Stage
from rna_export.metrics import IRRADIANCE, flip, psnr, to_png
from rna_render import World, load_world, make_integrator, render
from rna_render.scene import Scene, SceneFile
from rna_sdk.errors import SceneError
from rna_sdk.runtime import load
from rna_work.progress import Progress

WAYS = ("rays", "lobes")
_SHOWN = 0.95  # part of the asset's values that the exposure shows below white
_REFERENCE_SEED = 1000
_DARK = 0.01  # of the mean square, beside each pixel's own square

DEFINITIONS = {
    "cpu_seconds": "of all threads, of rendering alone",
    "error": "mean over the asset's pixels of squared error over the reference's square plus 1% of "
    "its mean square",
    "psnr": "dB, over the asset's pixels; the exposure shows 95% of the reference below white",
    "flip": "mean FLIP of the image, with that exposure",
    "brightness": "light from the asset's pixels over the reference's, red, green, blue",
    "times_as_fast": "CPU time of rays to the error of this image, over its own; the error of "
    "rays is fitted as one over their samples, their time as a line",
}


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of this command."""
    parser.add_argument("packages", type=Path, nargs="+", help="assets with lobes (paths)")
    parser.add_argument("--out", type=Path, required=True, help="folder for results (path)")
    parser.add_argument(
        "--environment",
        nargs="+",
        default=["forest", "studio"],
        metavar="FILE",
        help="environment maps, EXR or HDR, or names of those shipped with Blender",
    )
    parser.add_argument(
        "--samples",
        type=int,
        nargs="+",
        default=[1, 2, 4, 8, 16, 32],
        help="per pixel, of the images whose time counts",
    )
    parser.add_argument(
        "--reference-samples", type=int, default=512, help="by rays, of the image of reference"
    )
    parser.add_argument(
        "--bias-samples", type=int, default=64, help="by lobes, of the image that tells their bias"
    )
    parser.add_argument("--resolution", type=int, nargs=2, default=[256, 192], help="width, height")
    parser.add_argument("--tier", help="tier of the assets (text, default: their first)")
    parser.add_argument("--turn", type=float, default=0.0, help="camera rotation, degrees")


def run(args: argparse.Namespace) -> None:
    """Render, compare, and write the results."""
    environments = [find_environment(name) for name in args.environment]
    args.out.mkdir(parents=True, exist_ok=True)
    report: dict[str, Any] = {"definitions": DEFINITIONS, "scenes": {}}
    sheet = []
    with Progress(len(args.packages) * len(environments) * 2, "scene", "measuring") as progress:
        for package in args.packages:
            for name, scene in _scenes(package, environments, args).items():
                report["scenes"][name], row = _measured(scene, args)
                sheet.append(row)
                progress.advance({})
    write_results(args.out / "lobes-scenes.json", args.stamp, report)
    save_chart(draw_errors(report["scenes"]), args.out / "lobes-scenes.svg")
    Image.fromarray(np.concatenate(sheet)).save(args.out / "lobes-scenes.png")
    names = ("lobes-scenes.json", "lobes-scenes.svg", "lobes-scenes.png")
    print("wrote " + ", ".join(str(args.out / name) for name in names))


def _scenes(package: Path, environments: list[Path], args: argparse.Namespace) -> dict[str, Scene]:
    asset = load(package, tier=args.tier, threads=1)
    if all(part.environment_form is None for part in asset.parts):
        raise SceneError(f"{package}: no part has lobes (RNA_environment)")
    view = {"turn_deg": args.turn, "resolution": tuple(args.resolution)}
    stage = Stage.of(asset, package.resolve(), args.tier, **view)
    found = {}
    for path in environments:
        sky = stage.environment(path)
        found[f"{asset.name}, {path.stem}"] = stage.scene(sky)
        found[f"{asset.name}, {path.stem}, ground"] = stage.scene(sky, ground=stage.ground)
    return found


def _measured(scene: Scene, args: argparse.Namespace) -> tuple[dict[str, Any], np.ndarray]:
    """Figures of both ways, and a row of images: the reference, rays, lobes, the lobes' bias."""
    world = load_world(SceneFile(Path("scene.yaml"), scene, {}))
    for way in WAYS:
        _render(scene, world, way, 1, 0)  # compiles
    reference, channels, _ = _render(scene, world, "rays", args.reference_samples, _REFERENCE_SEED)
    judge = _Judge(reference, channels["assetId"] == 1)
    rows: dict[str, list[dict[str, Any]]] = {way: [] for way in WAYS}
    images = {}
    for samples in sorted(args.samples):
        for way in WAYS:
            image, _, seconds = _render(scene, world, way, samples, samples)
            images[way, samples] = image
            rows[way].append({"samples": samples, "cpu_seconds": seconds, **judge(image)})
    for row in rows["lobes"]:
        row["times_as_fast"] = _times_as_fast(row, rows["rays"])
    limit, _, _ = _render(scene, world, "lobes", args.bias_samples, 0)
    bias = {"samples": args.bias_samples, **judge(limit)}
    shown = min(args.samples, key=lambda n: abs(n - 4))
    pictures = reference, images["rays", shown], images["lobes", shown], limit
    strip = np.concatenate([judge.picture(image) for image in pictures], axis=1)
    return {**rows, "bias": bias}, strip


def _render(
    scene: Scene, world: World, way: str, samples: int, seed: int
) -> tuple[np.ndarray, dict[str, np.ndarray], float]:
    """RGB, all channels, and CPU seconds."""
    changes: dict[str, Any] = {"samples": samples, "seed": seed}
    if way == "lobes":
        changes["quality"] = {"environment": "lobes"}
    scene = Scene.model_validate({**scene.model_dump(), **changes})
    integrator = make_integrator(scene, world)
    begun = process_time()
    channels = render(scene, integrator).channels()
    seconds = process_time() - begun
    return np.stack([channels[c] for c in "RGB"], axis=-1), channels, seconds


class _Judge:
    """Errors of images against a reference, (h, w, 3); asset: (h, w) bool, its pixels."""

    def __init__(self, reference: np.ndarray, asset: np.ndarray) -> None:
        self._reference, self._asset = reference, asset
        shown = float(np.quantile(reference[asset], _SHOWN))
        self._exposure = 1.0 / max(shown, 1e-12) / IRRADIANCE
        square = np.square(reference[asset], dtype=np.float64)
        self._scale = square + _DARK * square.mean()

    def __call__(self, image: np.ndarray) -> dict[str, Any]:
        ours, theirs = image[self._asset], self._reference[self._asset]
        error = np.square(ours.astype(np.float64) - theirs) / self._scale
        brightness = ours.sum(axis=0, dtype=np.float64) / theirs.sum(axis=0, dtype=np.float64)
        return {
            "error": float(error.mean()),
            "psnr": psnr(ours, theirs, self._exposure),
            "flip": flip(image, self._reference, self._exposure)[0],
            "brightness": np.round(brightness, 4).tolist(),
        }

    def picture(self, image: np.ndarray) -> np.ndarray:
        """As displayed, (h, w, 3) uint8."""
        return to_png(image, self._exposure)


def _times_as_fast(row: dict[str, Any], rays: list[dict[str, Any]]) -> float:
    counts = np.array([one["samples"] for one in rays], float)
    a = np.exp(np.mean(np.log([one["error"] for one in rays] * counts)))
    slope, start = np.polyfit(counts, [one["cpu_seconds"] for one in rays], 1)
    return float((start + slope * a / row["error"]) / row["cpu_seconds"])

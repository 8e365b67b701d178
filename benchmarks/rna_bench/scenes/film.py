"""Render an asset in motion beside Cycles with the original, frame by frame, as one film.

    rna-bench film walk.yaml --source lamb.py --out bench/lamb

A scene file with one asset in motion and `animation.frames`. Writes film.webp (ours on the left),
film.json with the time and the difference of each frame, and frames as PNG. Both are denoised. A
frame's time holds all that moves: bending, trees, rendering and denoising, without reading files;
its CPU seconds are those of all threads, which say more on a busy machine. Finished frames are
kept. Arguments after -- are passed to a source that is a Python script.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image
from tqdm import tqdm

from rna_bench.results import write_results
from rna_bench.scenes.beside_cycles import Beside
from rna_export.capture.blender_process import blender_env
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.compare.cycles_scene import cycles_scene
from rna_render import Camera, Denoiser, load_world, make_integrator, render
from rna_render.scene import Scene, SceneFile, frame_scene, read_scene
from rna_render.world.world_loading import Loaded
from rna_sdk.errors import SceneError
from rna_sdk.machine.cores import core_count

_QUALITY = 82  # of the film's WebP
_GAP = 2  # pixels between ours and Cycles'
_TIMES = ("ours_seconds", "cycles_seconds", "ours_cpu_seconds", "cycles_cpu_seconds")


def add_options(p: argparse.ArgumentParser) -> None:
    """The options of the command."""
    p.add_argument("scene", type=Path, help="scene file with an asset in motion (path)")
    p.add_argument("--source", type=Path, required=True, help="the moving model (path, required)")
    p.add_argument("--out", type=Path, required=True, help="folder (path, required)")
    p.add_argument("--cycles-samples", type=int, default=32, help="Cycles samples per pixel")


def run(args: argparse.Namespace) -> None:
    """Render the missing frames; write the film, its figures and PNGs."""
    scene_file = read_scene(args.scene)
    animation = scene_file.scene.animation
    if animation is None or all(asset.motion is None for asset in scene_file.scene.assets):
        raise SceneError(f"{args.scene}: found no `animation`, or no asset with a `motion`")
    frames = range(animation.frames)
    missing = [k for k in frames if not _frame_file(args.out, k).is_file()]
    if missing:
        _render(args, scene_file, missing)
    both = [dict(np.load(_frame_file(args.out, k))) for k in frames]
    exposure = Beside.of(both[0]["cycles"][None], both[0]["alpha"] > 0.5).exposure
    shown = [_shown(frame, exposure) for frame in both]
    rows = [_row(k, frame, exposure) for k, frame in enumerate(both)]
    _write(args, scene_file.scene, rows, shown)


def _frame_file(out: Path, frame: int) -> Path:
    return out / "frames" / f"{frame:04d}.npz"


def _render(args: argparse.Namespace, scene_file: SceneFile, frames: list[int]) -> None:
    source = Source(args.source, tuple(args.script_arguments))
    ours = _Ours(scene_file)
    ours.render(frames[0])  # kernels are compiled, files are read
    with tempfile.TemporaryDirectory() as folder:
        at = blender_env.find_or_set_up(), source, Path(folder), core_count()
        with BlenderWorker(*at) as worker:
            first = worker.frame_span()[0]
            cycles = _Cycles(worker, scene_file.resolved, args.cycles_samples)
            for k in tqdm(frames, unit="frame", leave=False):
                mine, alpha = ours.render(k)
                theirs = cycles.render(first + k)
                path = _frame_file(args.out, k)
                path.parent.mkdir(parents=True, exist_ok=True)
                seconds = np.array([mine.seconds, theirs.seconds, mine.of_cpu, theirs.of_cpu])
                np.savez(path, ours=mine.pixels, cycles=theirs.pixels, alpha=alpha, seconds=seconds)


@dataclass(frozen=True)
class _Frame:
    """An image, (h, w, 3) float32, its render time and its time on all processors, s."""

    pixels: np.ndarray
    seconds: float
    of_cpu: float


class _Ours:
    """Our frames; files are read once."""

    def __init__(self, scene_file: SceneFile) -> None:
        self._file, self._denoiser, self._loaded = scene_file, Denoiser(core_count()), Loaded()

    def render(self, frame: int) -> tuple[_Frame, np.ndarray]:
        """The image and the alpha of frame `frame` of the scene."""
        scene = frame_scene(self._file.scene, frame)
        begun, worked = time.perf_counter(), time.process_time()
        world = load_world(replace(self._file, scene=scene), loaded=self._loaded)
        film = render(scene, make_integrator(scene, world))
        channels = film.channels()
        image = self._denoiser.of_channels(channels, film.variance())
        taken = time.perf_counter() - begun, time.process_time() - worked
        return _Frame(image, *taken), channels["assetId"] == 1


class _Cycles:
    """Frames of the original."""

    def __init__(self, worker: BlenderWorker, scene: Scene, samples: int) -> None:
        self._worker, self._described = worker, cycles_scene(scene)
        view = Camera(scene.camera, scene.resolution)
        fov = np.radians(scene.camera.vertical_fov_deg)
        self._at = view.to_world, fov, samples, 1, *scene.resolution
        self._image()  # builds the scene

    def _image(self) -> np.ndarray:
        image, _ = self._worker.render_scene(self._described, *self._at, denoise=True)
        return image[..., :3]

    def render(self, frame: int) -> _Frame:
        """The image of frame `frame` of the source."""
        begun, worked = time.perf_counter(), self._of_cpu()
        self._worker.show_frame(frame)
        image = self._image()
        taken = time.perf_counter() - begun, self._of_cpu() - worked
        return _Frame(image, *taken)

    def _of_cpu(self) -> float:
        """Seconds so far; not a number where the system does not tell."""
        return self._worker.processor_seconds() or np.nan


def _beside(frame: dict[str, np.ndarray], exposure: float) -> Beside:
    halves = np.stack([frame["cycles"]] * 2)
    return Beside(halves, exposure, frame["alpha"] > 0.5)


def _row(number: int, frame: dict[str, np.ndarray], exposure: float) -> dict[str, Any]:
    beside = _beside(frame, exposure)
    seconds = np.round(frame["seconds"], 3).tolist()
    return {
        "frame": number,
        **dict(zip(_TIMES, seconds, strict=True)),
        "flip": round(beside.flip(frame["ours"]).mean, 4),
        "brightness": np.round(beside.brightness(frame["ours"]), 3).tolist(),
    }


def _shown(frame: dict[str, np.ndarray], exposure: float) -> Image.Image:
    """Ours and Cycles' side by side, as displayed."""
    beside = _beside(frame, exposure)
    ours, theirs = beside.picture(frame["ours"]), beside.picture(frame["cycles"])
    gap = np.full((len(ours), _GAP, 3), 255, np.uint8)
    return Image.fromarray(np.concatenate([ours, gap, theirs], axis=1))


def _write(
    args: argparse.Namespace, scene: Scene, rows: list[dict[str, Any]], shown: list[Image.Image]
) -> None:
    for k, image in enumerate(shown):
        image.save(args.out / "frames" / f"{k:04d}.png")
    moving, figures = args.out / "film.webp", args.out / "film.json"
    shown[0].save(
        moving,
        save_all=True,
        append_images=shown[1:],
        duration=round(1000 / 12),
        loop=0,
        quality=_QUALITY,
        method=6,
    )
    median = {name: float(np.median([row[name] for row in rows])) for name in (*_TIMES, "flip")}
    settings = {
        "resolution": list(scene.resolution),
        "samples": scene.samples,
        "cycles_samples": args.cycles_samples,
    }
    write_results(figures, args.stamp, {**settings, "median": median, "frames": rows})
    print(f"wrote {moving}, {figures}")

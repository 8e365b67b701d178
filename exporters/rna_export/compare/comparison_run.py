"""Renders the same images from the source with Cycles and from the package with ours."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_export.asset_flip import ImageFlip, luminance_level, scene_exposure
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.compare.views import FOV_Y, Frame, Shot, shots_of
from rna_export.metrics import NoiselessPsnr, exposure_of, psnr, psnr_without_noise
from rna_render import World, make_integrator, place_asset, render
from rna_sdk.runtime import Asset


@dataclass(frozen=True)
class Timed:
    """An image and its render time."""

    pixels: np.ndarray
    seconds: float


@dataclass(frozen=True)
class Pair:
    """One picture, both ways; radiance under irradiance 1."""

    shot: Shot
    ours: np.ndarray  # (h, w, 3) float32
    cycles: np.ndarray  # (h, w, 3) float32
    flip: ImageFlip
    psnr: float  # over the pixels that the asset covers in both
    psnr_without_noise: NoiselessPsnr  # against what Cycles would converge to
    coverage: float  # mean difference of alpha over the picture: how far outlines differ
    seconds_ours: float
    seconds_cycles: float
    exposure: float = 1.0  # that FLIP is of, and that it is shown at

    @property
    def error(self) -> str:
        """In words: FLIP and PSNR, neither with Cycles' noise."""
        clean = self.psnr_without_noise
        bound = "at least " if clean.high is None else ""
        return f"FLIP {self.flip.mean:.3f}, PSNR {bound}{clean.db:.1f} dB"


def compare(
    asset: Asset,
    package: Path,
    worker: BlenderWorker,
    samples: int,
    cycles_samples: int,
    resolution: int,
    frame: Frame,
    begin: Callable[[int, int, Shot], None],
    done: Callable[[list[Pair]], None],
) -> list[Pair]:
    """The standard shots, one after the other, each program's time its own.

    FLIP is of each at the exposure of a scene, PSNR of all at that of the first. begin: gets the
    number of an image, from 1, how many there are, and its shot. done: gets the images so far.
    """
    world = World([place_asset(asset, np.eye(4))])
    wanted = shots_of(asset, resolution, frame)
    pairs: list[Pair] = []
    brightest, of_psnr = 0.0, 1.0
    for number, shot in enumerate(wanted, 1):
        begin(number, len(wanted), shot)
        ours = render_ours(shot, world, package, samples)
        cycles = render_cycles(shot, worker, cycles_samples, asset.emits)
        reference = _covered(cycles)
        level = luminance_level(reference)
        brightest = max(brightest, level)  # the first, whose light is in front, or near it
        of_psnr = of_psnr if pairs else exposure_of([reference])
        pairs.append(judge(shot, ours, cycles, scene_exposure(level, brightest), of_psnr))
        done(pairs)
    return pairs


def _covered(cycles: Timed) -> np.ndarray:
    """Radiance of the pixels that show the asset, (n, 3)."""
    mean = cycles.pixels.mean(axis=0)
    return np.asarray(mean[mean[..., 3] > 0.0][:, :3])


def render_ours(shot: Shot, world: World, package: Path, samples: int) -> Timed:
    """The shot from the package: (h, w, 4) float32 RGBA."""
    start = time.perf_counter()
    scene = shot.scene(package, samples)
    channels = render(scene, make_integrator(scene, world)).channels()
    image = np.stack([channels[c] for c in "RGBA"], axis=-1)
    return Timed(image, time.perf_counter() - start)


def render_cycles(shot: Shot, worker: BlenderWorker, samples: int, emits: bool) -> Timed:
    """The shot of the original, as two independent halves of the samples: (2, h, w, 4) float32.

    emits: whether its materials emit light.
    """
    start = time.perf_counter()
    n, view = shot.resolution, (shot.to_world, FOV_Y, shot.wi)
    seeds = 2 * shot.number, 2 * shot.number + 1
    halves = np.stack(
        [worker.render_view(*view, samples // 2, seed, n, n, emits) for seed in seeds]
    )
    return Timed(halves, time.perf_counter() - start)


def judge(shot: Shot, ours: Timed, cycles: Timed, exposure: float, of_psnr: float) -> Pair:
    """Compares the images of `render_ours` and `render_cycles`; of_psnr: the exposure of PSNRs."""
    image, halves = ours.pixels, cycles.pixels
    mean = halves.mean(axis=0, dtype=np.float32)
    covered = (image[..., 3] > 0.0) & (mean[..., 3] > 0.0)
    a, b = np.ascontiguousarray(image[..., :3]), np.ascontiguousarray(mean[..., :3])
    share = np.minimum(image[..., 3], mean[..., 3])
    error = ImageFlip.of(a, np.ascontiguousarray(halves[..., :3]), share, exposure)
    of_halves = [half[covered][:, :3] for half in halves]
    clean = psnr_without_noise(a[covered], of_halves[0], of_halves[1], of_psnr)
    coverage = float(np.abs(image[..., 3] - mean[..., 3]).mean())
    quality = error, psnr(a[covered], b[covered], of_psnr), clean, coverage
    return Pair(shot, a, b, *quality, ours.seconds, cycles.seconds, exposure)

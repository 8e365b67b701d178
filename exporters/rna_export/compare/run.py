"""Renders the same pictures with Cycles from the source and with us from the package."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_export.capture.worker import BlenderWorker
from rna_export.compare.views import FOV_Y, Shot, shots
from rna_export.metrics import flip, psnr, psnr_without_noise
from rna_render.render import make_integrator, render
from rna_render.world import Placement, World
from rna_sdk.runtime import Asset, FiberAsset


@dataclass(frozen=True)
class Pair:
    """One picture, both ways; radiance under irradiance 1."""

    shot: Shot
    ours: np.ndarray  # (h, w, 3) float32
    cycles: np.ndarray  # (h, w, 3) float32
    flip_map: np.ndarray  # (h, w)
    psnr: float  # over the pixels that the asset covers in both
    psnr_without_noise: float  # against what Cycles would converge to
    flip: float
    seconds_ours: float
    seconds_cycles: float


def compare(
    asset: Asset,
    package: Path,
    worker: BlenderWorker,
    samples: int,
    cycles_samples: int,
    resolution: int,
    turn_deg: float,
    cameras: Collection[str],
    done: Callable[[Pair], None],
) -> list[Pair]:
    """The standard shots of the named cameras, one after the other, each program's time its own."""
    world = World([Placement(asset, np.eye(4))])
    pairs = []
    geometry = asset.curves if isinstance(asset, FiberAsset) else asset.mesh
    for number, shot in enumerate(shots(geometry, resolution, turn_deg)):
        if shot.camera_name not in cameras:
            continue
        start = time.perf_counter()
        channels = _ours(shot, world, package, samples)
        middle = time.perf_counter()
        halves = [
            worker.render_view(
                shot.to_world, FOV_Y, shot.wi, cycles_samples // 2, seed, resolution, resolution
            )
            for seed in (2 * number, 2 * number + 1)
        ]
        end = time.perf_counter()
        pairs.append(_pair(shot, channels, halves, middle - start, end - middle))
        done(pairs[-1])
    return pairs


def _ours(shot: Shot, world: World, package: Path, samples: int) -> np.ndarray:
    scene = shot.scene(str(package), samples)
    channels = render(scene, make_integrator(scene, world)).channels()
    return np.stack([channels[c] for c in "RGBA"], axis=-1)


def _pair(
    shot: Shot,
    ours: np.ndarray,
    halves: list[np.ndarray],
    seconds_ours: float,
    seconds_cycles: float,
) -> Pair:
    cycles = np.mean(halves, axis=0, dtype=np.float32)
    covered = (ours[..., 3] > 0.0) & (cycles[..., 3] > 0.0)
    a, b = np.ascontiguousarray(ours[..., :3]), np.ascontiguousarray(cycles[..., :3])
    mean, error = flip(a, b)
    clean = psnr_without_noise(a[covered], *(half[covered][:, :3] for half in halves))
    quality = psnr(a[covered], b[covered]), clean, mean
    return Pair(shot, a, b, error, *quality, seconds_ours, seconds_cycles)

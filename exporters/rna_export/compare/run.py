"""Renders the same pictures with Cycles from the source and with us from the package."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_export.capture.worker import BlenderWorker
from rna_export.compare.views import FOV_Y, Shot, shots
from rna_export.metrics import flip, psnr
from rna_render.render import make_integrator, render
from rna_render.world import Placement, World
from rna_sdk.runtime import Asset


@dataclass(frozen=True)
class Pair:
    """One picture, both ways; radiance under irradiance 1."""

    shot: Shot
    ours: np.ndarray  # (h, w, 3) float32
    cycles: np.ndarray  # (h, w, 3) float32
    flip_map: np.ndarray  # (h, w)
    psnr: float  # over the pixels that the asset covers in both
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
    done: Callable[[Pair], None],
) -> list[Pair]:
    """All standard shots, one after the other, each machine's time its own."""
    world = World([Placement(asset, np.eye(4))])
    pairs = []
    for number, shot in enumerate(shots(asset.mesh.positions, resolution, turn_deg)):
        start = time.perf_counter()
        channels = _ours(shot, world, package, samples)
        middle = time.perf_counter()
        cycles = worker.render_view(
            shot.to_world, FOV_Y, shot.wi, cycles_samples, number, resolution, resolution
        )
        end = time.perf_counter()
        pairs.append(_pair(shot, channels, cycles, middle - start, end - middle))
        done(pairs[-1])
    return pairs


def _ours(shot: Shot, world: World, package: Path, samples: int) -> np.ndarray:
    scene = shot.scene(str(package), samples)
    channels = render(scene, make_integrator(scene, world)).channels()
    return np.stack([channels[c] for c in "RGBA"], axis=-1)


def _pair(
    shot: Shot, ours: np.ndarray, cycles: np.ndarray, seconds_ours: float, seconds_cycles: float
) -> Pair:
    covered = (ours[..., 3] > 0.0) & (cycles[..., 3] > 0.0)
    a, b = np.ascontiguousarray(ours[..., :3]), np.ascontiguousarray(cycles[..., :3])
    mean, error = flip(a, b)
    return Pair(shot, a, b, error, psnr(a[covered], b[covered]), mean, seconds_ours, seconds_cycles)

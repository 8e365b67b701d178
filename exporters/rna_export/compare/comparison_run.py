"""Renders the same images from the source with Cycles and from the package with ours."""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from rna_export.asset_flip import Exposure, ImageFlip, luminance_level, scene_exposures
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.compare.views import Frame, Shot, shots_of
from rna_export.metrics import NoiselessPsnr, exposure_of, psnr, psnr_without_noise
from rna_export.outcome.judged_image import JudgedImage
from rna_render import World, make_integrator, place_asset, render
from rna_render.lights import LUMINANCE
from rna_sdk.commands.error_words import albedo_text
from rna_sdk.runtime import Asset


@dataclass(frozen=True)
class Timed:
    """An image and its render time."""

    pixels: np.ndarray
    seconds: float


@dataclass(frozen=True)
class Rendered:
    """One picture, both ways, not compared yet; see `render_ours` and `render_cycles`."""

    shot: Shot
    ours: Timed
    cycles: Timed

    @property
    def reference(self) -> np.ndarray:
        """Radiance of the pixels that show the asset in Cycles, (n, 3)."""
        mean = self.cycles.pixels.mean(axis=0)
        return np.asarray(mean[mean[..., 3] > 0.0][:, :3])


@dataclass(frozen=True)
class Pair:
    """One picture, both ways; radiance under irradiance 1, or in a white world."""

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
    is_lit: bool = True  # else its FLIP does not count
    judged: JudgedImage | None = None  # pixel by pixel

    @property
    def light(self) -> tuple[float, float]:
        """Sums of luminance of both images, ours first; pixels beside the asset are black."""
        ours, cycles = (float((image @ LUMINANCE).sum()) for image in (self.ours, self.cycles))
        return ours, cycles

    @property
    def error(self) -> str:
        """In words: FLIP and PSNR, neither with Cycles' noise; in a white world the light alone.

        FLIP there comes mostly from our own noise, which suns do not make.
        """
        if (returned := returned_light([self])) is not None:
            return albedo_text(returned, None)
        clean = self.psnr_without_noise
        bound = "at least " if clean.high is None else ""
        text = f"FLIP {self.flip.mean:.3f}, PSNR {bound}{clean.db:.1f} dB"
        return text if self.is_lit else f"{text}; without light, it does not count"


def returned_light(pairs: Sequence[Pair]) -> float | None:
    """Our light over Cycles' in the pictures of white worlds; None of no such light."""
    ours, cycles = np.sum([pair.light for pair in pairs if pair.shot.is_white] or [(0, 0)], axis=0)
    return float(ours / cycles) if cycles > 0.0 else None


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

    FLIP is of each at the exposure of a scene, PSNR under suns at the first one's. begin: gets
    the number of an image, from 1, how many there are, and its shot. done: gets the images so far;
    a new one may change the exposures of those before.
    """
    world = World([place_asset(asset, np.eye(4))])
    wanted = shots_of(asset, resolution, frame)
    rendered: list[Rendered] = []
    pairs: list[Pair] = []
    for number, shot in enumerate(wanted, 1):
        begin(number, len(wanted), shot)
        ours = render_ours(shot, world, package, samples)
        cycles = render_cycles(shot, worker, cycles_samples, asset.emits)
        rendered.append(Rendered(shot, ours, cycles))
        pairs = judged(rendered, pairs)
        done(pairs)
    return pairs


def judged(rendered: Sequence[Rendered], before: Sequence[Pair] = ()) -> list[Pair]:
    """Pairs of all images so far, at the exposures of scenes: of suns, and of white worlds.

    before: pairs of the first of them; those whose exposure stays the same are taken over.
    """
    of_suns = exposure_of([rendered[0].reference])
    pairs: dict[int, Pair] = {}
    for is_white in (False, True):
        numbers = [k for k, one in enumerate(rendered) if one.shot.is_white == is_white]
        levels = [luminance_level(rendered[k].reference) for k in numbers]
        for k, exposure in zip(numbers, scene_exposures(levels), strict=True):
            if k < len(before) and before[k].exposure == exposure.factor:
                pairs[k] = replace(before[k], is_lit=exposure.is_lit)
            else:
                pairs[k] = judge(rendered[k], exposure, exposure.factor if is_white else of_suns)
    return [pairs[k] for k in range(len(rendered))]


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
    halves = [
        worker.render_view(shot.view, shot.light, samples // 2, seed, emits)
        for seed in (2 * shot.number, 2 * shot.number + 1)
    ]
    return Timed(np.stack(halves), time.perf_counter() - start)


def judge(rendered: Rendered, exposure: Exposure, of_psnr: float) -> Pair:
    """Compares both images; of_psnr: the exposure of the PSNRs."""
    image, halves = rendered.ours.pixels, rendered.cycles.pixels
    mean = halves.mean(axis=0, dtype=np.float32)
    covered = (image[..., 3] > 0.0) & (mean[..., 3] > 0.0)
    a, b = np.ascontiguousarray(image[..., :3]), np.ascontiguousarray(mean[..., :3])
    share = np.minimum(image[..., 3], mean[..., 3])
    of_halves = [half[covered][:, :3] for half in halves]
    colours = np.ascontiguousarray(halves[..., :3])
    flip = ImageFlip.of(a, colours, share, exposure.factor)
    return Pair(
        shot=rendered.shot,
        ours=a,
        cycles=b,
        flip=flip,
        psnr=psnr(a[covered], b[covered], of_psnr),
        psnr_without_noise=psnr_without_noise(a[covered], of_halves[0], of_halves[1], of_psnr),
        coverage=float(np.abs(image[..., 3] - mean[..., 3]).mean()),
        seconds_ours=rendered.ours.seconds,
        seconds_cycles=rendered.cycles.seconds,
        exposure=exposure.factor,
        is_lit=exposure.is_lit,
        judged=JudgedImage.of_picture(rendered.shot.name, exposure.factor, a, colours, share, flip),
    )

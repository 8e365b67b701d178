"""Errors of a measured scene: noise apart from the package's own error, equal error."""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from rna_bench.scenes.beside_cycles import Beside
from rna_bench.scenes.equal_error import equal_error, equal_time
from rna_bench.scenes.measured_scene import MeasuredScene
from rna_bench.scenes.timed_images import CYCLES, OURS, image_of, label_of
from rna_export.compare.comparison_run import Timed
from rna_export.metrics import NoiselessPsnr

Row = dict[str, Any]


def judge(measured: MeasuredScene) -> dict[str, Any]:
    """The scene's figures: `ours`, `cycles` and their denoised rows, and `floor`."""
    beside, plan = measured.beside, measured.plan
    cycles = _rows(measured, CYCLES, plan.cycles_samples, False)
    ours = _rows(measured, OURS, plan.samples, False)
    for row in ours:
        image = measured.images[label_of(OURS, row["samples"])]
        row["noise"] = _noise(beside, image, measured.floor)
        row["equal_error"] = equal_error(row, cycles)
    return {
        "exposure": beside.exposure,
        "instances": len(measured.scene.assets),
        "covered": float(beside.asset.mean()),
        "floor": {
            "samples": plan.floor_samples,
            **_errors(beside, measured.floor),
            "brightness": beside.brightness(measured.floor).tolist(),
        },
        "ours": ours,
        "ours_denoised": _rows(measured, OURS, plan.samples, True),
        "cycles": cycles,
        "cycles_denoised": _rows(measured, CYCLES, plan.cycles_samples, True),
    }


@dataclass(frozen=True)
class Shown:
    """A picture of the sheet, (h, w, 3) uint8; flip: its FLIP map, None for the reference."""

    caption: str
    picture: np.ndarray
    flip: np.ndarray | None = None
    flip_mean: float = 0.0


def shown_pictures(measured: MeasuredScene) -> list[Shown]:
    """Ours with `plan.shown` samples and Cycles' of about the same time, raw and denoised; floor;
    reference.
    """
    plan, images = measured.plan, measured.images
    result = []
    for denoised in (False, True):
        word = ", denoised" if denoised else ""
        ours = image_of(images, label_of(OURS, plan.shown, denoised))
        if ours is None:
            continue
        samples, cycles = _of_equal_time(measured, ours.seconds, denoised)
        caption = f"ours{word}: {plan.shown} samples, {ours.seconds:.2f} s"
        result.append(_shown(measured.beside, caption, ours.pixels))
        caption = f"Cycles{word}: {samples} samples, {cycles.seconds:.2f} s"
        result.append(_shown(measured.beside, caption, cycles.pixels))
    result.append(_shown(measured.beside, f"ours: {plan.floor_samples} samples", measured.floor))
    caption = f"reference: Cycles, {plan.reference_samples} samples"
    return [*result, Shown(caption, measured.beside.picture(measured.beside.reference))]


def _shown(beside: Beside, caption: str, image: np.ndarray) -> Shown:
    return Shown(
        caption, beside.picture(image), beside.flip_picture(image), beside.flip(image).mean
    )


def _of_equal_time(measured: MeasuredScene, seconds: float, denoised: bool) -> tuple[int, Timed]:
    """Cycles' image with the nearest render time."""
    counts = measured.plan.cycles_samples
    images = [image_of(measured.images, label_of(CYCLES, n, denoised)) for n in counts]
    known = [(n, image) for n, image in zip(counts, images, strict=True) if image is not None]
    return known[equal_time(seconds, [{"seconds": image.seconds} for _, image in known])]


def _rows(measured: MeasuredScene, who: str, counts: Any, denoised: bool) -> list[Row]:
    rows = []
    for samples in counts:
        image = image_of(measured.images, label_of(who, samples, denoised))
        if image is not None:
            errors = _errors(measured.beside, image.pixels)
            rows.append({"samples": samples, "seconds": image.seconds, **errors})
    return rows


def _errors(beside: Beside, image: np.ndarray) -> Row:
    of_asset, flip = beside.psnr(image), beside.flip(image)
    return {
        "psnr": of_asset.db,
        "psnr_interval": [of_asset.low, of_asset.high],
        "psnr_everywhere": asdict(beside.psnr(image, np.ones_like(beside.asset))),
        "flip": flip.mean,
        "flip_p95": flip.p95,
    }


def _noise(beside: Beside, image: np.ndarray, floor: np.ndarray) -> float:
    """PSNR of our image against ours with hardly any noise, over the asset's pixels, dB."""
    noise: NoiselessPsnr = Beside(np.stack([floor, floor]), beside.exposure, beside.asset).psnr(
        image
    )
    return noise.db

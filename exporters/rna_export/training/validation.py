"""Shades whole captured images in PyTorch: the paper's deferred shading, and its scores."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from rna_export.asset_flip import Exposure
from rna_export.capture.dataset.validation_view import CapturedImage, EmissionView, ValidationView
from rna_export.metrics import (
    NoiselessPsnr,
    emission_exposure,
    exposure_of,
    flip,
    plain,
    psnr,
    psnr_without_noise,
    relative_mse,
    to_png,
)
from rna_export.pictures import comparison_sheet, enlarged, pictures_of, write_picture
from rna_export.training.asset_error import (
    asset_error,
    image_flip,
    picture_exposures,
    smallest_factor,
)
from rna_export.training.model.neural_asset import NeuralAsset

_ROWS = 65536
_PICTURED = 12
_UNLIT = "without light, does not count"


@dataclass(frozen=True)
class Scores:
    """Means over the validation images, as `rna_export.metrics` defines them."""

    psnr: float
    flip: float  # as `rna_export.asset_flip` defines it
    relative_mse: float
    psnr_of_references: float  # one half of the paths against the other: what noise allows
    psnr_without_noise: NoiselessPsnr  # of the model against what the references would converge to
    images: int


def shade(model: NeuralAsset, view: ValidationView) -> np.ndarray:
    """Radiance (n, 3) of a view's rows, the output picked by visibility."""
    nearby = view.nearby(model.config.nearby)
    queries = view.queries if nearby is None else {**view.queries, "nearby": nearby}
    return view.pick(*answer(model, queries))


@torch.no_grad()
def shade_emission(model: NeuralAsset, view: EmissionView) -> np.ndarray:
    """Emitted radiance (n, 3) of a view's rows."""
    (emission, planes), device = model.emitting, model.ceiling.device
    at = {k: torch.from_numpy(np.ascontiguousarray(v)).to(device) for k, v in view.queries.items()}
    return emission.radiance(emission(planes, at)).cpu().numpy()


def answer(model: NeuralAsset, queries: dict[str, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Radiance where the light is visible, and where it is shadowed, (n, 3) float32 each.

    queries: as `ValidationView.queries` has them, n rows.
    """
    both = in_batches(model, queries, model.transport)
    return both[:, 0], both[:, 1]


@torch.no_grad()
def in_batches(
    model: NeuralAsset, queries: dict[str, np.ndarray], of: Callable[[Tensor], Tensor]
) -> np.ndarray:
    """The results of `of` for the model's output y, (n, k, 3) float32, some queries at a time.

    queries: as `ValidationView.queries` has them, n rows. of: `NeuralAsset.colours` or `transport`.
    """
    device, colours = model.ceiling.device, len(model.colour_sums[0])
    parts = [of(torch.zeros(0, colours, 3, device=device))]
    for first in range(0, len(queries["position"]), _ROWS):
        rows = {k: np.ascontiguousarray(v[first : first + _ROWS]) for k, v in queries.items()}
        parts.append(of(model({k: torch.from_numpy(v).to(device) for k, v in rows.items()})))
    return np.asarray(torch.cat(parts).cpu().numpy())


def exposure(views: Sequence[CapturedImage]) -> float:
    """Exposure at which the views are scored and shown: 1 unless the asset is dark."""
    references = [view.reference for view in views]
    if all(isinstance(view, EmissionView) for view in views):
        return emission_exposure(references)
    return exposure_of(references)


def reference_warnings(views: Sequence[CapturedImage]) -> list[str]:
    """Warnings about references for which a PSNR misleads."""
    appearance = plain([view.reference for view in views])
    if appearance is not None:
        return [
            f"warning: the validation images are {appearance}, so no error can be measured: is the "
            "source lit from outside, and are its textures there?"
        ]
    factor = exposure(views)
    if factor > 1.0:
        return [f"note: the asset is dark; its scores are taken {factor:.3g} times as bright"]
    return []


def score(radiance: list[np.ndarray], views: Sequence[CapturedImage]) -> Scores:
    """Scores of shaded rows against the captured ones."""
    pairs, e = [(r, v.reference, v) for r, v in zip(radiance, views, strict=True)], exposure(views)
    of_references = [psnr(v.halves[0], v.halves[1], e) for v in views]
    return Scores(
        psnr=mean_psnr(radiance, views),
        flip=asset_error(radiance, views).mean,
        relative_mse=float(np.mean([relative_mse(r, t) for r, t, _ in pairs])),
        # The mean of both halves has half the variance of either, their difference twice it.
        psnr_of_references=float(np.mean(of_references)) + 6.02,
        psnr_without_noise=noiseless_psnr(radiance, views),
        images=len(views),
    )


def noiseless_psnr(radiance: list[np.ndarray], views: Sequence[CapturedImage]) -> NoiselessPsnr:
    """Mean PSNR of shaded rows against the common limit of both halves of the captured ones."""
    pairs, e = zip(radiance, views, strict=True), exposure(views)
    each = [psnr_without_noise(r, v.halves[0], v.halves[1], e) for r, v in pairs]
    return NoiselessPsnr.mean(each)


def mean_psnr(radiance: list[np.ndarray], views: Sequence[CapturedImage]) -> float:
    """Mean PSNR of shaded rows against the captured ones: the cheapest score."""
    pairs, e = zip(radiance, views, strict=True), exposure(views)
    return float(np.mean([psnr(shaded, view.reference, e) for shaded, view in pairs]))


def _pictured(
    radiance: list[np.ndarray], views: Sequence[CapturedImage]
) -> Iterator[tuple[np.ndarray, CapturedImage, Exposure]]:
    """The first views, each with its shaded image, and with its exposure among all of them."""
    every = zip(radiance, views, picture_exposures(views), strict=True)
    return islice(every, _PICTURED)


def write_images(folder: Path, radiance: list[np.ndarray], views: Sequence[CapturedImage]) -> None:
    """One PNG of each of the first views, exposed as in a scene: ours, Cycles, the FLIP map."""
    folder.mkdir(parents=True, exist_ok=True)
    for shaded, view, e in _pictured(radiance, views):
        ours, cycles = view.image(shaded), view.image(view.reference)
        error = np.clip(255.0 * flip(ours, cycles, e.factor)[1], 0, 255).astype(np.uint8)
        pictures = [to_png(picture, e.factor) for picture in (ours, cycles)]
        row = [*pictures, np.repeat(error[..., None], 3, axis=2)]
        path = folder / f"view-{view.index:02d}.png"
        write_picture(path, np.concatenate([enlarged(picture) for picture in row], axis=1))


def write_sheet(
    path: Path,
    radiance: list[np.ndarray],
    views: Sequence[CapturedImage],
    notes: Sequence[str] = (),
) -> None:
    """A contact sheet of the first views, exposed as in a scene: ours, Cycles, difference, FLIP.

    notes: lines below.
    """
    rows = []
    for shaded, view, e in _pictured(radiance, views):
        error = f"FLIP {image_flip(shaded, view, e.factor, smallest_factor(views)).mean:.3f}"
        caption = f"validation image {view.index}: {error if e.is_lit else _UNLIT}"
        pictures = pictures_of(view.image(shaded), view.image(view.reference), e.factor)
        rows.append((pictures, caption))
    write_picture(path, comparison_sheet(rows, notes=notes))

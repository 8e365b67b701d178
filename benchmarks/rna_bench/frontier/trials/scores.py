"""Scores of a model's shaded validation images, in total and per image."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from pydantic import BaseModel

from rna_export.asset_flip import asset_flip
from rna_export.capture.dataset.validation_view import CapturedImage
from rna_export.metrics import (
    NoiselessPsnr,
    flip,
    psnr,
    psnr_without_noise,
    relative_error_p99,
    relative_mse,
    to_png,
)
from rna_export.pictures import write_picture
from rna_export.training.asset_error import image_flip, picture_exposures, smallest_factor
from rna_export.training.validation import exposure


class ViewScores(BaseModel, frozen=True):
    """Scores of one validation image."""

    psnr: float
    flip: float
    p99: float


class ModelScores(BaseModel, frozen=True):
    """Means over the images, as `rna_export.metrics` and `asset_flip` define them."""

    psnr: float
    psnr_without_noise: NoiselessPsnr
    flip: float
    flip_p95: float
    p99: float
    relative_mse: float
    views: tuple[ViewScores, ...]


def judge(
    radiance: list[np.ndarray], views: Sequence[CapturedImage]
) -> tuple[ModelScores, list[np.ndarray]]:
    """Scores of shaded rows, (n, 3) a view, against the captured ones; FLIP maps (h, w)."""
    pairs, e = [(r, v.reference, v) for r, v in zip(radiance, views, strict=True)], exposure(views)
    exposures, size = picture_exposures(views), smallest_factor(views)
    errors = [
        image_flip(r, view, x.factor, size)
        for (r, _, view), x in zip(pairs, exposures, strict=True)
    ]
    each = [
        ViewScores(psnr=psnr(r, t, e), flip=error.mean, p99=relative_error_p99(r, t))
        for (r, t, _), error in zip(pairs, errors, strict=True)
    ]
    clean = [psnr_without_noise(r, view.halves[0], view.halves[1], e) for r, _, view in pairs]
    of_asset = asset_flip([one for one, x in zip(errors, exposures, strict=True) if x.is_lit])
    scores = ModelScores(
        psnr=float(np.mean([view.psnr for view in each])),
        psnr_without_noise=NoiselessPsnr.mean(clean),
        flip=of_asset.mean,
        flip_p95=of_asset.p95,
        p99=float(np.mean([view.p99 for view in each])),
        relative_mse=float(np.mean([relative_mse(r, t) for r, t, _ in pairs])),
        views=tuple(each),
    )
    shown = zip(pairs, exposures, strict=True)
    return scores, [flip(view.image(r), view.image(t), x.factor)[1] for (r, t, view), x in shown]


def write_strips(
    stem: Path, radiance: list[np.ndarray], views: Sequence[CapturedImage], flips: list[np.ndarray]
) -> None:
    """`<stem>-render.png` and `<stem>-flip.png` (grey): all views in a row."""
    shown = zip(radiance, views, picture_exposures(views), strict=True)
    renders = [to_png(view.image(rows), e.factor) for rows, view, e in shown]
    errors = np.clip(255.0 * np.concatenate(flips, axis=1) + 0.5, 0, 255).astype(np.uint8)
    write_picture(stem.with_name(f"{stem.name}-render.png"), np.concatenate(renders, axis=1))
    write_picture(stem.with_name(f"{stem.name}-flip.png"), errors)

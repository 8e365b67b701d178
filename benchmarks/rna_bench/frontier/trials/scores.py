"""Scores of a model's shaded validation images, in total and per image."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from pydantic import BaseModel, ConfigDict

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
from rna_export.training.validation import exposure


class ViewScores(BaseModel):
    """Scores of one validation image."""

    model_config = ConfigDict(frozen=True)

    psnr: float
    flip: float
    p99: float


class ModelScores(BaseModel):
    """Means over the images, as `rna_export.metrics` defines them."""

    model_config = ConfigDict(frozen=True)

    psnr: float
    psnr_without_noise: NoiselessPsnr
    flip: float
    p99: float
    relative_mse: float
    views: tuple[ViewScores, ...]


def judge(
    radiance: list[np.ndarray], views: Sequence[CapturedImage]
) -> tuple[ModelScores, list[np.ndarray]]:
    """Scores of shaded rows, (n, 3) a view, against the captured ones; FLIP maps (h, w)."""
    pairs, e = [(r, v.reference, v) for r, v in zip(radiance, views, strict=True)], exposure(views)
    flips = [flip(view.image(r), view.image(t), e) for r, t, view in pairs]
    each = [
        ViewScores(psnr=psnr(r, t, e), flip=mean, p99=relative_error_p99(r, t))
        for (r, t, _), (mean, _) in zip(pairs, flips, strict=True)
    ]
    clean = [psnr_without_noise(r, view.halves[0], view.halves[1], e) for r, _, view in pairs]
    scores = ModelScores(
        psnr=float(np.mean([view.psnr for view in each])),
        psnr_without_noise=NoiselessPsnr.mean(clean),
        flip=float(np.mean([view.flip for view in each])),
        p99=float(np.mean([view.p99 for view in each])),
        relative_mse=float(np.mean([relative_mse(r, t) for r, t, _ in pairs])),
        views=tuple(each),
    )
    return scores, [errors for _, errors in flips]


def write_strips(
    stem: Path, radiance: list[np.ndarray], views: Sequence[CapturedImage], flips: list[np.ndarray]
) -> None:
    """`<stem>-render.png` and `<stem>-flip.png` (grey): all views in a row."""
    e = exposure(views)
    renders = [to_png(view.image(rows), e) for rows, view in zip(radiance, views, strict=True)]
    errors = np.clip(255.0 * np.concatenate(flips, axis=1) + 0.5, 0, 255).astype(np.uint8)
    write_picture(stem.with_name(f"{stem.name}-render.png"), np.concatenate(renders, axis=1))
    write_picture(stem.with_name(f"{stem.name}-flip.png"), errors)

"""What a model's shaded validation images score, all together and one by one."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image
from pydantic import BaseModel, ConfigDict

from rna_export.capture.dataset import ValidationView
from rna_export.metrics import flip, psnr, relative_error_p99, to_png
from rna_export.training.validation import score


class ViewScores(BaseModel):
    """Of one validation image."""

    model_config = ConfigDict(frozen=True)

    psnr: float
    flip: float
    p99: float


class ModelScores(BaseModel):
    """Means over the images, as `rna_export.metrics` defines them."""

    model_config = ConfigDict(frozen=True)

    psnr: float
    psnr_without_noise: float
    flip: float
    p99: float
    relative_mse: float
    views: tuple[ViewScores, ...]


def scores_of(radiance: list[np.ndarray], views: list[ValidationView]) -> ModelScores:
    """Scores of shaded rows, (n, 3) a view, against the captured ones."""
    means, each = score(radiance, views), []
    for shaded, view in zip(radiance, views, strict=True):
        seen = view.samples["radiance"]
        each.append(
            ViewScores(
                psnr=psnr(shaded, seen),
                flip=flip(view.image(shaded), view.image(seen))[0],
                p99=relative_error_p99(shaded, seen),
            )
        )
    return ModelScores(
        psnr=means.psnr,
        psnr_without_noise=means.psnr_without_noise,
        flip=means.flip,
        p99=float(np.mean([one.p99 for one in each])),
        relative_mse=means.relative_mse,
        views=tuple(each),
    )


def write_strips(
    folder: Path, name: str, radiance: list[np.ndarray], views: list[ValidationView]
) -> None:
    """`<name>-render.png` and `<name>-flip.png` (grey): all views in a row."""
    pairs = [
        (v.image(r), v.image(v.samples["radiance"])) for r, v in zip(radiance, views, strict=True)
    ]
    renders = np.concatenate([to_png(image) for image, _ in pairs], axis=1)
    errors = np.concatenate([flip(*pair)[1] for pair in pairs], axis=1)
    Image.fromarray(renders).save(folder / f"{name}-render.png")
    grey = np.clip(255.0 * errors + 0.5, 0, 255).astype(np.uint8)
    Image.fromarray(grey).save(folder / f"{name}-flip.png")

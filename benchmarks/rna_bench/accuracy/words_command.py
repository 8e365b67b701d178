"""Draw what errors look like: models of one asset, from bad to good, each with its FLIP and words.

    rna-bench words toy.rays runs/tiny runs/small toy.rna --out docs/images/error-in-words.jpg

Models are folders of rna-train and packages, all of this dataset. Two of its validation images are
shown: lit from the front, and lit from behind. Words are of the error over all of them, as rna-make
and rna-info say it. Cycles comes last.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from rna_export.asset_flip import AssetFlip
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.metrics import to_png
from rna_export.training.asset_error import asset_error, picture_exposures
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.validation import shade
from rna_sdk.atomic_file import write_atomically
from rna_sdk.error_words import error_in_words
from rna_sdk.runtime import load

_WIDTH = 224  # pixels of a picture
_LINE = 18
_INK, _PAPER = (20, 20, 20), (255, 255, 255)
_QUALITY = 88


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of the command."""
    parser.add_argument("dataset", type=Path, help="dataset of one part (path)")
    parser.add_argument("models", type=Path, nargs="+", help="folders of rna-train, or packages")
    parser.add_argument("--out", type=Path, required=True, help="JPEG to write (path, required)")


def run(args: argparse.Namespace) -> None:
    """Draw the sheet, and print each model's error."""
    part = Dataset(args.dataset).only
    views = [part.view(k) for k in part.dataset.finished_views()]
    columns = []
    for model in args.models:
        radiance = _shaded(model, views)
        error = asset_error(radiance, views)
        print(f"{model}: {error}")
        columns.append((radiance, _caption(error)))
    columns.append(([view.reference for view in views], ["Cycles", ""]))
    data = BytesIO()
    _sheet(columns, views).save(data, "JPEG", quality=_QUALITY)
    write_atomically(args.out, data.getvalue())
    print(f"wrote {args.out}")


def _shaded(model: Path, views: Sequence[ValidationView]) -> list[np.ndarray]:
    """Radiance (n, 3) of each view's rows."""
    if model.suffix == ".rna":
        (asset,) = load(model).parts
        return [view.shaded_by(asset) for view in views]
    trained = load_checkpoint(model / "best.ckpt").model
    return [shade(trained, view) for view in views]


def _caption(error: AssetFlip) -> list[str]:
    """Two lines: the figure, and the first of its words."""
    return [f"FLIP {error.mean:.3f}", error_in_words(error.mean).partition(":")[0]]


def _shown(views: Sequence[ValidationView]) -> list[int]:
    """Of the whole asset lit from the front, and from behind: two views."""
    cosine = [float(np.sum(v.samples["wo"] * v.samples["wi"], axis=1).mean()) for v in views]
    whole = [k for k, view in enumerate(views) if view.index % 4 != 3]  # the others are close-ups
    return [max(whole, key=cosine.__getitem__), min(whole, key=cosine.__getitem__)]


def _sheet(
    columns: Sequence[tuple[list[np.ndarray], list[str]]], views: Sequence[ValidationView]
) -> Image.Image:
    """Pictures of a column's radiance below its caption."""
    shown, exposures, top = _shown(views), picture_exposures(views), 2 * _LINE + 6
    sheet = Image.new("RGB", (_WIDTH * len(columns), top + _WIDTH * len(shown)), _PAPER)
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(_LINE - 4)
    for column, (radiance, caption) in enumerate(columns):
        for row, line in enumerate(caption):
            draw.text((column * _WIDTH + 6, 4 + row * _LINE), line, _INK, font)
        for row, k in enumerate(shown):
            pixels = to_png(views[k].image(radiance[k]), exposures[k])
            picture = Image.fromarray(pixels).resize((_WIDTH, _WIDTH), Image.Resampling.NEAREST)
            sheet.paste(picture, (column * _WIDTH, top + row * _WIDTH))
    return sheet

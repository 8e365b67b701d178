"""The models' renders, which a study keeps as strips of all validation views."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.metrics import display
from rna_export.pictures import flip_colours


def strip_path(folder: Path, label: str, what: str) -> Path:
    """All views of a point, or of Cycles ("cycles-16"), side by side, in a study's folder.

    what: "render", or "flip" for the map of its error.
    """
    inside = folder if label.startswith("cycles-") else folder / "trials"
    return inside / f"{label}-{what}.png"


def brightest(views: list[ValidationView], count: int) -> list[int]:
    """The views with the most light in them, the best first."""
    light = [float(display(view.samples["radiance"]).sum()) for view in views]
    return sorted(range(len(views)), key=lambda k: -light[k])[:count]


def cut(strip: Path, chosen: list[int], size: int) -> list[np.ndarray]:
    """Views (size, size, 3) uint8 out of a strip; errors, which are grey, in FLIP's colours."""
    with Image.open(strip) as image:
        pixels = np.asarray(image)
    if pixels.ndim == 2:
        pixels = flip_colours(pixels / 255.0)
    return [pixels[:, k * size : (k + 1) * size] for k in chosen]

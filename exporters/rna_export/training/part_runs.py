"""Division of training time and folder among the parts of an asset."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart

_ALIKE = 0.5  # of the minutes, that all parts get as many of


def shared_minutes(minutes: float | None, parts: Sequence[DatasetPart]) -> dict[str, float | None]:
    """Minutes of each part by name: half of them alike, half as the validation images show it."""
    if minutes is None:
        return {part.name: None for part in parts}
    if len(parts) == 1:
        return {parts[0].name: minutes}
    pixels = np.array([sum(len(v.pixel) for v in part.validation_views()) for part in parts])
    shares = _ALIKE / len(parts) + (1.0 - _ALIKE) * pixels / pixels.sum()
    # Rounded: a resumed run has exactly the same length.
    return {
        part.name: round(minutes * float(share), 3)
        for part, share in zip(parts, shares, strict=True)
    }


def part_folder(folder: Path, dataset: Dataset, part: str) -> Path:
    """Folder of a part's checkpoints: the training's own folder for the only part."""
    return folder if len(dataset.parts) == 1 else folder / part

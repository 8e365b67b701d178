"""The fewest training steps of a package: a model of fewer is a blur, whose error says nothing."""

import math
from collections.abc import Mapping
from pathlib import Path

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.make.carry_on import before_folder
from rna_export.make.phases import trained_in
from rna_export.training.checkpoint import Trained, load_checkpoint
from rna_export.training.part_runs import part_folder
from rna_export.training.presets import PRESETS

_FLOOR = 1 / 40  # of a preset's steps
_TRAINED = 1 / 3  # of more minutes, at least


def too_few_steps(
    work: Path, folders: Mapping[str, Path], dataset: Dataset, seconds: float
) -> str | None:
    """Message instead of a package whose models have too few steps; or None.

    folders: of each preset's models. seconds: that the trainings took, about.
    """
    for preset, folder in folders.items():
        for one in trained_in(folder, dataset):
            kind = dataset.part(one.part).captured.kind
            steps = one.steps + _steps_before(work, folder, dataset, one)
            least = math.ceil(_FLOOR * PRESETS[kind][preset].training.steps)
            if steps < least:
                wanted = (least - steps) * seconds / max(one.steps, 1) / _TRAINED
                more = max(1, math.ceil(wanted / 60.0))
                lights = dataset.manifest.settings.lights
                return (
                    f"{work}: the time was up after {steps:,} training steps of {preset!r}, "
                    f"expected {least:,} at least for a package; this machine is slow or busy. "
                    f"{lights:,} lights are kept: --more {more} goes on from them"
                )
    return None


def _steps_before(work: Path, folder: Path, dataset: Dataset, one: Trained) -> int:
    """Steps of the model that a training started from."""
    before = before_folder(work, one.preset_name)
    path = part_folder(before, dataset, one.part) / "best.ckpt"
    return load_checkpoint(path).steps if path.is_file() and folder != before else 0

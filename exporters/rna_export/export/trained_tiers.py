"""Groups checkpoints into tiers: one checkpoint per part and preset."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.training.checkpoint import Trained
from rna_sdk.errors import ExportError

BEST = "best.ckpt"


@dataclass(frozen=True)
class TrainedTier:
    """The models of one preset, in the order of the dataset's parts."""

    preset_name: str
    parts: tuple[Trained, ...]


def checkpoint_paths(given: Sequence[Path]) -> list[Path]:
    """The checkpoints; a folder of rna-train stands for the checkpoints of all its parts.

    Raises `ExportError` for a folder without any.
    """
    paths: list[Path] = []
    for path in given:
        if not path.is_dir():
            paths.append(path)
            continue
        found = [path / BEST] if (path / BEST).is_file() else sorted(path.glob(f"*/{BEST}"))
        if not found:
            raise ExportError(f"{path}: found no {BEST}, expected a folder of rna-train")
        paths += found
    return paths


def trained_tiers(trained: Sequence[Trained], dataset: Dataset) -> list[TrainedTier]:
    """A tier for each preset, in the order in which they come.

    Raises `ExportError` when a preset lacks a part or has it twice, or was trained on another
    capture.
    """
    for one in trained:
        if not one.preset.model.packageable:
            found = f"the {one.preset_name} checkpoint of {one.part} is a model to compare with"
            raise ExportError(f"{found}, expected one with planes whose decoder gives colours")
        _check_capture(one, dataset)
    presets = dict.fromkeys(one.preset_name for one in trained)
    names = [part.name for part in dataset.parts]
    return [TrainedTier(preset, _of_preset(preset, trained, names)) for preset in presets]


def _of_preset(preset: str, trained: Sequence[Trained], names: list[str]) -> tuple[Trained, ...]:
    by_part = {one.part: one for one in trained if one.preset_name == preset}
    result = [one.part for one in trained if one.preset_name == preset]
    if sorted(result) != sorted(names):
        raise ExportError(
            f"preset {preset}: found checkpoints of {', '.join(result)}; "
            f"expected one of each part: {', '.join(names)}"
        )
    return tuple(by_part[name] for name in names)


def _check_capture(one: Trained, dataset: Dataset) -> None:
    if one.cut != dataset.cut:
        raise ExportError(
            f"the {one.preset_name} checkpoint of {one.part} is of a cut in {one.cut}, expected "
            f"{dataset.cut}, as the first checkpoint"
        )
    if one.capture.source_sha256 != dataset.manifest.source_sha256:
        raise ExportError(
            f"the {one.preset_name} checkpoint was trained on {one.capture.source} "
            f"({one.capture.source_sha256[:12]}), expected the dataset's "
            f"{dataset.manifest.source} ({dataset.manifest.source_sha256[:12]})"
        )

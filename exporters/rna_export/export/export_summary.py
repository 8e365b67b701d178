"""Last lines of commands that write a package: files, error, shares of the usual work."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.validation_view import WholeView
from rna_export.capture.preflight.verdicts import preflight_lines
from rna_export.outcome.outcome import Outcome
from rna_export.pictures import sheet_of, worst_of
from rna_export.training.checkpoint import Trained
from rna_export.training.training_summary import Effort
from rna_export.training.validation import reference_warnings, write_sheet
from rna_sdk.commands.error_words import albedo_text, error_text
from rna_sdk.files.file_kinds import glass_of
from rna_sdk.package import Manifest, Tier
from rna_sdk.runtime import Asset, load


def closing_lines(
    package: Path, manifest: Manifest, trained: Sequence[Trained], dataset: Dataset
) -> list[str]:
    """Error, albedo, steps and lights of each tier, warnings, and notes of the capture.

    Writes the contact sheet `sheet_of(package)`: validation images of the default tier, and what
    the pre-flight said of each material; and `worst_of(package)`, where it is furthest from Cycles.

    trained: the models of all parts and presets of the package.
    """
    views, lines = dataset.whole_views(), []
    efforts = {
        preset: Effort.of([one for one in trained if one.preset_name == preset], dataset)
        for preset in dict.fromkeys(one.preset_name for one in trained)
    }
    flips: dict[str, float | None] = {}
    for tier in manifest.tiers:
        preset = next(p for p in efforts if f"{tier.name}-".startswith(f"{p}-"))
        effort = efforts[preset]
        flips.setdefault(preset, None if tier.validation is None else tier.validation.flip)
        lines.append(f"{tier.name}: {_error_text(tier)}; {effort}")
        if tier.validation is not None and (returned := tier.validation.albedo) is not None:
            lines.append(f"{tier.name}: {albedo_text(returned.ratio, returned.at80)}")
    asset = load(package)
    shaded, notes = [_shaded(asset, view) for view in views], dataset.manifest.materials
    write_sheet(sheet_of(package), shaded, views, preflight_lines(notes))
    is_sketch = next(iter(efforts.values())).is_little
    lines += Outcome.of(shaded, views, dataset).told(worst_of(package), is_sketch=is_sketch)
    if dataset.glass is not None:
        name = glass_of(package)
        lines.append(f"{name}: the smooth glass, an ordinary mesh that a scene places with it")
    lines += reference_warnings(views)
    lines += dict.fromkeys(line for p, e in efforts.items() for line in e.warnings(flips[p]))
    return [*lines, *(f"note: {note}" for note in dataset.manifest.all_notes)]


def _error_text(tier: Tier) -> str:
    validation = tier.validation
    if validation is None or validation.flip_p95 is None:
        return "no error is recorded"
    error = error_text(validation.flip, validation.flip_p95)
    return f"{error}, PSNR {validation.psnr:.2f} dB"


def _shaded(asset: Asset, view: WholeView) -> np.ndarray:
    """Radiance of the view's rows, (n, 3)."""
    pairs = zip(view.parts, asset.parts, strict=True)
    return np.concatenate([part.shaded_by(part_asset) for part, part_asset in pairs])

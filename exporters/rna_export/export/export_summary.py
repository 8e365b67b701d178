"""Last lines of commands that write a package: what was made, how good it is, what is missing."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.validation_view import WholeView
from rna_export.capture.preflight.verdicts import preflight_lines
from rna_export.metrics import plain
from rna_export.pictures import sheet_of
from rna_export.psnr_words import psnr_text
from rna_export.training.checkpoint import Trained
from rna_export.training.training_summary import Effort
from rna_export.training.validation import (
    mean_psnr,
    mean_psnr_of_pixels,
    reference_warnings,
    write_sheet,
)
from rna_sdk.glass_beside import glass_of
from rna_sdk.package import Manifest
from rna_sdk.runtime import Asset, load


def closing_lines(
    package: Path, manifest: Manifest, trained: Sequence[Trained], dataset: Dataset
) -> list[str]:
    """Score, steps and lights of each tier, warnings, and notes of the capture.

    Writes the contact sheet `sheet_of(package)`: validation images of the default tier, and what
    the pre-flight said of each material.

    trained: the models of all parts and presets of the package.
    """
    views, lines = dataset.whole_views(), []
    strands_alone = all(part.kind == "fiber" for part in dataset.parts)
    efforts = {
        preset: Effort.of([one for one in trained if one.preset_name == preset], dataset)
        for preset in dict.fromkeys(one.preset_name for one in trained)
    }
    for tier in manifest.tiers:
        effort = next(e for p, e in efforts.items() if f"{tier.name}-".startswith(f"{p}-"))
        score = "no PSNR is recorded"
        asset = load(package, tier=tier.name)
        if tier.validation is not None:
            in_pixels = None
            if strands_alone:
                in_pixels = mean_psnr_of_pixels([_shaded(asset, view) for view in views], views)
            psnr = psnr_text(tier.validation.psnr, in_pixels)
            score = f"PSNR {psnr}, FLIP {tier.validation.flip:.4f}"
        lines.append(f"{tier.name}: {score}; {effort}")
        lines += _emission_line(tier.name, asset, dataset)
    asset = load(package)
    shaded, notes = [_shaded(asset, view) for view in views], dataset.manifest.materials
    write_sheet(sheet_of(package), shaded, views, preflight_lines(notes))
    if dataset.glass is not None:
        name = glass_of(package)
        lines.append(f"{name}: the smooth glass, an ordinary mesh that a scene places with it")
    lines += reference_warnings(views)
    lines += dict.fromkeys(line for effort in efforts.values() for line in effort.warnings)
    return [*lines, *(f"note: {note}" for note in dataset.manifest.notes)]


def _emission_line(name: str, asset: Asset, dataset: Dataset) -> list[str]:
    """PSNR of what the asset emits, over the images of each emitting part."""
    views, rows = [], []
    for part, part_asset in zip(dataset.parts, asset.parts, strict=True):
        for view in part.emission_views() if part_asset.emits else ():
            if len(view.pixel):
                views.append(view)
                rows.append(view.shaded_by(part_asset))
    if not views or plain([view.reference for view in views]) == "black":
        return []
    return [f"{name}: PSNR of emission {psnr_text(mean_psnr(rows, views))}"]


def _shaded(asset: Asset, view: WholeView) -> np.ndarray:
    """Radiance of the view's rows, (n, 3)."""
    pairs = zip(view.parts, asset.parts, strict=True)
    return np.concatenate([part.shaded_by(part_asset) for part, part_asset in pairs])

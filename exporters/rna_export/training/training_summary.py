"""Last lines of a training: how good the model is, and what it was trained with."""

from __future__ import annotations

from pathlib import Path

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.effort import Effort
from rna_export.psnr_words import told_psnr
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.report import read_curves
from rna_export.training.validation import mean_psnr_of_pixels, reference_warnings, shade


def closing_lines(best: Path, part: DatasetPart) -> list[str]:
    """Score, steps and lights of a part's best checkpoint, and warnings."""
    rows, trained = read_curves(best.parent), load_checkpoint(best)
    effort, lines = Effort.of([trained], part.dataset), []
    views = part.validation_views()
    if rows:
        row = max(rows, key=lambda row: row["psnr"])
        name, in_pixels = trained.preset_name, None
        if part.kind == "fiber":
            in_pixels = mean_psnr_of_pixels([shade(trained.model, view) for view in views], views)
        lines.append(f"{name}: PSNR {told_psnr(row['psnr'], in_pixels)}; {effort}")
        if "emission_psnr" in row:
            lines.append(f"{name}: PSNR of emission {told_psnr(row['emission_psnr'])}")
    return [*lines, *reference_warnings(views), *effort.warnings]

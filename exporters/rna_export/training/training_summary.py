"""Last lines of a training: how good the model is, and what it was trained with."""

from __future__ import annotations

from pathlib import Path

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.effort import Effort
from rna_export.psnr_words import psnr_in_words
from rna_export.told_psnr import told_psnr
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.loss_curves import read_curves
from rna_export.training.validation import reference_warnings, shade


def closing_lines(best: Path, part: DatasetPart) -> list[str]:
    """Score, steps and lights of a part's best checkpoint, and warnings."""
    rows, trained = read_curves(best.parent), load_checkpoint(best)
    effort, lines = Effort.of([trained], part.dataset), []
    views = part.validation_views()
    if rows:
        row = max(rows, key=lambda row: row["psnr"])
        name, strands = trained.preset_name, part.kind == "fiber"
        shaded = [shade(trained.model, view) for view in views] if strands else []
        lines.append(f"{name}: PSNR {told_psnr(row['psnr'], shaded, views, strands)}; {effort}")
        if "emission_psnr" in row:
            db = row["emission_psnr"]
            lines.append(f"{name}: PSNR of emission {db:.2f} dB ({psnr_in_words(db)})")
    return [*lines, *reference_warnings(views), *effort.warnings]

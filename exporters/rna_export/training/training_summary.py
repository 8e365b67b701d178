"""Last lines of a training: how good the model is, and what it was trained with."""

from __future__ import annotations

from pathlib import Path

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.effort import Effort
from rna_export.psnr_words import psnr_in_words
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.loss_curves import read_curves
from rna_export.training.validation import reference_warnings


def closing_lines(best: Path, part: DatasetPart) -> list[str]:
    """Score, steps and lights of a part's best checkpoint, and warnings."""
    rows, trained = read_curves(best.parent), load_checkpoint(best)
    effort, lines = Effort.of([trained], part.dataset), []
    if rows:
        row = max(rows, key=lambda row: row["psnr"])
        name = trained.preset_name
        lines.append(f"{name}: PSNR {_told(row['psnr'])}; {effort}")
        if "emission_psnr" in row:
            lines.append(f"{name}: PSNR of emission {_told(row['emission_psnr'])}")
    return [*lines, *reference_warnings(part.validation_views()), *effort.warnings]


def _told(db: float) -> str:
    return f"{db:.2f} dB ({psnr_in_words(db)})"

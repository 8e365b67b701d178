"""A trained model as packages of one tier each, one for each precision."""

from __future__ import annotations

from pathlib import Path

from rna_export.capture.dataset import Dataset
from rna_export.export.build import build_package
from rna_export.training.checkpoint import Trained

PRECISIONS = ("float32-float16",)
"""Of decoder and planes; the first loses next to nothing."""


def write_packages(trained: Trained, dataset: Dataset, folder: Path) -> dict[str, Path]:
    """Write `<precision>.rna` into `folder`; returns their paths by precision."""
    path = folder / f"{PRECISIONS[0]}.rna"
    build_package([trained], dataset, path, None, "NOASSERTION", lambda _: None)
    return {PRECISIONS[0]: path}

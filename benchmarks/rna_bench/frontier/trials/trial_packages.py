"""A trained model as packages of one tier each, one for each precision."""

from collections.abc import Sequence
from pathlib import Path

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.export.package_build import build_package
from rna_export.export.precision import Precision
from rna_export.training.checkpoint import Trained

TRIAL_PRECISIONS = {
    "float32-float16": Precision("float32", "float16"),
    "int8-float16": Precision("int8", "float16"),
    "int8-int8": Precision("int8", "int8"),
}
"""Name -> decoder and planes; the first loses next to nothing."""

USUAL = "float32-float16"


def write_packages(
    trained: Trained,
    dataset: DatasetPart,
    folder: Path,
    precisions: Sequence[str] = tuple(TRIAL_PRECISIONS),
) -> dict[str, Path]:
    """Write `<precision>.rna` into `folder`; returns their paths by precision.

    Error and cost are not in them: what runs beside a trial would falsify the cost.
    """
    paths = {precision: folder / f"{precision}.rna" for precision in precisions}
    for precision, path in paths.items():
        chosen = [TRIAL_PRECISIONS[precision]]
        build_package([trained], dataset.dataset, path, None, "NOASSERTION", _quiet, chosen, False)
    return paths


def _quiet(_: str) -> None:
    pass

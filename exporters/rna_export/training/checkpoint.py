"""A trained model as a file; reading never unpickles."""

import zipfile
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

import torch
from pydantic import ValidationError
from torch import Tensor

from rna_export.capture.dataset.dataset_manifest import CaptureManifest, what_is_wrong
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.presets import Preset
from rna_sdk.errors import ExportError, TrainingError
from rna_sdk.files.atomic_file import write_atomically


@dataclass(frozen=True)
class Trained:
    """A trained model and its checkpoint's record of the training."""

    model: NeuralAsset
    preset: Preset
    preset_name: str
    part: str
    cut: int
    steps: int
    seed: int
    capture: CaptureManifest
    dataset: Path


def load_checkpoint(path: Path, model_class: type[NeuralAsset] = NeuralAsset) -> Trained:
    """The model of a checkpoint of `rna-train`, on the CPU, ready to evaluate.

    model_class: of the saved model. Raises `ExportError` when the file is not such a checkpoint.
    """
    if not path.is_file():
        raise ExportError(f"{path}: no such file")
    try:
        return _trained(_saved(path), model_class)
    except Exception as error:  # whatever torch and the models make of damaged bytes
        raise ExportError(f"{path}: not a checkpoint of rna-train: {_summary(error)}") from error


def load_progress(path: Path, model_class: type[NeuralAsset] = NeuralAsset) -> dict[str, Any]:
    """The checkpoint of `rna-train` that a stopped run resumes from, as saved.

    model_class: of the saved model. Raises `TrainingError` when no run can go on from the file.
    """
    try:
        saved = _saved(path)
        _trained(saved, model_class)
        saved["progress"]["step"], saved["progress"]["fitting"], saved["progress"]["pace"]
    except Exception as error:  # as above
        raise TrainingError(
            f"{path}: not a checkpoint that rna-train can resume: {_summary(error)}; delete it to "
            "restart training, or choose another --out"
        ) from error
    return saved


def save_checkpoint(
    path: Path, model: NeuralAsset, record: dict[str, Any], progress: dict[str, Any] | None = None
) -> None:
    """Write a model with the record of its training, under a temporary name first.

    progress: what an interrupted run resumes from.
    """
    weights = {"model": model.state_dict(), "record": record}
    data = BytesIO()  # torch's own writer of files does not say why it cannot write one
    torch.save(weights if progress is None else {**weights, "progress": progress}, data)
    write_atomically(path, data.getvalue())


def _saved(path: Path) -> dict[str, Any]:
    """Contents of the file, in memory of a few times its size.

    Raises ValueError where its records are compressed, as torch saves none, or share bytes. Readers
    of ZIP files disagree on where a directory is, so torch gets a file of the records checked here.
    """
    checked = BytesIO()
    with zipfile.ZipFile(path) as archive, zipfile.ZipFile(checked, "w") as written:
        records = archive.infolist()
        if any(record.compress_type != zipfile.ZIP_STORED for record in records):
            raise ValueError("compressed records")
        if sum(record.file_size for record in records) > path.stat().st_size:
            raise ValueError("records that are larger than the file")
        for record in records:
            written.writestr(record.filename, archive.read(record))
    checked.seek(0)
    saved: dict[str, Any] = torch.load(checked, map_location="cpu", weights_only=True)
    return saved


def _trained(saved: dict[str, Any], model_class: type[NeuralAsset]) -> Trained:
    record, weights = saved["record"], saved["model"]
    for name in ("texture", "visibility_hint"):  # of trainings before 2026-11-28, all alike
        record["preset"]["model"].pop(name, None)
    preset = Preset.model_validate(record["preset"])
    bounds = torch.stack([weights["triplane.low"], weights["triplane.high"]])
    with torch.device("meta"):
        _check_weights(model_class(preset.model, bounds.to("meta")), weights)
    model = model_class(preset.model, bounds)
    model.load_state_dict(weights)
    capture = CaptureManifest.model_validate(record["capture"])
    return Trained(
        model.eval(),
        preset,
        preset_name=record["preset_name"],
        part=record["part"],
        cut=int(record["cut"]),
        steps=int(record["steps"]),
        seed=int(record["seed"]),
        capture=capture,
        dataset=Path(record["dataset"]),
    )


def _check_weights(planned: NeuralAsset, weights: dict[str, Tensor]) -> None:
    """Raises ValueError unless the file holds all that the planned model has.

    Before the model takes memory: a few bytes can ask for planes of gigabytes.
    """
    for name, value in planned.state_dict().items():
        weight = weights.get(name)
        if not isinstance(weight, Tensor) or weight.shape != value.shape:
            shape = list(weight.shape) if isinstance(weight, Tensor) else "nothing"
            raise ValueError(f"{name}: found {shape}, expected {list(value.shape)}")
        if weight.untyped_storage().nbytes() < weight.numel() * weight.element_size():
            raise ValueError(f"{name}: fewer values than its shape {list(weight.shape)}")


def _summary(error: Exception) -> str:
    """One line: torch and pydantic go on with advice that does not fit here."""
    if isinstance(error, ValidationError):
        return what_is_wrong(error)
    return f"{type(error).__name__}: {(str(error).splitlines() or [''])[0]}"

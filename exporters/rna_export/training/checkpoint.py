"""Reads a checkpoint back into a model, without unpickling anything."""

from __future__ import annotations

import pickle
from dataclasses import dataclass
from pathlib import Path

import torch

from rna_export.capture.dataset import CaptureManifest
from rna_export.training.model import NeuralAsset
from rna_export.training.presets import Preset
from rna_sdk.errors import ExportError


@dataclass(frozen=True)
class Trained:
    """A trained model and what its checkpoint says of its making."""

    model: NeuralAsset
    preset: Preset
    preset_name: str
    steps: int
    seed: int
    capture: CaptureManifest
    dataset: Path


def load_checkpoint(path: Path) -> Trained:
    """The model of a checkpoint of `rna-train`, on the CPU, ready to evaluate.

    Raises `ExportError` when the file is not such a checkpoint.
    """
    if not path.is_file():
        raise ExportError(f"{path}: no such file")
    try:
        saved = torch.load(path, map_location="cpu", weights_only=True)
        record = saved["hyper_parameters"]
        preset = Preset.model_validate(record["preset"])
        weights = {k.removeprefix("model."): v for k, v in saved["state_dict"].items()}
        bounds = torch.stack([weights["triplane.low"], weights["triplane.high"]])
        model = NeuralAsset(preset.model, bounds)
        model.load_state_dict(weights)
        capture = CaptureManifest.model_validate(record["capture"])
        made = record["preset_name"], record["steps"], record["seed"]
        dataset = Path(record["dataset"])
    except (
        KeyError,
        TypeError,
        ValueError,
        RuntimeError,
        EOFError,
        pickle.UnpicklingError,
    ) as error:
        raise ExportError(f"{path}: not a checkpoint of rna-train: {error}") from error
    return Trained(model.eval(), preset, *made, capture, dataset)

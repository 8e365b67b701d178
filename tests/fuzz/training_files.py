"""A checkpoint and a dataset for `scenes.py` to mutate, and how it checks what they became."""

import copy
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import torch

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.training.checkpoint import load_checkpoint, save_checkpoint
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.training_run import padded_bounds
from tests.exporters.synthetic import make_dataset, tiny
from tests.fuzz.mutations import change_bytes

CHECKPOINTS, MANIFESTS = "checkpoints", "dataset manifests"

_VALUES = [
    *(0, -1, 1, 2, 3, 10**9, 10**30, -(10**30), 0.5, float("nan"), float("inf"), "x", "\0", None),
    *("../../etc/passwd", [], {}, True, torch.zeros(3), torch.zeros(1, dtype=torch.int8)),
]


def write_training_files(folder: Path) -> dict[str, list[Path]]:
    """Writes the files; kind -> paths."""
    part = make_dataset(folder / "ball.rays", shards=1, views=1)
    preset = tiny()
    model = NeuralAsset(preset.model, padded_bounds(part))
    record = {
        "preset": preset.model_dump(mode="json"),
        "preset_name": "small",
        "part": "asset",
        "cut": 1,
        "steps": 10,
        "seed": 3,
        "capture": part.manifest.model_dump(mode="json", by_alias=True),
        "dataset": str(part.folder),
    }
    save_checkpoint(folder / "best.ckpt", model, record)
    return {CHECKPOINTS: [folder / "best.ckpt"], MANIFESTS: [part.folder / "manifest.json"]}


def mutate_checkpoint(path: Path, rng: np.random.Generator) -> bytes:
    """Changes a saved value, or bytes of the file, most of them near its pickle."""
    mutated, data = path.with_name("changed.ckpt"), path.read_bytes()
    if rng.integers(2):
        saved = copy.deepcopy(torch.load(path, weights_only=True))
        places = list(_places(saved))
        parent, key = places[rng.integers(len(places))]
        parent[key] = _VALUES[rng.integers(len(_VALUES))]
        torch.save(saved, mutated)
        return mutated.read_bytes()
    start = data.index(b"data.pkl")
    near = slice(start, start + 6000) if rng.random() < 0.7 else slice(0, len(data))
    return data[: near.start] + change_bytes(data[near], rng) + data[near.stop :]


def _places(value: Any) -> Iterator[tuple[Any, Any]]:
    keys = list(value) if isinstance(value, dict) else range(len(value) * isinstance(value, list))
    for key in keys:
        yield value, key
        if isinstance(value[key], dict | list):
            yield from _places(value[key])


def check_checkpoint(path: Path) -> list[tuple[str, np.ndarray]]:
    """Nothing of it has to be finite: training says what diverged."""
    load_checkpoint(path)
    return []


def check_manifest(path: Path) -> list[tuple[str, np.ndarray]]:
    """What training reads of the dataset that the manifest is of."""
    dataset = Dataset(path.parent)
    actual = []
    for part in dataset.parts:
        actual.append(("radiance", part.training_samples()["radiance"]))
        actual += [("images", view.reference) for view in part.validation_views()]
    return actual

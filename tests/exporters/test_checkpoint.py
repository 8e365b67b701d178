from __future__ import annotations

import os
from pathlib import Path

import pytest
import torch

from rna_export.capture.dataset import Dataset
from rna_export.training import run as run_module
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.run import Run, train
from rna_sdk.errors import ExportError
from tests.exporters.synthetic import make_dataset, tiny


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return make_dataset(tmp_path_factory.mktemp("data") / "ball.rays")


@pytest.fixture(scope="module")
def checkpoint(dataset: Dataset, tmp_path_factory: pytest.TempPathFactory) -> Path:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(run_module, "draw_curves", lambda _: None)
        return train(Run(dataset, tiny(steps=10), "small", tmp_path_factory.mktemp("run"), seed=3))


def test_says_all_that_is_needed_to_repeat_it(checkpoint: Path, dataset: Dataset) -> None:
    trained = load_checkpoint(checkpoint)
    assert trained.preset == tiny(steps=10, loss="log")  # a capture without noise
    assert (trained.preset_name, trained.seed, trained.steps) == ("small", 3, 10)
    assert trained.capture == dataset.manifest
    assert trained.dataset == dataset.folder.resolve()


def test_the_model_is_the_trained_one(checkpoint: Path) -> None:
    trained = load_checkpoint(checkpoint)
    saved = torch.load(checkpoint, weights_only=True)["state_dict"]
    for name, value in trained.model.state_dict().items():
        assert torch.equal(value, saved[f"model.{name}"])
    assert not trained.model.training


class Exploit:
    """Pickled, it makes a folder when it is read."""

    def __init__(self, folder: Path):
        self.folder = folder

    def __reduce__(self):
        return os.mkdir, (str(self.folder),)


def test_a_checkpoint_runs_no_code(checkpoint: Path, tmp_path: Path) -> None:
    saved = torch.load(checkpoint, weights_only=True)
    saved["hyper_parameters"]["exploit"] = Exploit(tmp_path / "made")
    torch.save(saved, tmp_path / "bad.ckpt")
    with pytest.raises(ExportError, match=r"bad\.ckpt: not a checkpoint"):
        load_checkpoint(tmp_path / "bad.ckpt")
    assert not (tmp_path / "made").exists()


@pytest.mark.parametrize(
    "damage",
    [
        lambda s: s.pop("hyper_parameters"),
        lambda s: s["hyper_parameters"].pop("seed"),
        lambda s: s["hyper_parameters"]["preset"]["model"].update(width=17),
        lambda s: s["hyper_parameters"]["preset"]["model"].update(inputs=["magic"]),
        lambda s: s["state_dict"].pop("model.decoder.0.weight"),
        lambda s: s["hyper_parameters"]["capture"].update(surprise=1),
    ],
    ids=["no record", "no seed", "another width", "unknown input", "a weight less", "manifest"],
)
def test_a_damaged_checkpoint_is_refused(checkpoint: Path, tmp_path: Path, damage) -> None:
    saved = torch.load(checkpoint, weights_only=True)
    damage(saved)
    torch.save(saved, tmp_path / "bad.ckpt")
    with pytest.raises(ExportError, match=r"bad\.ckpt"):
        load_checkpoint(tmp_path / "bad.ckpt")


@pytest.mark.parametrize("content", [b"", b"not a checkpoint", b"PK\x03\x04 half a zip"])
def test_another_file_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "x.ckpt").write_bytes(content)
    with pytest.raises(ExportError, match=r"x\.ckpt"):
        load_checkpoint(tmp_path / "x.ckpt")


def test_no_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ExportError, match="no such file"):
        load_checkpoint(tmp_path / "gone.ckpt")

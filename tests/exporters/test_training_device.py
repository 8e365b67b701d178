"""Batch, optimizer and device of a training; the error if a GPU's memory is too small."""

from typing import Any

import pytest
import torch

from rna_export.training import training_options
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.presets import BATCH, PRESETS
from rna_export.training.report import Curves
from rna_export.training.rna_train import main
from rna_export.training.training_options import device_name
from rna_export.training.training_run import Run, train
from rna_sdk.errors import RnaError, TrainingError
from tests.exporters.synthetic import tiny


@pytest.fixture(autouse=True)
def without_pictures(monkeypatch):
    monkeypatch.setattr(Curves, "draw", lambda _: None)


def test_options_of_batch_and_optimizer_are_recorded(
    dataset,
    tmp_path,
    monkeypatch,
    capsys,
):
    monkeypatch.setattr(
        "rna_export.training.rna_train.PRESETS", {"surface": {"small": tiny()}}, raising=True
    )
    argv = [str(dataset.folder), "--out", str(tmp_path / "run"), "--steps", "6", "--device", "cpu"]
    assert main([*argv, "--batch", "96", "--optimizer", "adam"]) == 0
    assert "Adam on the CPU" in capsys.readouterr().out
    training = load_checkpoint(tmp_path / "run" / "best.ckpt").preset.training
    assert (training.batch, training.optimizer) == (96, "adam")


def test_a_batch_of_nothing_is_refused(tmp_path, capsys):
    with pytest.raises(SystemExit) as ended:
        main([str(tmp_path), "--out", str(tmp_path / "run"), "--batch", "0"])
    assert ended.value.code == 2
    assert "--batch: expected a number above 0, found 0" in capsys.readouterr().err


def test_a_gpu_has_larger_batches():
    small = PRESETS["surface"]["small"]
    assert small.on_device("cuda").training.batch == BATCH["cuda"] > BATCH["cpu"]
    assert small.on_device("cpu") == small


def test_what_device_was_taken_is_told(monkeypatch):
    monkeypatch.setattr(torch.cuda, "get_device_name", lambda: "NVIDIA H100")
    assert device_name("cuda") == "the GPU (NVIDIA H100)"
    assert device_name("cpu") == "the CPU"
    for there, taken in ((True, "cuda"), (False, "cpu")):
        monkeypatch.setattr(torch.cuda, "is_available", lambda there=there: there)
        assert training_options.chosen_device("auto") == taken


def test_a_batch_beyond_the_machine_is_refused_before_a_step(dataset, tmp_path):
    run = Run(dataset, tiny(batch=10**10), "small", tmp_path / "run")
    with pytest.raises(RnaError, match=r"^--batch 10000000000: a step: takes .* GB of memory"):
        train(run)


def test_a_batch_that_does_not_fit_is_one_line(dataset, tmp_path, monkeypatch):
    def step(*_: Any) -> torch.Tensor:
        raise torch.OutOfMemoryError("CUDA out of memory. Tried to allocate ...")

    monkeypatch.setattr(Fitting, "step", step)
    run = Run(dataset, tiny(batch=256), "small", tmp_path / "run")
    with pytest.raises(TrainingError, match=r"--batch 256: .* expected a batch of about \d+ or"):
        train(run)

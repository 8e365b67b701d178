"""Whole trainings, tiny: what they leave, how they repeat, how they go on."""

import csv
import gc
import weakref
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
import torch
from PIL import Image

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.samples import SampleTable
from rna_export.training.report import Curves, error_of
from rna_export.training.rna_train import main
from rna_export.training.training_run import Run, padded_bounds, train
from rna_export.training.validation import score, shade
from rna_sdk.errors import TrainingError
from tests.exporters.synthetic import make_dataset, tiny


@pytest.fixture(scope="module")
def trained(dataset, tmp_path_factory):
    """The folder of a finished run of 40 steps."""
    return train(plan(dataset, tmp_path_factory.mktemp("run"))).parent


@pytest.fixture(autouse=True)
def without_pictures(monkeypatch):
    """Drawing takes most of so short a run; `trained` has its picture."""
    monkeypatch.setattr(Curves, "draw", lambda _: None)


def plan(dataset: DatasetPart, out: Path, steps: int = 40, seed: int = 0) -> Run:
    return Run(dataset, tiny(steps=steps), "small", out, seed)


def test_a_run_of_few_samples_smooths_its_planes_more(dataset, tmp_path):
    run = plan(dataset, tmp_path, steps=4)
    best = train(replace(run, preset=run.preset.with_training(smoothing=0.25)))
    assert load_checkpoint(best).preset.training.smoothing == 2.0


def weights(checkpoint: Path) -> dict[str, torch.Tensor]:
    return torch.load(checkpoint, weights_only=True)["model"]


def curve(folder: Path, name: str) -> dict[int, float]:
    with (folder / "metrics.csv").open(newline="") as file:
        return {int(row["step"]): float(row[name]) for row in csv.DictReader(file) if row[name]}


def test_what_a_run_leaves(trained, dataset):
    names = {"best.ckpt", "last.ckpt", "metrics.csv", "curves.png", "sheet.png", "validation"}
    assert {path.name for path in trained.iterdir()} == names
    assert (trained / "curves.png").stat().st_size > 5000
    scores = curve(trained, "psnr")
    assert list(scores) == list(range(4, 41, 4))
    assert 40 in curve(trained, "flip")
    size = dataset.manifest.settings.validation_resolution
    for view in dataset.validation_views():
        with Image.open(trained / "validation" / f"view-{view.index:02d}.png") as image:
            times = -(-128 // size)  # small pictures are enlarged
            assert image.size == (3 * times * size, times * size)


def test_a_model_is_not_chosen_for_a_little_flip_that_costs_highlights():
    """A bake of metals chose a checkpoint from before its unbiased end, with 93% of their light."""
    before, end = {"flip": 0.035, "albedo": 0.93}, {"flip": 0.041, "albedo": 1.005}
    assert error_of(end) < error_of(before) < error_of({"psnr": 60.0})
    assert error_of(end) == error_of({"flip": 0.041}) < error_of({"flip": 0.042})


def test_the_best_checkpoint_is_that_of_least_flip(trained, dataset):
    best, views = load_checkpoint(trained / "best.ckpt"), dataset.validation_views()
    flips, psnrs = curve(trained, "flip"), curve(trained, "psnr")
    scores = score([shade(best.model, view) for view in views], views)
    assert scores.psnr == pytest.approx(psnrs[min(flips, key=flips.__getitem__)], abs=1e-3)
    assert scores.images == 2


def test_a_seed_repeats_to_the_bit(dataset, trained, tmp_path):
    train(plan(dataset, tmp_path / "again"))
    train(plan(dataset, tmp_path / "other", seed=1))
    first, again, other = (
        weights(folder / "last.ckpt")
        for folder in (trained, tmp_path / "again", tmp_path / "other")
    )
    assert all(torch.equal(first[name], again[name]) for name in first)
    assert not torch.equal(first["decoder.0.weight"], other["decoder.0.weight"])


@dataclass(frozen=True)
class Continued:
    """A run that Ctrl-C stopped at step 22, and that the same call then continued."""

    folder: Path
    steps_after: int


@pytest.fixture(scope="module")
def continued(dataset, tmp_path_factory):
    folder = tmp_path_factory.mktemp("continued")
    step, done = Fitting.step, []

    def stopping(self: Fitting, rows: torch.Tensor, progress: float) -> torch.Tensor:
        if len(done) == 22:
            raise KeyboardInterrupt
        done.append(progress)
        return step(self, rows, progress)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Curves, "draw", lambda _: None)
        patch.setattr(Fitting, "step", stopping)
        with pytest.raises(KeyboardInterrupt):
            train(plan(dataset, folder))
        done.clear()
        train(plan(dataset, folder))
    return Continued(folder, len(done))


def test_a_stopped_run_goes_on(continued):
    assert continued.steps_after == 20  # the last checkpoint was at 20
    saved = torch.load(continued.folder / "last.ckpt", weights_only=True)
    assert saved["progress"]["step"] == 40


def test_curves_of_a_run_that_went_on_are_whole(continued):
    assert sorted(curve(continued.folder, "psnr")) == list(range(4, 41, 4))


def test_a_stopped_run_ends_as_if_it_had_not_been(continued, trained):
    whole, stopped = (weights(folder / "last.ckpt") for folder in (trained, continued.folder))
    assert all(torch.equal(whole[name], stopped[name]) for name in whole)


def test_a_finished_run_stays_as_it_is(dataset, tmp_path):
    folder = tmp_path / "run"
    train(plan(dataset, folder, steps=20))
    before = (folder / "best.ckpt").read_bytes(), curve(folder, "psnr")
    train(plan(dataset, folder, steps=20))
    assert ((folder / "best.ckpt").read_bytes(), curve(folder, "psnr")) == before


@pytest.mark.parametrize("change", [{"seed": 1}, {"steps": 50}], ids=str)
def test_another_run_in_the_same_folder_is_refused(dataset, trained, change):
    ((name, value),) = change.items()
    with pytest.raises(TrainingError, match=rf"{name}.* found {value}"):
        train(plan(dataset, trained, **change))


def test_another_dataset_in_the_same_folder_is_refused(trained, tmp_path):
    other = make_dataset(tmp_path / "other.rays", seed=5)
    with pytest.raises(TrainingError, match="another dataset"):
        train(plan(other, trained))


def test_a_finished_run_frees_its_samples(dataset, tmp_path, monkeypatch):
    monkeypatch.undo()  # draws: matplotlib leaves cycles
    table = SampleTable(dataset.training_samples())
    held = weakref.ref(table.rows)
    gc.collect()
    gc.disable()
    try:
        train(plan(dataset, tmp_path, steps=21), table)
        del table
        assert held() is None
    finally:
        gc.enable()


def test_the_ceiling_is_above_all_that_was_seen(trained, dataset):
    seen = float(dataset.training_samples()["radiance"].max())
    assert load_checkpoint(trained / "best.ckpt").model.ceiling.item() == pytest.approx(1.5 * seen)


def test_the_unit_is_the_median_of_what_is_lit(trained, dataset):
    samples = dataset.training_samples()
    median = float(np.median(samples["radiance"][samples["visible"] > 0]))
    assert load_checkpoint(trained / "best.ckpt").model.unit.item() == pytest.approx(median)


def test_bounds_hold_the_geometry_and_are_never_flat(dataset):
    low, high = padded_bounds(dataset)
    assert torch.all(low < -1.0) and torch.all(high > 1.0) and torch.all(high < 1.1)
    flat = dataset.captured.model_copy(update={"bounds": ((-1.0, 0.0, -2.0), (1.0, 0.0, 2.0))})
    low, high = padded_bounds(DatasetPart(dataset.dataset, flat))
    assert high[1] - low[1] >= 0.4


def test_the_command_line(dataset, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("rna_export.training.rna_train.PRESETS", {"surface": {"small": tiny()}})
    arguments = [str(dataset.folder), "--out", str(tmp_path), "--device", "cpu"]
    assert main([*arguments, "--steps", "20"]) == 0
    text = capsys.readouterr().out
    assert f"wrote {tmp_path / 'best.ckpt'}" in text and "next: rna-export" in text
    assert main([*arguments, "--steps", "20", "--seed", "4"]) == 1
    assert "error: " in capsys.readouterr().err


def test_the_loss_is_the_one_asked_for(dataset, tmp_path, monkeypatch):
    presets = {kind: {"small": tiny(kind=kind)} for kind in ("surface", "fiber")}
    monkeypatch.setattr("rna_export.training.rna_train.PRESETS", presets)
    arguments = ["--out", str(tmp_path), "--device", "cpu", "--steps", "20", "--loss", "unbiased"]
    assert main([str(dataset.folder), *arguments]) == 0
    assert load_checkpoint(tmp_path / "best.ckpt").preset.training.loss == "unbiased"


def test_fibers_have_no_loss_to_choose(tmp_path, capsys):
    hair = make_dataset(tmp_path / "hair.rays")
    fibers = hair.captured.model_copy(update={"kind": "fiber"})
    manifest = hair.manifest.model_copy(update={"parts": (fibers,)})
    (hair.folder / "manifest.json").write_text(manifest.model_dump_json(by_alias=True))
    assert main([str(hair.folder), "--out", str(tmp_path / "run"), "--loss", "log"]) == 1
    assert "--loss: expected none" in capsys.readouterr().err


@pytest.mark.parametrize("option", ["--steps 0", "--steps -5", "--minutes 0", "--minutes -1"])
def test_wrong_usage(dataset, tmp_path, option, monkeypatch):
    monkeypatch.setattr("rna_export.training.training_run.train", lambda _: tmp_path)
    with pytest.raises(SystemExit) as exit_:
        main([str(dataset.folder), "--out", str(tmp_path), *option.split()])
    assert exit_.value.code == 2


def test_shading_in_pieces_is_the_same(trained, dataset, monkeypatch):
    model = load_checkpoint(trained / "best.ckpt").model
    view = dataset.validation_views()[0]
    whole = shade(model, view)
    monkeypatch.setattr("rna_export.training.validation._ROWS", 37)
    assert np.allclose(shade(model, view), whole, atol=1e-6)


@pytest.mark.gpu
def test_cuda_trains_what_the_cpu_trains(dataset, tmp_path):
    scores = []
    for device in ("cpu", "cuda"):
        train(Run(dataset, tiny(steps=400), "small", tmp_path / device, device=device))
        scores.append(max(curve(tmp_path / device, "psnr").values()))
    assert scores[1] == pytest.approx(scores[0], abs=1.0)

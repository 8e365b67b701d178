"""A trial from training to record, and a grid of them in processes."""

import shutil
from pathlib import Path

import pytest

from rna_bench.frontier.trials import trial_run as run_module
from rna_bench.frontier.trials.grid import nrhints
from rna_bench.frontier.trials.trial import Trial
from rna_bench.frontier.trials.trial_packages import TRIAL_PRECISIONS, USUAL
from rna_bench.frontier.trials.trial_pool import TrialPool, TrialWorkers
from rna_bench.frontier.trials.trial_record import read_record
from rna_bench.frontier.trials.trial_run import run_trial
from rna_export.export.package_build import build_package
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.training_run import train
from rna_sdk.errors import TrainingError
from rna_sdk.runtime import load
from tests.exporters.synthetic import make_dataset, tiny
from tests.exporters.two_parts import hairy_ball
from tests.frontier.hurried import hurried_trials

CPU = TrialWorkers(count=1, threads=1, device="cpu")


def trial(name: str = "tiny", **training: object) -> Trial:
    return Trial(name=name, family="ours", preset=tiny(steps=12, **training))


@pytest.fixture(scope="module", autouse=True)
def hurried():
    with hurried_trials():
        yield


@pytest.fixture(scope="module")
def dataset(tmp_path_factory):
    return make_dataset(tmp_path_factory.mktemp("data") / "ball.rays")


@pytest.fixture(scope="module")
def two_parts(tmp_path_factory):
    return hairy_ball(tmp_path_factory.mktemp("two") / "two.rays")


@pytest.fixture(scope="module")
def finished(dataset, tmp_path_factory):
    folder = tmp_path_factory.mktemp("trial")
    run_trial(trial(), dataset, folder, "cpu")
    return folder


def test_record_is_what_the_exporter_says_of_the_package(finished, dataset, tmp_path):
    record = read_record(finished, trial(), dataset.manifest.source_sha256)
    assert record is not None and record.seconds > 0.0
    trained = load_checkpoint(finished / "best.ckpt")
    for name, point in record.points.items():
        path = tmp_path / "exported.rna"
        build_package(
            [trained], dataset.dataset, path, None, "CC0-1.0", print, [TRIAL_PRECISIONS[name]]
        )
        tier = load(path).tier
        assert point.scores.psnr == pytest.approx(tier.validation.psnr, abs=0.01)
        assert point.scores.flip == pytest.approx(tier.validation.flip, abs=1e-4)
        assert point.multiply_adds == tier.cost.multiply_adds
        assert point.bytes == (finished / f"{name}.rna").stat().st_size
        assert len(point.scores.views) == 2
        assert (finished / f"{name}-flip.png").is_file()
    assert record.points["int8-int8"].bytes < record.points[USUAL].bytes


@pytest.mark.parametrize("part", ["surface", "hair"])
def test_nrhints_is_trained_on_any_kind(part, two_parts, tmp_path):
    dataset = two_parts.part(part)
    whole = nrhints(dataset.kind)
    short = whole.model_copy(update={"preset": whole.preset.with_training(steps=12, batch=128)})
    record = run_trial(short, dataset, tmp_path, "cpu")
    (point,) = record.points.values()
    assert point.bytes is None and point.scores.psnr > 0.0


def test_finished_trial_is_not_trained_again(finished, dataset, monkeypatch):
    monkeypatch.setattr(run_module, "train", None)
    assert run_trial(trial(), dataset, finished, "cpu").trial == trial()


def test_training_that_ended_before_the_export_is_not_repeated(dataset, tmp_path, monkeypatch):
    with monkeypatch.context() as broken:
        broken.setattr(run_module, "write_packages", None)
        with pytest.raises(TypeError):
            run_trial(trial(), dataset, tmp_path, "cpu")
    monkeypatch.setattr(run_module, "train", None)
    assert run_trial(trial(), dataset, tmp_path, "cpu").seconds > 0.0


def test_training_that_ended_before_its_time_was_written_is_repeated(
    dataset, tmp_path, monkeypatch
):
    def stopped(path: Path, _: bytes) -> None:
        raise KeyboardInterrupt(path)

    with monkeypatch.context() as broken:
        broken.setattr(run_module, "write_atomically", stopped)
        with pytest.raises(KeyboardInterrupt):
            run_trial(trial(), dataset, tmp_path, "cpu")
    trained = []
    monkeypatch.setattr(run_module, "train", lambda *args: trained.append(1) or train(*args))
    assert 0.0 < run_trial(trial(), dataset, tmp_path, "cpu").seconds < 60.0
    assert len(trained) == 2  # nothing was left to do, then all of it


def test_finished_trial_gets_a_precision_that_is_new(finished, dataset, tmp_path, monkeypatch):
    folder = tmp_path / "copy"
    shutil.copytree(finished, folder)
    record = read_record(folder, trial(), dataset.manifest.source_sha256)
    others = {k: v for k, v in record.points.items() if k != USUAL}
    record.model_copy(update={"points": others}).write(folder)
    monkeypatch.setattr(run_module, "train", None)
    actual = run_trial(trial(), dataset, folder, "cpu")
    assert actual.points[USUAL].scores == record.points[USUAL].scores
    assert actual.seconds == record.seconds


def test_folder_of_another_model_is_refused(finished, dataset):
    with pytest.raises(TrainingError, match="another model or dataset"):
        run_trial(trial(batch=256), dataset, finished, "cpu")


def test_one_that_fails_is_named_after_the_others_are_done(dataset, tmp_path):
    good, bad = trial("good"), trial("bad", learning_rate=float("nan"))
    with (
        TrialPool(dataset.folder, CPU) as pool,
        pytest.raises(TrainingError, match=r"^bad: .*log\.txt"),
    ):
        actual = []
        for record in pool.run([(t, tmp_path / t.name) for t in (bad, good)]):
            actual.append(record.trial.name)
    assert actual == ["good"]

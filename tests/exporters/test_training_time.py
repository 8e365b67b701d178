"""`--minutes` of a training: kept whatever steps and validations take, by a clock of the test's."""

from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
import torch

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.training import training_run as run_module
from rna_export.training.checkpoint import load_checkpoint
from rna_export.training.optimization import fitting as fitting_module
from rna_export.training.optimization import pace as pace_module
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.pace import TimePace
from rna_export.training.report import Curves, Report
from rna_export.training.training_run import Run, train
from rna_sdk.errors import TrainingError
from tests.exporters.synthetic import tiny

MINUTES = 1.0


@dataclass
class Clock:
    """Seconds that pass only where the test says so, and what training did meanwhile."""

    now: float = 1000.0
    fast: float = 0.5  # seconds a step
    slow: float = 1.0  # while planes are blurred
    validation: float = 1.0
    stop_at: float = float("inf")
    progress: list[float] = field(default_factory=list)
    rates: list[float] = field(default_factory=list)
    validated_at: list[float] = field(default_factory=list)

    def __call__(self) -> float:
        return self.now


def ticking(monkeypatch: pytest.MonkeyPatch) -> Clock:
    """Training on a clock of its own: it loads for 2 s, and its steps are slow while it blurs."""
    clock = Clock()
    step, validation, set_rates = Fitting.step, Report.of, fitting_module.set_rates
    load = DatasetPart.training_samples

    def loading(self: DatasetPart) -> Any:
        clock.now += 2.0
        return load(self)

    def training_step(self: Fitting, rows: torch.Tensor, progress: float) -> torch.Tensor:
        if clock.now > clock.stop_at:
            raise KeyboardInterrupt
        clock.progress.append(progress)
        loss = step(self, rows, progress)
        clock.now += clock.slow if progress < 0.2 else clock.fast
        return loss

    def validate(self: Report, *arguments: Any, **named: Any) -> dict[str, float]:
        clock.validated_at.append(clock.now)
        clock.now += clock.validation
        return validation(self, *arguments, **named)

    def setting(optimizers: Any, factor: float) -> None:
        clock.rates.append(factor)
        set_rates(optimizers, factor)

    monkeypatch.setattr(fitting_module, "set_rates", setting)
    monkeypatch.setattr(DatasetPart, "training_samples", loading)
    monkeypatch.setattr(Fitting, "step", training_step)
    monkeypatch.setattr(Report, "of", validate)
    monkeypatch.setattr(Curves, "draw", lambda _: None)
    for module in (pace_module, run_module):
        monkeypatch.setattr(module, "monotonic", clock)
    return clock


@pytest.fixture
def clock(monkeypatch):
    return ticking(monkeypatch)


@dataclass(frozen=True)
class Finished:
    """A run that nothing stopped."""

    clock: Clock
    folder: Path


@pytest.fixture(scope="module")
def finished(dataset, tmp_path_factory):
    folder = tmp_path_factory.mktemp("finished")
    with pytest.MonkeyPatch.context() as patch:
        clock = ticking(patch)
        train(run(dataset, folder))
    return Finished(clock, folder)


def run(dataset: DatasetPart, out: Path, minutes: float = MINUTES) -> Run:
    return Run(dataset, tiny(), "small", out, minutes=minutes)


def test_the_time_is_kept(finished):
    clock = finished.clock
    assert clock.now - 1000.0 == pytest.approx(60.0 * MINUTES, abs=0.6)
    assert len(clock.validated_at) == 10
    apart = [b - a for a, b in pairwise(clock.validated_at)]
    assert apart == pytest.approx([6.0] * 9, abs=2.5)


def test_the_schedule_ends_as_it_should(finished):
    clock = finished.clock
    assert clock.progress == sorted(clock.progress) and clock.progress[-1] > 0.98
    assert clock.rates[0] == pytest.approx(1.0, rel=0.01)
    assert clock.rates[-1] < 0.003


def test_a_checkpoint_says_how_many_steps_it_took(finished):
    assert load_checkpoint(finished.folder / "last.ckpt").steps == len(finished.clock.progress)
    saved = torch.load(finished.folder / "last.ckpt", weights_only=True)
    assert saved["progress"]["step"] == len(finished.clock.progress)
    assert saved["record"]["minutes"] == MINUTES


def test_a_stopped_run_takes_the_rest_of_its_time(dataset, clock, tmp_path):
    clock.stop_at = 1000.0 + 40.0
    with pytest.raises(KeyboardInterrupt):
        train(run(dataset, tmp_path))
    saved = torch.load(tmp_path / "last.ckpt", weights_only=True)["progress"]["pace"]
    begun, clock.stop_at = clock.now, float("inf")
    clock.progress.clear()
    train(run(dataset, tmp_path))
    assert clock.now - begun == pytest.approx(60.0 * MINUTES - saved["spent"], rel=0.03)
    assert clock.progress[0] == saved["progress"]
    assert len(clock.validated_at) >= 10


def test_another_length_is_refused(finished, dataset):
    with pytest.raises(TrainingError, match=r"another length 1 minutes, found 2 minutes"):
        train(run(dataset, finished.folder, minutes=2.0))
    with pytest.raises(TrainingError, match=r"another length 1 minutes, found 40 steps"):
        train(Run(dataset, tiny(), "small", finished.folder))


def test_after_a_stall_the_rates_still_come_down(monkeypatch):
    clock = Clock(now=0.0)
    monkeypatch.setattr(pace_module, "monotonic", clock)
    pace = TimePace(100.0, 0.0)
    seen = []
    while pace.progress < 1.0:
        clock.now += 1000.0 if len(seen) == 10 else 0.5
        pace.advance()
        seen.append(pace.progress)
    assert max(b - a for a, b in pairwise(seen)) <= 0.02 + 1e-9
    assert len(seen) < 70

"""One fit: costs of the candidates, search, package and report."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import torch

from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import all_queries
from rna_export.fit.goal import Goal
from rna_export.fit.search import Candidate, search
from rna_export.training.checkpoint import Trained
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.training_run import padded_bounds
from rna_export.trials.cost import Costs, measure_costs
from rna_export.trials.trial import Trial
from rna_export.trials.trial_packages import TRIAL_PRECISIONS, write_packages
from rna_export.trials.trial_pool import TrialPool, TrialWorkers
from rna_export.trials.trial_record import Record
from rna_sdk.atomic_file import write_atomically
from rna_sdk.errors import TrainingError

_COSTS = "costs.json"


@dataclass
class Fit:
    """Result of a fit."""

    goal: Goal
    steps: int
    costs: Costs
    candidates: list[Candidate]
    chosen: Candidate
    seconds: float  # of all trainings together, as `Record.seconds`
    checkpoint: Path  # of the one that was chosen


def fit(
    dataset: DatasetPart,
    trials: list[Trial],
    goal: Goal,
    steps: int,
    workers: TrialWorkers,
    work: Path,
    say: Callable[[str], None],
) -> Fit:
    """Find the trial, at a precision, that meets the goal, and train it for `steps`.

    Trainings stay in `work`, so that a fit that was stopped goes on, and so that another limit
    costs little more. Raises `TrainingError` when no trial meets the goal.
    """
    candidates, costs = _with_costs(dataset, trials, work, say)
    records: dict[Path, Record] = {}
    with TrialPool(dataset.folder, workers, say) as pool:

        def train(wanted: list[Candidate], rung: int) -> None:
            folders = {c.trial.name: work / str(rung) / c.trial.name for c in wanted}
            todo = [
                (c.trial.of_length(rung), folders[c.trial.name])
                for c in {c.trial.name: c for c in wanted}.values()
                if rung not in c.scores
            ]
            for record in pool.run(todo):
                records[folders[record.trial.name]] = record
                say(_told(record, rung))
                for candidate in candidates:
                    if candidate.trial.name == record.trial.name:
                        candidate.scores[rung] = record.points[candidate.precision].scores

        chosen = search(candidates, goal, steps, train, workers.backend().width())
    checkpoint = work / str(steps) / chosen.trial.name / "best.ckpt"
    seconds = sum(record.seconds for record in records.values())
    return Fit(goal, steps, costs, candidates, chosen, seconds, checkpoint)


def is_work_folder(folder: Path) -> bool:
    """Whether a fit has begun there."""
    return (folder / _COSTS).is_file()


def _with_costs(
    dataset: DatasetPart, trials: list[Trial], work: Path, say: Callable[[str], None]
) -> tuple[list[Candidate], Costs]:
    """Every trial at every precision, with the cost of its shape: weights do not change it."""
    named = {
        f"{t.name}/{precision}": (t, precision) for t in trials for precision in TRIAL_PRECISIONS
    }
    path = work / _COSTS
    costs = _read_costs(path) if path.is_file() else None
    if costs is None or set(costs.of) != set(named):
        say(f"timing {len(trials)} models with random weights")
        costs = _measured(dataset, trials)
        work.mkdir(parents=True, exist_ok=True)
        write_atomically(path, (costs.model_dump_json(indent=1) + "\n").encode())
    candidates = [Candidate(*named[label], cost.ns) for label, cost in costs.of.items()]
    return sorted(candidates, key=lambda c: c.ns), costs


def _read_costs(path: Path) -> Costs:
    try:
        return Costs.model_validate_json(path.read_bytes())
    except ValueError as error:
        raise TrainingError(f"{path}: not the costs of rna-fit: {error}; delete it") from error


def _measured(dataset: DatasetPart, trials: list[Trial]) -> Costs:
    with tempfile.TemporaryDirectory(prefix="rna-fit-") as scratch:
        packages = {}
        for trial in trials:
            folder = Path(scratch) / trial.name
            folder.mkdir()
            for precision, path in write_packages(_random(trial, dataset), dataset, folder).items():
                packages[f"{trial.name}/{precision}"] = path
        return measure_costs(packages, all_queries(dataset.validation_views()))


def _random(trial: Trial, dataset: DatasetPart) -> Trained:
    torch.manual_seed(trial.seed)
    model = NeuralAsset(trial.preset.model, padded_bounds(dataset)).eval()
    made = trial.preset, trial.name, dataset.name, 1, 0, trial.seed
    return Trained(model, *made, dataset.manifest, dataset.folder)


def _told(record: Record, steps: int) -> str:
    scores = next(iter(record.points.values())).scores
    return (
        f"{record.trial.name}, {steps:,} steps: PSNR {scores.psnr:.2f} dB, "
        f"FLIP {scores.flip:.4f}, {record.seconds:.0f} s of training"
    )

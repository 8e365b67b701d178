"""The parts of a frontier's work, in the order in which they need each other."""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

from rna_export.capture.dataset import Dataset
from rna_export.trials.grid import FULL_STEPS, SHORT_STEPS, full_grid, short_grid
from rna_export.trials.pool import Crew, TrialPool, largest_first
from rna_export.trials.record import Record, read_record
from rna_export.trials.trial import Trial
from rna_sdk.errors import TrainingError
from tqdm import tqdm


@dataclass(frozen=True)
class Study:
    """A grid of models on one dataset, in one folder."""

    dataset: Dataset
    trials: list[Trial]
    chosen: list[Trial]  # to train now
    out: Path
    crew: Crew

    @classmethod
    def of(cls, args: argparse.Namespace) -> Study:
        """As the options say. Raises `TrainingError` for names that are not in the grid."""
        dataset = Dataset(args.dataset)
        grid, usual = (short_grid, SHORT_STEPS) if args.short else (full_grid, FULL_STEPS)
        trials = grid(dataset.manifest.kind, args.steps or usual)
        crew = Crew.usual(_device(args.device), args.workers)
        return cls(dataset, trials, _chosen(trials, args.trials), args.out, crew)

    def folder(self, trial: Trial) -> Path:
        """Of a trial's checkpoint, packages and record."""
        return self.out / "trials" / trial.name

    def records(self) -> list[Record]:
        """Of the finished trials, in the grid's order."""
        source = self.dataset.manifest.source_sha256
        found = [read_record(self.folder(trial), trial, source) for trial in self.trials]
        return [record for record in found if record is not None]

    def train(self) -> None:
        """Train, export and score every model that is not finished."""
        done = {record.trial.name for record in self.records()}
        todo = [t for t in largest_first(self.chosen) if t.name not in done]
        with (
            tqdm(total=len(self.chosen), initial=len(self.chosen) - len(todo), unit="model") as bar,
            TrialPool(self.dataset.folder, self.crew) as pool,
        ):
            for record in pool.run([(trial, self.folder(trial)) for trial in todo]):
                scores = next(iter(record.points.values())).scores
                bar.update()
                bar.write(
                    f"{record.trial.name}: PSNR {scores.psnr:.2f} dB, FLIP {scores.flip:.4f}, "
                    f"{record.seconds:.0f} s of training"
                )


def _device(asked: str) -> str:
    import torch

    cuda = torch.cuda.is_available()
    if asked == "cuda" and not cuda:
        raise TrainingError("--device cuda: torch finds no CUDA device here")
    return "cuda" if cuda and asked != "cpu" else "cpu"


def _chosen(trials: list[Trial], names: list[str] | None) -> list[Trial]:
    unknown = set(names or ()) - {trial.name for trial in trials}
    if unknown:
        raise TrainingError(
            f"--trials: found {', '.join(sorted(unknown))}; expected of "
            + ", ".join(trial.name for trial in trials)
        )
    return [trial for trial in trials if names is None or trial.name in names]

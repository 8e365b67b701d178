"""The parts of a frontier's work, in the order in which they need each other."""

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from pydantic import BaseModel

from rna_bench.frontier.chart_points import label_of, points_of
from rna_bench.frontier.cycles_curve import CyclesCurve, render_curve
from rna_bench.frontier.findings import findings, sentences
from rna_bench.frontier.frontier_chart import draw
from rna_bench.frontier.tables_sheet import draw_sheet
from rna_bench.frontier.trials.cost import Costs, measure_costs
from rna_bench.frontier.trials.grid import FULL_STEPS, SHORT_STEPS, full_grid, short_grid
from rna_bench.frontier.trials.trial import Trial
from rna_bench.frontier.trials.trial_pool import TrialPool, TrialWorkers, largest_first
from rna_bench.frontier.trials.trial_record import Record, read_record
from rna_bench.frontier.trials.trial_run import missing_precisions
from rna_bench.results import write_results
from rna_export.asset_flip import DEFINITION
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import all_queries
from rna_export.metrics import P99_DEFINITION, PSNR_DEFINITION
from rna_sdk.errors import TrainingError
from rna_sdk.files.atomic_file import write_atomically
from rna_work.executors import Executor
from rna_work.progress import Progress

Model = TypeVar("Model", bound=BaseModel)

_CYCLES_SECONDS = 60.0


@dataclass(frozen=True)
class Study:
    """A grid of models on one dataset, in one folder."""

    dataset: DatasetPart
    trials: list[Trial]
    chosen: list[Trial]  # to train now
    out: Path
    workers: TrialWorkers
    stamp: dict[str, Any]

    @classmethod
    def of(cls, args: argparse.Namespace, executor: Executor) -> "Study":
        """The study that the options describe.

        Raises `TrainingError` for names that are not in the grid.
        """
        dataset = Dataset(args.dataset).only
        grid, usual = (short_grid, SHORT_STEPS) if args.short else (full_grid, FULL_STEPS)
        trials = grid(dataset.kind, args.steps or usual)
        workers = TrialWorkers.usual(args.device, args.workers, executor, dataset.folder)
        return cls(dataset, trials, _chosen(trials, args.trials), args.out, workers, args.stamp)

    def folder(self, trial: Trial) -> Path:
        """Folder of a trial's checkpoint, packages and record."""
        return self.out / "trials" / trial.name

    def records(self) -> list[Record]:
        """Records of the finished trials, in the grid's order."""
        source = self.dataset.manifest.source_sha256
        result = [read_record(self.folder(trial), trial, source) for trial in self.trials]
        return [record for record in result if record is not None]

    def train(self) -> None:
        """Train, export and score every model that is not finished."""
        done = {r.trial.name for r in self.records() if not missing_precisions(r)}
        todo = [t for t in largest_first(self.chosen) if t.name not in done]
        if not todo:
            return
        with (
            Progress(
                len(self.chosen), "model", "training", len(self.chosen) - len(todo)
            ) as progress,
            TrialPool(self.dataset.folder, self.workers, progress.tell) as pool,
        ):
            for record in pool.run([(trial, self.folder(trial)) for trial in todo]):
                scores = next(iter(record.points.values())).scores
                progress.advance(pool.nodes())
                progress.tell(
                    f"{record.trial.name}: PSNR {scores.psnr:.2f} dB, FLIP {scores.flip:.4f}, "
                    f"{record.seconds:.0f} s of training"
                )

    def time(self, again: bool) -> None:
        """Measure the cost of every package, all in one run.

        again: even if that is done, and no package is new.
        """
        packages = {
            label_of(record.trial.name, precision): self.package(record.trial, precision)
            for record in self.records()
            for precision, point in record.points.items()
            if point.bytes is not None
        }
        if not packages:
            raise TrainingError(f"{self.out}: no finished model to time")
        earlier = _read(self.out / "costs.json", Costs)
        if earlier and set(earlier.of) == set(packages) and not again:
            return
        print(f"timing {len(packages)} packages; anything else that runs now falsifies it")
        costs = measure_costs(packages, all_queries(self.dataset.validation_views()))
        write_atomically(self.out / "costs.json", costs.model_dump_json(indent=1).encode())

    def package(self, trial: Trial, precision: str) -> Path:
        """Package of a finished trial."""
        return self.folder(trial) / f"{precision}.rna"

    def render_cycles(self, source: Path) -> None:
        """Render the validation images with Cycles, unless that is done."""
        path = self.out / "cycles.json"
        if path.is_file():
            return
        print(f"Cycles renders {source.name}, for about {_CYCLES_SECONDS:.0f} s")
        curve = render_curve(self.dataset, source, _CYCLES_SECONDS, self.out)
        write_atomically(path, (curve.model_dump_json(indent=1) + "\n").encode())

    def report(self) -> dict[str, Any]:
        """`frontier.json`. Raises `TrainingError` when no model is finished."""
        records = self.records()
        if not records:
            raise TrainingError(f"{self.out}: no finished model to chart")
        costs = _read(self.out / "costs.json", Costs)
        cycles = _read(self.out / "cycles.json", CyclesCurve)
        points = points_of(records, costs)
        exclude = {"arguments"}  # paths of one machine
        return {
            "dataset": self.dataset.manifest.model_dump(
                mode="json", by_alias=True, exclude=exclude
            ),
            "definitions": {"psnr": PSNR_DEFINITION, "flip": DEFINITION, "p99": P99_DEFINITION},
            "models_planned": len(self.trials),
            "training_device": records[0].device,
            "costs": costs.model_dump() if costs else None,
            "points": points,
            "cycles": cycles.model_dump() if cycles else None,
            "findings": findings(points),
        }

    def write(self) -> None:
        """Write `frontier.json`, `frontier.svg`, and `tables.png` of finished trials."""
        report = self.report()
        path = self.out / "frontier.json"
        write_results(path, self.stamp, report)
        draw([report], self.out / "frontier.svg")
        draw_sheet(report, self.out, self.dataset.validation_views())
        for sentence in sentences(report["findings"]):
            print(sentence)
        print(f"wrote {path}; frontier.svg and tables.png lie beside it")


def _read(path: Path, model: type[Model]) -> Model | None:
    return model.model_validate_json(path.read_bytes()) if path.is_file() else None


def _chosen(trials: list[Trial], names: list[str] | None) -> list[Trial]:
    """Selects trials by name, family or table; None selects all."""
    if names is None:
        return trials
    groups = list(dict.fromkeys(g for trial in trials for g in (trial.family, *trial.tables)))
    unknown = set(names) - set(groups) - {trial.name for trial in trials}
    if unknown:
        raise TrainingError(
            f"--trials: found {', '.join(sorted(unknown))}; expected of "
            + ", ".join([*groups, *(trial.name for trial in trials)])
        )
    return [t for t in trials if not {t.name, t.family, *t.tables}.isdisjoint(names)]

"""One trial from training to record."""

import time
from pathlib import Path

import numpy as np

from rna_bench.frontier.trials.feature_network import NetworkAsset
from rna_bench.frontier.trials.scores import judge, write_strips
from rna_bench.frontier.trials.trial import Trial
from rna_bench.frontier.trials.trial_packages import TRIAL_PRECISIONS, USUAL, write_packages
from rna_bench.frontier.trials.trial_record import Point, Record, read_record
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.validation_view import ValidationView
from rna_export.training.checkpoint import Trained, load_checkpoint, load_progress
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.nearby_choice import run_on
from rna_export.training.report import read_curves
from rna_export.training.training_run import Run, train
from rna_export.training.validation import shade
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.runtime import load

_VALIDATED_EVERY = 5_000  # steps; an interrupted trial resumes from there


def run_trial(
    trial: Trial,
    dataset: DatasetPart,
    folder: Path,
    device: str,
    samples: dict[str, np.ndarray] | None = None,
) -> Record:
    """Train, export and measure, skipping finished steps in `folder`; returns the record.

    A finished training without some of `TRIAL_PRECISIONS` gets those alone. Nearby light is counted
    as by `rna-train`. samples: the dataset's, to share between trials. Raises `TrainingError` when
    the folder belongs to another trial, `ExportError` when the model cannot be exported.
    """
    source = dataset.manifest.source_sha256
    record = read_record(folder, trial, source)
    if record is not None and not missing_precisions(record):
        return record
    folder.mkdir(parents=True, exist_ok=True)
    seconds = record.seconds if record else _finish(_run(trial, dataset, folder, device), samples)
    trained = load_checkpoint(folder / "best.ckpt", _model_class(trial))
    if trial.has_planes:
        points = dict(record.points) if record else {}
        wanted = missing_precisions(record) if record else tuple(TRIAL_PRECISIONS)
        points.update(_measure_packages(trained, dataset, folder, wanted))
    else:
        points = _measure_model(trained, dataset, folder)
    record = Record(
        trial=trial,
        dataset_sha256=source,
        device=record.device if record else device,
        seconds=seconds,
        points=points,
        curve=tuple((int(row["step"]), row["psnr"]) for row in read_curves(folder)),
        nearby=trained.model.config.nearby,
    )
    record.write(folder)
    (folder / "last.ckpt").unlink(missing_ok=True)
    return record


def missing_precisions(record: Record) -> tuple[str, ...]:
    """The TRIAL_PRECISIONS not yet measured; none for a model that cannot be packaged."""
    if not record.trial.has_planes:
        return ()
    return tuple(p for p in TRIAL_PRECISIONS if p not in record.points)


def _run(trial: Trial, dataset: DatasetPart, folder: Path, device: str) -> Run:
    return Run(
        dataset,
        trial.preset,
        trial.name,
        folder,
        trial.seed,
        device=device,
        validations=max(1, trial.preset.training.steps // _VALIDATED_EVERY),
        model_class=_model_class(trial),
    )


def _model_class(trial: Trial) -> type[NeuralAsset]:
    return NeuralAsset if trial.has_planes else NetworkAsset


def _finish(run: Run, samples: dict[str, np.ndarray] | None) -> float:
    """Train to the end; returns the seconds of all calls, stopped ones included."""
    finished = run.out / "seconds.txt"
    if finished.is_file():
        return float(finished.read_text())
    before = steps_done(run.out, run.model_class)
    chosen, table = run_on(run, "auto", samples or run.dataset.training_samples())
    clock = time.perf_counter if run.device == "cuda" else time.process_time
    start = clock()
    train(chosen, table)
    total = steps_done(run.out, run.model_class)
    if total == before:
        # It was stopped between its last step and the file that says how long it took.
        (run.out / "last.ckpt").unlink()
        return _finish(run, samples)
    seconds = (clock() - start) * total / (total - before)
    write_atomically(finished, f"{seconds:.1f}\n".encode())
    return seconds


def steps_done(folder: Path, model_class: type[NeuralAsset] = NeuralAsset) -> int:
    """Steps done by a training, finished or stopped; 0 if there is none."""
    path = folder / "last.ckpt"
    if not path.is_file():
        return 0
    return int(load_progress(path, model_class)["progress"]["step"])


def _measure_packages(
    trained: Trained, dataset: DatasetPart, folder: Path, precisions: tuple[str, ...]
) -> dict[str, Point]:
    """Error of a package of each precision, through the runtime."""
    views, points = dataset.validation_views(), {}
    for precision, path in write_packages(trained, dataset, folder, precisions).items():
        (asset,) = load(path, threads=1).parts
        radiance = [view.shaded_by(asset) for view in views]
        size = path.stat().st_size
        points[precision] = _point(trained, radiance, views, folder / precision, size)
    return points


def _measure_model(trained: Trained, dataset: DatasetPart, folder: Path) -> dict[str, Point]:
    """Error of a model that no package holds, in PyTorch."""
    views = dataset.validation_views()
    radiance = [shade(trained.model, view) for view in views]
    return {USUAL: _point(trained, radiance, views, folder / USUAL, None)}


def _point(
    trained: Trained,
    radiance: list[np.ndarray],
    views: list[ValidationView],
    pictures: Path,
    size: int | None,
) -> Point:
    scores, flips = judge(radiance, views)
    write_strips(pictures, radiance, views, flips)
    return Point(bytes=size, multiply_adds=trained.model.multiply_adds, scores=scores)

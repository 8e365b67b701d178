"""Runs a training: length of the run, checkpoints, curves; goes on where it was stopped."""

from __future__ import annotations

import csv
import shutil
import warnings
from dataclasses import dataclass, replace
from pathlib import Path
from time import monotonic
from typing import Any

import lightning
import torch
from lightning.pytorch.callbacks import Callback, ModelCheckpoint, TQDMProgressBar
from lightning.pytorch.callbacks.progress.tqdm_progress import Tqdm
from lightning.pytorch.loggers import CSVLogger
from torch.utils.data import DataLoader

from rna_export.capture.dataset_part import DatasetPart
from rna_export.capture.validation_view import EmissionView
from rna_export.training.checkpoint import load_progress
from rna_export.training.curves import draw_curves
from rna_export.training.emission import INPUTS
from rna_export.training.emission_batches import EmissionBatches
from rna_export.training.lightning_module import NeuralAssetTraining
from rna_export.training.noise import with_fitting_loss
from rna_export.training.pace import Pace, StepPace, TimePace, length, resumed
from rna_export.training.presets import Preset
from rna_export.training.samples import SampleTable
from rna_export.training.timekeeper import NEVER, Timekeeper
from rna_sdk.errors import TrainingError


@dataclass(frozen=True)
class Run:
    """One training, as asked for."""

    dataset: DatasetPart
    preset: Preset
    preset_name: str
    out: Path
    seed: int = 0
    minutes: float | None = None  # by the clock; replaces the preset's steps
    begun: float | None = None  # when the minutes began, of `time.monotonic`; None: with `train`
    device: str = "cpu"
    validations: int = 10  # over the run; the best checkpoint is one of as many


def train(run: Run, table: SampleTable | None = None) -> Path:
    """Train to the end; returns the best checkpoint, `best.ckpt`.

    `<out>/last.ckpt` of an earlier, stopped call is continued. table: the dataset's samples on the
    run's device, for callers that train on them several times. Raises `TrainingError` when the
    checkpoint belongs to another run.
    """
    begun = monotonic() if run.begun is None else run.begun
    bounds = padded_bounds(run.dataset)
    if table is None:
        table = SampleTable(run.dataset.training_samples(), device=run.device)
    # Nothing brighter than the training data: a network asked beyond it may answer anything.
    ceiling = 1.5 * table.largest_radiance
    unit = table.usual_radiance if run.preset.training.unit == "usual" else 1.0
    run = replace(run, preset=with_fitting_loss(run.preset, run.dataset, unit))
    if run.dataset.manifest.emitters:
        inputs = INPUTS[run.dataset.kind]
        run = replace(run, preset=run.preset.with_model(emission_inputs=inputs))
    last = run.out / "last.ckpt"
    saved = _continued(last, run)
    done = int(saved["global_step"]) if saved else 0
    table = table.shuffled(run.preset.training.batch, run.seed, done)
    pace = _pace(run, begun, saved)
    print(_plan(run, len(table), pace))
    torch.manual_seed(run.seed)
    module = NeuralAssetTraining(
        run.preset,
        bounds,
        ceiling,
        unit,
        pace,
        table.fields,
        run.dataset.validation_views(),
        run.out,
        _record(run, pace),
        *_of_emission(run, done),
    )
    checkpoints = ModelCheckpoint(
        run.out, "{step}-{psnr:.2f}", monitor="psnr", mode="max", save_top_k=3, save_last=True
    )
    trainer = _trainer(run, pace, done, checkpoints, _earlier_curves(run.out, done))
    loader = DataLoader(table, batch_size=None)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", module="lightning|torch")
        try:
            trainer.fit(
                module,
                loader,
                DataLoader([0]),
                ckpt_path=last if saved else None,
                weights_only=True,
            )
        except SystemExit:  # how Lightning ends a fit that Ctrl-C stopped
            raise KeyboardInterrupt from None
    unfinished, best = run.out / "best.ckpt.part", run.out / "best.ckpt"
    shutil.copyfile(checkpoints.best_model_path, unfinished)
    return unfinished.replace(best)


def _of_emission(run: Run, done: int) -> tuple[EmissionBatches | None, list[EmissionView]]:
    """What a model of emission is trained on and compared with."""
    if not run.preset.model.emission_inputs:
        return None, []
    batch = run.preset.training.batch
    batches = EmissionBatches.of(run.dataset, batch, run.seed, run.device, done)
    return batches, run.dataset.emission_views()


def padded_bounds(dataset: DatasetPart) -> torch.Tensor:
    """The triplane's box (2, 3): the geometry's, a little larger, no side thinner than a tenth."""
    low, high = torch.tensor(dataset.bounds, dtype=torch.float32)
    centre, half = (low + high) / 2, (high - low) / 2
    half = torch.maximum(1.01 * half, 0.1 * half.max())
    return torch.stack([centre - half, centre + half])


class _Bar(TQDMProgressBar):
    """One bar for the run, as long as it will be; the short validations show none."""

    def __init__(self, pace: Pace):
        super().__init__(refresh_rate=20)
        self._pace = pace

    def on_train_batch_end(
        self, trainer: lightning.Trainer, module: Any, outputs: Any, batch: Any, index: int
    ) -> None:
        progress = self._pace.progress(trainer.global_step)
        if isinstance(self._pace, TimePace) and progress > 0.0:
            self.train_progress_bar.total = round((index + 1) / progress)
        super().on_train_batch_end(trainer, module, outputs, batch, index)

    def init_validation_tqdm(self) -> Any:
        return Tqdm(disable=True)


def _trainer(
    run: Run,
    pace: Pace,
    done: int,
    checkpoints: ModelCheckpoint,
    earlier: list[dict[str, float]],
) -> lightning.Trainer:
    logger = CSVLogger(run.out, name="", version="", flush_logs_every_n_steps=500)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Experiment logs directory")
        logger.experiment.metrics = earlier  # it begins by deleting the file of the stopped run

    class Curves(Callback):
        def on_validation_end(self, trainer: lightning.Trainer, _: Any) -> None:
            if not trainer.sanity_checking:
                trainer.logger.save()
                draw_curves(run.out)

    callbacks = [checkpoints, _Bar(pace), Curves()]
    if isinstance(pace, TimePace):
        callbacks.insert(0, Timekeeper(pace, run.validations))
        steps = done if pace.progress(done) >= 1.0 else -1
        interval = NEVER
    else:
        steps, interval = pace.steps, max(1, pace.steps // run.validations)
    return lightning.Trainer(
        accelerator=run.device if run.device == "cpu" else "gpu",
        devices=1,
        max_epochs=-1,
        max_steps=steps,
        val_check_interval=interval,
        check_val_every_n_epoch=None,
        num_sanity_val_steps=0,
        callbacks=callbacks,
        logger=logger,
        log_every_n_steps=20,
        enable_model_summary=False,
    )


def _pace(run: Run, begun: float, saved: dict[str, Any] | None) -> Pace:
    """Of the run, or of what is left of it."""
    if run.minutes is not None:
        return resumed(run.minutes, begun, saved)
    if saved is not None:
        return StepPace(int(saved["hyper_parameters"]["steps"]))
    return StepPace(run.validations * -(-run.preset.training.steps // run.validations))


def _record(run: Run, pace: Pace) -> dict[str, Any]:
    """What a checkpoint says of its run: enough to repeat it."""
    return {
        "preset_name": run.preset_name,
        "seed": run.seed,
        "steps": pace.steps if isinstance(pace, StepPace) else None,
        "minutes": run.minutes,
        "part": run.dataset.name,
        "cut": run.dataset.dataset.cut,
        "dataset": str(run.dataset.folder.resolve()),
        "capture": run.dataset.manifest.model_dump(mode="json", by_alias=True),
    }


def _continued(last: Path, run: Run) -> dict[str, Any] | None:
    """The checkpoint to go on from, if there is one; `TrainingError` when it is of another run."""
    if not last.is_file():
        return None
    saved = load_progress(last)
    begun, preset = saved["hyper_parameters"], run.preset.model_dump(mode="json")
    begun_preset = Preset.model_validate(begun["preset"]).model_dump(mode="json")
    capture = run.dataset.manifest.model_dump(mode="json", by_alias=True)
    for what, before, now in (
        ("preset", begun["preset_name"], run.preset_name),
        ("seed", begun["seed"], run.seed),
        ("part", begun["part"], run.dataset.name),
        ("cut", begun["cut"], run.dataset.dataset.cut),
        (
            "length",
            length(begun.get("minutes"), begun["preset"]["training"]["steps"]),
            length(run.minutes, run.preset.training.steps),
        ),
        ("model or training", begun_preset, preset),
        ("dataset", begun["capture"], capture),
    ):
        if before != now:
            told = f" {before}, found {now}" if isinstance(now, str | int) else ""
            raise TrainingError(
                f"{last} belongs to a run with another {what}{told}: choose another --out"
            )
    return saved


def _earlier_curves(folder: Path, done: int) -> list[dict[str, float]]:
    """Rows of `metrics.csv` from before the checkpoint; later ones come again."""
    path = folder / "metrics.csv"
    if not path.is_file():
        return []
    try:
        with path.open(newline="") as file:
            rows = [{k: float(v) for k, v in row.items() if v} for row in csv.DictReader(file)]
        return [{**row, "step": int(row["step"])} for row in rows if row["step"] < done]
    except (KeyError, TypeError, ValueError) as error:
        raise TrainingError(f"{path}: not the curves of rna-train: {error!r}") from error


def _plan(run: Run, samples: int, pace: Pace) -> str:
    model, training = run.preset.model, run.preset.training
    loss = (
        "losses of direct and scattered light"
        if model.separates_direct
        else f"{training.loss} loss"
    )
    return (
        f"{run.preset_name}: {model.hidden_layers} x {model.width}, planes 3 x "
        f"{model.resolution}^2 x {model.channels}, inputs {', '.join(model.inputs)}\n"
        f"{samples / 1e6:.2f} M samples, {_length(run, samples, pace)}, {loss}"
    )


def _length(run: Run, samples: int, pace: Pace) -> str:
    batch = run.preset.training.batch
    if isinstance(pace, TimePace):
        return f"{run.minutes:g} minutes of steps of {batch:,}"
    return f"{pace.steps:,} steps of {batch:,} = {pace.steps * batch / samples:.1f} epochs"

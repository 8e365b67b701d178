"""Runs a training: length, checkpoints, curves, resume."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from time import monotonic
from typing import Any

import numpy as np
import torch
from tqdm import tqdm

from rna_export.brightness import Brightness
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.nearby_rows import with_nearby_light
from rna_export.training.checkpoint import load_checkpoint, load_progress, save_checkpoint
from rna_export.training.model.emission import INPUTS
from rna_export.training.model.neural_asset import NeuralAsset
from rna_export.training.optimization import emission_batches
from rna_export.training.optimization.emission_batches import EmissionBatches
from rna_export.training.optimization.fitting import Fitting
from rna_export.training.optimization.losses import with_fitting_loss
from rna_export.training.optimization.pace import Pace, StepPace, TimePace, length
from rna_export.training.optimization.samples import SampleTable
from rna_export.training.optimization.step_threads import StepThreads
from rna_export.training.presets import Preset
from rna_export.training.report import Curves, Report, error_of
from rna_export.training.training_options import device_name
from rna_sdk.errors import TrainingError
from rna_sdk.machine.memory import check_memory
from rna_work.bar import Bar

_SO_FAR = "best-so-far.ckpt"  # until the run is finished
_ROUNDING = 1e-9
_OPTIMIZERS = {"adam": "Adam", "muon": "Muon and Adam"}


@dataclass(frozen=True)
class Run:
    """The options of one training."""

    dataset: DatasetPart
    preset: Preset
    preset_name: str
    out: Path
    seed: int = 0
    minutes: float | None = None  # by the clock; replaces the preset's steps
    begun: float | None = None  # when the minutes began, of `time.monotonic`; None: with `train`
    device: str = "cpu"
    validations: int = 10  # over the run; the best checkpoint is one of as many
    after_checkpoint: Callable[[], None] = lambda: None
    start: Path | None = None  # checkpoint with the first weights; None: random ones
    model_class: type[NeuralAsset] = NeuralAsset


def train(
    run: Run,
    table: SampleTable | None = None,
    say: Callable[[str], None] = print,
    bars: Callable[..., tqdm] = Bar,
) -> Path:
    """Train to the end; returns the best checkpoint, `best.ckpt`.

    `<out>/last.ckpt` of an earlier, stopped call is continued. table: the samples to train on, of
    `table_of` or with all fields; None: all of the dataset's. bars: makes the progress bar. Raises
    `TrainingError` when the checkpoint belongs to another run, or the model diverges; `RnaError`
    where a step takes more memory than the machine has.
    """
    begun = monotonic() if run.begun is None else run.begun
    if table is None:
        table = table_of(run, run.dataset.training_samples())
    # Nothing brighter than the training data: a network extrapolates arbitrarily beyond it.
    ceiling = 1.5 * table.largest_radiance
    # Radiance that the loss calls 1.
    unit = table.usual_radiance if run.preset.training.unit == "usual" else 1.0
    run = replace(run, preset=with_fitting_loss(run.preset, run.dataset, unit))
    if run.dataset.manifest.emitters:
        inputs = INPUTS[run.dataset.kind]
        run = replace(run, preset=run.preset.with_model(emission_inputs=inputs))
    run = replace(run, preset=_for_base_color(run).for_rows(len(table)))
    run.out.mkdir(parents=True, exist_ok=True)
    saved = _continued(run.out / "last.ckpt", run)
    done = saved["step"] if saved else 0
    table = table.shuffled(run.preset.training.batch, run.seed, done)
    say(_plan(run, len(table)))
    torch.manual_seed(run.seed)
    bounds, emission = padded_bounds(run.dataset), _emission(run, done)
    fitting = Fitting(
        run.preset,
        bounds,
        ceiling,
        unit,
        fields=table.fields,
        emission=emission,
        device=run.device,
        model_class=run.model_class,
        lit=table.lit,
    )
    if saved:
        fitting.load(saved["fitting"])
    elif run.preset.model.nearby:
        fitting.model.nearby_means.copy_(table.nearby_means)
    if not saved and run.start is not None:
        fitting.start_from(load_checkpoint(run.start, run.model_class).model)
    best, so_far = run.out / "best.ckpt", run.out / _SO_FAR
    pace = _pace(run, begun, saved)
    batch = run.preset.training.batch
    if run.device == "cpu":
        check_memory(int(batch * _bytes_a_sample(fitting.model)), f"--batch {batch}: a step")
    batches = batch, batch // emission_batches.SHARE
    with (
        bars(initial=done, total=run.preset.training.steps, unit="step", mininterval=0.5) as bar,
        StepThreads.of(fitting, batches) as threads,
    ):
        with _memory_reported(run, fitting.model):
            result = _fit(run, fitting, table, pace, done, bar, threads)
    if result is not None:
        say(str(result))
    if so_far.is_file():
        so_far.replace(best)
    if not best.is_file():
        raise TrainingError(f"{best}: the run is finished, and this file is gone; delete {run.out}")
    return best


def table_of(
    run: Run, samples: dict[str, np.ndarray], bars: Callable[..., tqdm] = Bar
) -> SampleTable:
    """These samples of the run's dataset, with the fields that its model reads, on its device."""
    if not _for_base_color(run).model.uses_base_color:
        samples = {name: values for name, values in samples.items() if name != "base_color"}
    if lengths := run.preset.model.nearby:
        samples = with_nearby_light(samples, run.dataset, lengths, bars)
    return SampleTable(samples, device=run.device)


def _for_base_color(run: Run) -> Preset:
    """The run's preset for the base colour that was captured."""
    if not (records := run.dataset.captured.base_color):
        return run.preset
    return run.preset.with_base_color(any(record.image is not None for record in records))


@contextmanager
def _memory_reported(run: Run, model: NeuralAsset) -> Iterator[None]:
    """Raises TrainingError where the GPU's memory is too small; names a batch that fits."""
    free = torch.cuda.mem_get_info()[0] if run.device == "cuda" else 0
    try:
        yield
    except torch.OutOfMemoryError:
        batch, fits = run.preset.training.batch, int(free / _bytes_a_sample(model))
        most = 2 ** max(0, min(fits, batch // 2).bit_length() - 1)
        raise TrainingError(
            f"--batch {batch}: a step needs more than the GPU's {free / 1e9:.1f} GB of free "
            f"memory, expected a batch of about {most} or less"
        ) from None


def _bytes_a_sample(model: NeuralAsset) -> float:
    """Memory of a sample in a step, about: values and gradients of texels and layers."""
    layers = [m for m in model.modules() if isinstance(m, torch.nn.Linear)]
    numbers = sum(m.in_features + 2 * m.out_features for m in layers)
    return 4.0 * (2 * numbers + 4 * 12 * model.config.channels)


def _fit(
    run: Run,
    fitting: Fitting,
    table: SampleTable,
    pace: Pace,
    done: int,
    bar: tqdm,
    threads: StepThreads,
) -> Brightness | None:
    """All steps after the first `done`, with validations at equal parts of the run.

    Returns the brightness that the last of them found.
    """
    curves, report = Curves(run.out, done), Report(run.dataset, run.out)
    batches, losses = iter(table), []
    while pace.progress < 1.0:
        validated = _validations(run, pace)
        losses.append(threads.run(partial(fitting.step, next(batches), pace.progress)))
        pace.advance()
        done += 1
        if run.minutes is not None:
            bar.total = round(done / pace.progress)
        bar.update()
        if _validations(run, pace) == validated:
            continue
        with threads.all():
            row = report.of(fitting.model, is_last=pace.progress >= 1.0)
        is_best = error_of(row) <= curves.least_error
        curves.add({"step": done, "loss": float(torch.stack(losses).mean()), **row})
        losses.clear()
        if "flip" in row:
            curves.draw()
        record = _record(run, done)
        if is_best:
            save_checkpoint(run.out / _SO_FAR, fitting.model, record)
        pace.validated()
        progress = {"step": done, "fitting": fitting.state(), "pace": pace.state()}
        save_checkpoint(run.out / "last.ckpt", fitting.model, record, progress)
        run.after_checkpoint()
        bar.set_postfix(psnr=f"{row['psnr']:.2f} dB")
    return report.brightness


def _validations(run: Run, pace: Pace) -> int:
    """Number of validations due by now."""
    return int(pace.progress * run.validations + _ROUNDING)


def _emission(run: Run, done: int) -> EmissionBatches | None:
    """Batches of emission, if the model has a decoder of it."""
    if not run.preset.model.emission_inputs:
        return None
    return EmissionBatches.of(run.dataset, run.preset.training.batch, run.seed, run.device, done)


def padded_bounds(dataset: DatasetPart) -> torch.Tensor:
    """The triplane's box (2, 3): the geometry's, a little larger, no side thinner than a tenth."""
    low, high = torch.tensor(dataset.bounds, dtype=torch.float32)
    centre, half = (low + high) / 2, (high - low) / 2
    half = torch.maximum(1.01 * half, 0.1 * half.max())
    return torch.stack([centre - half, centre + half])


def _pace(run: Run, begun: float, saved: dict[str, Any] | None) -> Pace:
    """Pace of the run, or of its remainder."""
    if run.minutes is not None:
        return TimePace(60.0 * run.minutes, begun, saved["pace"] if saved else None)
    return StepPace(run.preset.training.steps, saved["step"] if saved else 0)


def _record(run: Run, done: int) -> dict[str, Any]:
    """Record of a run in its checkpoints, enough to repeat it."""
    return {
        "preset": run.preset.model_dump(mode="json"),
        "preset_name": run.preset_name,
        "seed": run.seed,
        "steps": run.preset.training.steps if run.minutes is None else done,
        "minutes": run.minutes,
        "part": run.dataset.name,
        "cut": run.dataset.dataset.cut,
        "dataset": str(run.dataset.folder.resolve()),
        "capture": run.dataset.manifest.model_dump(mode="json", by_alias=True),
    }


def _continued(last: Path, run: Run) -> dict[str, Any] | None:
    """The progress to go on from, if there is one; `TrainingError` when it is of another run."""
    if not last.is_file():
        return None
    saved = load_progress(last, run.model_class)
    begun, record = saved["record"], _record(run, saved["progress"]["step"])
    begun_preset = Preset.model_validate(begun["preset"])
    for what, before, now in (
        ("preset", begun["preset_name"], run.preset_name),
        ("seed", begun["seed"], run.seed),
        ("part", begun["part"], run.dataset.name),
        ("cut", begun["cut"], run.dataset.dataset.cut),
        (
            "length",
            length(begun["minutes"], begun["steps"]),
            length(run.minutes, run.preset.training.steps),
        ),
        ("model or training", begun_preset.model_dump(mode="json"), record["preset"]),
        ("dataset", begun["capture"], record["capture"]),
    ):
        if before != now:
            values = f" {before}, found {now}" if isinstance(now, str | int) else ""
            raise TrainingError(
                f"{last} belongs to a run with another {what}{values}: choose another --out"
            )
    progress: dict[str, Any] = saved["progress"]
    return progress


def _plan(run: Run, samples: int) -> str:
    model, training = run.preset.model, run.preset.training
    loss = (
        "losses of direct and scattered light"
        if model.separates_direct
        else f"{training.loss} loss"
    )
    return (
        f"{run.preset_name}: {model.hidden_layers} x {model.width}, planes 3 x "
        f"{model.resolution}^2 x {model.channels}, inputs {', '.join(model.inputs)}\n"
        f"{samples / 1e6:.2f} M samples, {_length(run, samples)}, {loss}, "
        f"{_OPTIMIZERS[training.optimizer]} on {device_name(run.device)}"
    )


def _length(run: Run, samples: int) -> str:
    training = run.preset.training
    if run.minutes is not None:
        return f"{run.minutes:g} minutes of steps of {training.batch:,}"
    epochs = training.steps * training.batch / samples
    return f"{training.steps:,} steps of {training.batch:,} = {epochs:.1f} epochs"

"""Runs a training: length of the run, checkpoints, curves; goes on where it was stopped."""

from __future__ import annotations

import shutil
import time
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import lightning
import torch
from lightning.pytorch.callbacks import Callback, ModelCheckpoint, TQDMProgressBar
from lightning.pytorch.loggers import CSVLogger
from torch.utils.data import DataLoader

from rna_export.capture.dataset import Dataset
from rna_export.training.curves import draw_curves
from rna_export.training.lightning_module import NeuralAssetTraining
from rna_export.training.losses import log_l2
from rna_export.training.model import NeuralAsset
from rna_export.training.presets import Preset
from rna_export.training.samples import SampleTable, columns
from rna_sdk.errors import TrainingError

_VALIDATIONS = 10  # a run


@dataclass(frozen=True)
class Run:
    """One training, as asked for."""

    dataset: Dataset
    preset: Preset
    preset_name: str
    out: Path
    seed: int = 0
    minutes: float | None = None  # replaces the preset's steps by as many as fit
    device: str = "cpu"


def train(run: Run) -> Path:
    """Train to the end; returns the best checkpoint, `best.ckpt`.

    `<out>/last.ckpt` of an earlier, stopped call is continued. Raises `TrainingError` when it
    belongs to another run.
    """
    torch.manual_seed(run.seed)
    samples = run.dataset.training_samples()
    bounds = padded_bounds(run.dataset)
    # Nothing brighter than the training data: a network asked beyond it may answer anything.
    ceiling = 1.5 * float(samples["radiance"].max())
    table = SampleTable(samples, run.preset.training.batch, run.seed, run.device)
    del samples
    last = run.out / "last.ckpt"
    steps = _continued_steps(last, run) or _steps(run, table, bounds)
    print(_plan(run, len(table), steps))
    torch.manual_seed(run.seed)
    module = NeuralAssetTraining(
        run.preset, bounds, ceiling, steps, run.dataset.validation_views(), run.out, _record(run, steps)
    )
    checkpoints = ModelCheckpoint(
        run.out, "{step}-{psnr:.2f}", monitor="psnr", mode="max", save_top_k=3, save_last=True
    )
    trainer = _trainer(run, steps, checkpoints)
    loader = DataLoader(table, batch_size=None)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", module="lightning|torch")
        trainer.fit(module, loader, DataLoader([0]), ckpt_path=last if last.is_file() else None,
                    weights_only=True)
    if trainer.interrupted:
        raise KeyboardInterrupt
    shutil.copyfile(checkpoints.best_model_path, run.out / "best.ckpt")
    draw_curves(run.out)
    return run.out / "best.ckpt"


def padded_bounds(dataset: Dataset) -> torch.Tensor:
    """The triplane's box (2, 3): the geometry's, a little larger, no side thinner than a tenth."""
    low, high = torch.tensor(dataset.manifest.bounds, dtype=torch.float32)
    centre, half = (low + high) / 2, (high - low) / 2
    half = torch.maximum(1.01 * half, 0.1 * half.max())
    return torch.stack([centre - half, centre + half])


def _trainer(run: Run, steps: int, checkpoints: ModelCheckpoint) -> lightning.Trainer:
    class Curves(Callback):
        def on_validation_end(self, trainer: lightning.Trainer, _: Any) -> None:
            if not trainer.sanity_checking:
                trainer.logger.save()
                draw_curves(run.out)

    return lightning.Trainer(
        accelerator=run.device if run.device == "cpu" else "gpu",
        devices=1,
        max_steps=steps,
        val_check_interval=max(1, steps // _VALIDATIONS),
        check_val_every_n_epoch=None,
        num_sanity_val_steps=0,
        callbacks=[checkpoints, TQDMProgressBar(refresh_rate=20), Curves()],
        logger=CSVLogger(run.out, name="", version="", flush_logs_every_n_steps=500),
        log_every_n_steps=20,
        enable_model_summary=False,
    )


def _steps(run: Run, table: SampleTable, bounds: torch.Tensor) -> int:
    if run.minutes is None:
        return run.preset.training.steps
    seconds = 0.2 * _seconds_a_step(run, table, bounds, run.preset.training.blur)
    seconds += 0.8 * _seconds_a_step(run, table, bounds, blur=1.0)
    return max(_VALIDATIONS, int(60.0 * run.minutes / seconds))


def _seconds_a_step(run: Run, table: SampleTable, bounds: torch.Tensor, blur: float) -> float:
    """Measured on a model that is thrown away."""
    model = NeuralAsset(run.preset.model, bounds).to(run.device)
    optimizer = torch.optim.Adam(model.parameters(), fused=True)
    seconds = []
    for _, rows in zip(range(8), table, strict=False):
        start = time.perf_counter()
        at = columns(rows)
        y = model(at["position"], at["normal"], at["wo"], at["wi"], blur)[:, 0]
        optimizer.zero_grad()
        loss = log_l2(y, at["radiance"])
        loss.backward()
        optimizer.step()
        loss.item()
        seconds.append(time.perf_counter() - start)
    return sorted(seconds[2:])[len(seconds[2:]) // 2]


def _record(run: Run, steps: int) -> dict[str, Any]:
    """What a checkpoint says of its run: enough to repeat it."""
    return {
        "preset_name": run.preset_name,
        "seed": run.seed,
        "steps": steps,
        "dataset": str(run.dataset.folder.resolve()),
        "capture": run.dataset.manifest.model_dump(mode="json", by_alias=True),
    }


def _continued_steps(last: Path, run: Run) -> int | None:
    if not last.is_file():
        return None
    saved = torch.load(last, map_location="cpu", weights_only=True)["hyper_parameters"]
    if saved["preset"] != run.preset.model_dump(mode="json") or saved["seed"] != run.seed:
        raise TrainingError(
            f"{last} belongs to a run of preset {saved['preset_name']!r} with seed "
            f"{saved['seed']}, found {run.preset_name!r} with seed {run.seed}: choose another --out"
        )
    return int(saved["steps"])


def _plan(run: Run, samples: int, steps: int) -> str:
    model, training = run.preset.model, run.preset.training
    return (
        f"{run.preset_name}: {model.hidden_layers} x {model.width}, planes 3 x {model.resolution}^2 x "
        f"{model.channels}, inputs {', '.join(model.inputs)}\n"
        f"{samples / 1e6:.2f} M samples, {steps:,} steps of {training.batch:,} = "
        f"{steps * training.batch / samples:.1f} epochs"
    )

"""Trainings of `rna-make`: from scratch in rounds, since texels keep the noise of early samples."""

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from time import monotonic
from typing import Self

import numpy as np

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.make.make_options import MakeOptions
from rna_export.make.make_progress import Stage, quiet
from rna_export.make.plan import Length
from rna_export.make.state import Score
from rna_export.training.asset_error import asset_error, worse_error
from rna_export.training.checkpoint import Trained, load_checkpoint
from rna_export.training.nearby_choice import run_on
from rna_export.training.part_runs import part_folder, shared_minutes
from rna_export.training.presets import PRESETS, Preset
from rna_export.training.training_run import Run, train
from rna_export.training.validation import mean_psnr, noiseless_psnr, shade, shade_emission
from rna_sdk.files.atomic_file import write_atomically
from rna_work.bar import Bar


@dataclass(frozen=True)
class Phase:
    """A training of one preset, of all parts.

    folder: for checkpoints, one folder in it for each of several parts. starts: checkpoints of
    parts to start from.
    """

    dataset: Dataset
    preset: str
    length: Length
    folder: Path
    options: MakeOptions
    starts: Mapping[str, Path]

    def run(self, shards: Sequence[Path], stage: Stage) -> None:
        """Train each part on the samples of these shards; parts that are finished are skipped."""
        parts = self.dataset.parts
        minutes = shared_minutes(self.length.minutes, parts)
        for k, part in enumerate(parts):
            begun, out = monotonic(), part_folder(self.folder, self.dataset, part.name)
            if (out / "best.ckpt").is_file():
                continue
            run = Run(
                part,
                self._preset(part.kind),
                self.preset,
                out,
                self.options.seed,
                minutes[part.name],
                begun,
                self.options.device,
                after_checkpoint=partial(self._show, out),
                start=self.starts.get(part.name),
            )
            no_bar = partial(Bar, disable=True)
            run, table = run_on(run, self.options.nearby, part.samples_of(shards), quiet, no_bar)
            train(run, table, quiet, stage.part(k / len(parts), 1 / len(parts)))

    def _show(self, training: Path) -> None:
        if self.options.picture is not None:
            copy_sheet(training, self.options.picture)

    def _preset(self, kind: str) -> Preset:
        """The preset of this length."""
        preset = PRESETS[kind][self.preset].on_device(self.options.device)
        return (
            preset if self.length.steps is None else preset.with_training(steps=self.length.steps)
        )


def copy_sheet(training: Path, picture: Path) -> None:
    """Copy the contact sheet of a training's folder, if there is one.

    A picture is no reason to end a training: one that cannot be read or written is left out.
    """
    with suppress(OSError):
        write_atomically(picture, (training / "sheet.png").read_bytes())


def phase_folder(work: Path, preset: str, number: int | None) -> Path:
    """Folder of a preset's phase: of a round, counted from 0, or its last phase."""
    name = "last" if number is None else f"round-{number + 1:02d}"
    return work / "runs" / preset / name


def trained_in(folder: Path, dataset: Dataset) -> list[Trained]:
    """The best model of each part in a phase's folder."""
    folders = [part_folder(folder, dataset, part.name) for part in dataset.parts]
    return [load_checkpoint(path / "best.ckpt") for path in folders]


def score(trained: Sequence[Trained], dataset: Dataset, is_noisy: bool = False) -> Score:
    """Score of the models of all parts, over the whole validation images.

    is_noisy: whether the images have so few paths a pixel that a PSNR must not count their noise.
    """
    views = dataset.whole_views()
    radiance = [
        np.concatenate([shade(one.model, p) for one, p in zip(trained, view.parts, strict=True)])
        for view in views
    ]
    emitted = [
        (shade_emission(one.model, view), view)
        for one, part in zip(trained, dataset.parts, strict=True)
        for view in part.emission_views()
    ]
    error = worse_error(asset_error(radiance, views), emitted)
    psnr = noiseless_psnr(radiance, views).db if is_noisy else mean_psnr(radiance, views)
    return Score(psnr=psnr, flip=error.mean, without_noise=is_noisy)


class Trainer:
    """Runs trainings, one after the other; a context.

    beside: whether each goes on while the caller does something else, until the next one.
    """

    def __init__(self, beside: bool) -> None:
        self._pool = ThreadPoolExecutor(1) if beside else None
        self._running: Future[None] | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._pool is not None:
            self._pool.shutdown()

    def run(self, train: Callable[[], None]) -> None:
        """Train, once the training before is finished, whose error this raises."""
        self.wait()
        if self._pool is None:
            train()
        else:
            self._running = self._pool.submit(train)

    def wait(self) -> None:
        """Return when no training runs any more. Raises the error of a training."""
        running, self._running = self._running, None
        if running is not None:
            running.result()

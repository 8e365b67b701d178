"""Runs trials side by side, in processes that keep the dataset's samples between them."""

from __future__ import annotations

import multiprocessing
import os
import traceback
from collections.abc import Iterator
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path

from rna_export.capture.dataset import Dataset
from rna_export.capture.dataset_part import DatasetPart
from rna_export.training.samples import SampleTable
from rna_export.trials.record import Record
from rna_export.trials.trial import Trial
from rna_sdk.console import INTERRUPTED
from rna_sdk.errors import TrainingError


@dataclass(frozen=True)
class Crew:
    """Who trains."""

    workers: int  # processes
    threads: int  # of each
    device: str

    @classmethod
    def usual(cls, device: str, workers: int | None = None) -> Crew:
        """A process for each core of a CPU, or one for a GPU; cores are shared out evenly.

        device: `auto` is the GPU if there is one. Raises `TrainingError` for `cuda` without one.
        """
        import torch

        there = torch.cuda.is_available()
        if device == "cuda" and not there:
            raise TrainingError("--device cuda: torch finds no CUDA device here")
        device = "cuda" if there and device != "cpu" else "cpu"
        cores = len(os.sched_getaffinity(0))
        count = workers or (1 if device == "cuda" else cores)
        return cls(count, max(1, cores // count), device)


class TrialPool:
    """Runs trials in processes of a crew; a context.

    A process loads the dataset once, before its first trial. What a trial prints is in `log.txt`
    of its folder.
    """

    def __init__(self, dataset: Path, crew: Crew):
        self._pool = ProcessPoolExecutor(
            crew.workers,
            mp_context=multiprocessing.get_context("spawn"),
            initializer=_begin,
            initargs=(dataset, crew),
        )

    def __enter__(self) -> TrialPool:
        return self

    def __exit__(self, *_: object) -> None:
        self._pool.shutdown(wait=True, cancel_futures=True)

    def run(self, trials: list[tuple[Trial, Path]]) -> Iterator[Record]:
        """Records of trials, each with its folder, as they are finished.

        One that fails does not keep the others from running: `TrainingError` names all of them
        at the end.
        """
        running: dict[Future[Record], tuple[Trial, Path]] = {
            self._pool.submit(_run, trial, folder): (trial, folder) for trial, folder in trials
        }
        failures = []
        for future in as_completed(running):
            trial, folder = running[future]
            try:
                record = future.result()
            except BrokenProcessPool:
                raise TrainingError(
                    f"{trial.name}: its process ended at once; is there enough memory?"
                ) from None
            except Exception as error:
                failures.append(f"{trial.name}: {error} (see {folder / 'log.txt'})")
            else:
                yield record
        if failures:
            raise TrainingError("\n".join(failures))


def largest_first(trials: list[Trial]) -> list[Trial]:
    """In an order that keeps all processes busy to the end."""

    def numbers(trial: Trial) -> int:
        m = trial.preset.model
        decoder = m.hidden_layers * m.width**2
        return trial.preset.training.steps * (decoder + m.resolution**2)

    return sorted(trials, key=numbers, reverse=True)


class _Process:
    """What a process of a pool keeps."""

    dataset: DatasetPart
    device: str
    table: SampleTable | None = None


def _begin(dataset: Path, crew: Crew) -> None:
    import torch

    from rna_export.memory import keep_freed_memory
    from rna_sdk.kernel_threads import limit_kernel_threads

    keep_freed_memory()
    torch.set_num_threads(crew.threads)
    limit_kernel_threads(crew.threads)
    _Process.dataset, _Process.device = Dataset(dataset).only, crew.device


def _run(trial: Trial, folder: Path) -> Record:
    from rna_export.trials.run import run_trial

    parent = multiprocessing.parent_process()
    if parent is None or not parent.is_alive():
        os._exit(1)  # it was killed: whoever runs the command again trains in the same folders
    folder.mkdir(parents=True, exist_ok=True)
    try:
        with _log(folder / "log.txt"):
            if _Process.table is None:
                samples = _Process.dataset.training_samples()
                _Process.table = SampleTable(samples, device=_Process.device)
            return run_trial(trial, _Process.dataset, folder, _Process.device, _Process.table)
    except KeyboardInterrupt:
        os._exit(INTERRUPTED)  # a pool's process would go on with the next trial


@contextmanager
def _log(path: Path) -> Iterator[None]:
    """What is printed inside, and the traceback of a failure, goes to a file."""
    with path.open("a") as file, redirect_stdout(file), redirect_stderr(file):
        try:
            yield
        except Exception:
            traceback.print_exc()
            raise

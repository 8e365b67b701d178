"""Runs trials side by side, in workers that keep the dataset's samples between them."""

from __future__ import annotations

import os
import traceback
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from rna_export.capture.dataset import Dataset
from rna_export.training.samples import SampleTable
from rna_export.trials.record import Record
from rna_export.trials.trial import Trial
from rna_sdk.errors import TrainingError
from rna_work.backend import Backend
from rna_work.places import Needs, Place, this_machine
from rna_work.pool import Pool
from rna_work.shared import check_shared

Job = tuple[Trial, Path]
"""A trial and its folder."""


@dataclass(frozen=True)
class Crew:
    """Who trains.

    workers: how many side by side; None for all that there is room for. threads: of each.
    """

    workers: int | None
    threads: int
    device: str
    place: Place = field(default_factory=this_machine)

    @classmethod
    def usual(cls, device: str, workers: int | None = None, place: Place | None = None) -> Crew:
        """A worker for each core of a CPU, or one for a GPU; a machine's cores are shared evenly.

        device: `auto` is the GPU if there is one. Raises `TrainingError` for `cuda` without one.
        """
        place = place or this_machine()
        gpus = place.gpus()
        if device == "cuda" and not gpus:
            raise TrainingError("--device cuda: there is no CUDA device")
        device = "cuda" if gpus and device != "cpu" else "cpu"
        if place.far:
            return cls(workers, 1, device, place)
        cores = len(os.sched_getaffinity(0))
        count = workers or (1 if device == "cuda" else cores)
        return cls(count, max(1, cores // count), device, place)

    def backend(self) -> Backend:
        """The place's room for workers."""
        gpus = 1.0 if self.device == "cuda" else 0.0
        return self.place.workers(Needs("processes", self.threads, gpus), self.workers)


class TrialPool:
    """Runs trials with the workers of a crew; a context.

    A worker loads the dataset once, before its first trial. What a trial prints is in `log.txt`
    of its folder.
    """

    def __init__(self, dataset: Path, crew: Crew):
        check_shared(crew.place, dataset)
        make = partial(TrialWorker, dataset.resolve(), crew.threads, crew.device)
        self._place = crew.place
        self._pool: Pool[Job, Record] = Pool(crew.backend(), make)

    def __enter__(self) -> TrialPool:
        return self

    def __exit__(self, *exception: object) -> None:
        self._pool.__exit__(*exception)

    def run(self, trials: list[Job]) -> Iterator[Record]:
        """Records of trials, each with its folder, as they are finished.

        One that fails does not keep the others from running: `TrainingError` names all of them
        at the end.
        """
        if trials:
            check_shared(self._place, trials[0][1].parent)
        failures = []
        for outcome in self._pool.run([(trial, folder.resolve()) for trial, folder in trials]):
            trial, folder = outcome.item
            if outcome.failure is None:
                yield outcome.value()
            else:
                failures.append(f"{trial.name}: {outcome.failure} (see {folder / 'log.txt'})")
        if failures:
            raise TrainingError("\n".join(failures))


def largest_first(trials: list[Trial]) -> list[Trial]:
    """In an order that keeps all processes busy to the end."""

    def numbers(trial: Trial) -> int:
        m = trial.preset.model
        decoder = m.hidden_layers * m.width**2
        return trial.preset.training.steps * (decoder + m.resolution**2)

    return sorted(trials, key=numbers, reverse=True)


class TrialWorker:
    """Trains trials of a dataset, one after the other: see `rna_work.worker.Worker`."""

    def __init__(self, dataset: Path, threads: int, device: str, name: str) -> None:
        self._folder, self._threads, self._device = dataset, threads, device
        self._table: SampleTable | None = None

    def __enter__(self) -> TrialWorker:
        import torch

        from rna_export.memory import keep_freed_memory
        from rna_sdk.kernel_threads import limit_kernel_threads

        keep_freed_memory()
        torch.set_num_threads(self._threads)
        limit_kernel_threads(self._threads)
        self._dataset = Dataset(self._folder).only
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, job: Job) -> Record:
        """The trial's record; resumes, and skips what is complete in its folder."""
        from rna_export.trials.run import run_trial

        trial, folder = job
        folder.mkdir(parents=True, exist_ok=True)
        with _log(folder / "log.txt"):
            if self._table is None:
                self._table = SampleTable(self._dataset.training_samples(), device=self._device)
            return run_trial(trial, self._dataset, folder, self._device, self._table)

    def kill(self) -> None:
        """The worker is a process, and is ended with it."""


@contextmanager
def _log(path: Path) -> Iterator[None]:
    """What is printed inside, and the traceback of a failure, goes to a file."""
    with path.open("a") as file, redirect_stdout(file), redirect_stderr(file):
        try:
            yield
        except Exception:
            traceback.print_exc()
            raise

"""A worker that trains trials of one dataset, wherever it is."""

import traceback
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from rna_bench.frontier.trials.trial import Trial
from rna_bench.frontier.trials.trial_record import Record
from rna_export.capture.dataset.dataset_folder import Dataset

_LINES = 3  # of a log, in an error


@dataclass(frozen=True)
class Job:
    """A trial and its folder."""

    trial: Trial
    folder: Path

    def __str__(self) -> str:
        return self.trial.name

    def last_words(self) -> str:
        """The last lines of the trial's log, for an error message."""
        log = self.folder / "log.txt"
        text = log.read_text(errors="replace") if log.is_file() else ""
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        return f"the end of {log}: {' / '.join(lines[-_LINES:]) or 'nothing'}"


class TrialWorker:
    """Trains trials, one after the other: see `rna_work.workers.Worker`.

    dataset: its folder.
    """

    def __init__(self, dataset: Path, threads: int, device: str, name: str) -> None:
        self._folder, self._threads, self._device = dataset, threads, device
        self._samples: dict[str, np.ndarray] | None = None

    def __enter__(self) -> "TrialWorker":
        from rna_export.machine import keep_freed_memory
        from rna_export.training.optimization.product_kernels import use_threads

        keep_freed_memory()
        use_threads(self._threads)
        self._dataset = Dataset(self._folder).only
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, job: Job) -> Record:
        """Run or resume the trial and return its record; complete steps are skipped."""
        from rna_bench.frontier.trials.trial_run import run_trial

        job.folder.mkdir(parents=True, exist_ok=True)
        with _log(job.folder / "log.txt"):
            if self._samples is None:
                self._samples = self._dataset.training_samples()
            return run_trial(job.trial, self._dataset, job.folder, self._device, self._samples)

    def kill(self) -> None:
        """The worker is a process, and is ended with it."""


@contextmanager
def _log(path: Path) -> Iterator[None]:
    """Redirects output, and the traceback of a failure, to a file."""
    with path.open("a") as file, redirect_stdout(file), redirect_stderr(file):
        try:
            yield
        except Exception:
            traceback.print_exc()
            raise

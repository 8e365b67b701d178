"""A worker that trains trials of one dataset, wherever it is."""

from __future__ import annotations

import tempfile
import traceback
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path

from rna_bench.frontier.trials.trial import Trial
from rna_bench.frontier.trials.trial_record import Record
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.training.optimization.samples import SampleTable
from rna_work.cluster.store import Store
from rna_work.cluster.stored import Mirror
from rna_work.sources import Carried

_LINES = 3  # of a log, in an error


@dataclass(frozen=True)
class Job:
    """A trial and its folder.

    store: where its checkpoints and results go instead, and then come from; None if workers see
    the folder.
    """

    trial: Trial
    folder: Path
    store: Store | None = None

    def __str__(self) -> str:
        return self.trial.name

    def fetch(self) -> None:
        """Fetch a worker's files from the store."""
        if self.store is not None:
            Mirror(self.folder, self.store).fetch()

    def last_words(self) -> str:
        """The last lines of the trial's log, for an error message."""
        log = self.folder / "log.txt"
        text = log.read_text(errors="replace") if log.is_file() else ""
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        return f"the end of {log}: {' / '.join(lines[-_LINES:]) or 'nothing'}"


class TrialWorker:
    """Trains trials, one after the other: see `rna_work.workers.Worker`.

    dataset: its manifest, with all that belongs to it.
    """

    def __init__(self, dataset: Carried, threads: int, device: str, name: str) -> None:
        self._carried, self._threads, self._device = dataset, threads, device
        self._table: SampleTable | None = None

    def __enter__(self) -> TrialWorker:
        from rna_export.machine import keep_freed_memory
        from rna_export.training.optimization.product_kernels import use_threads

        keep_freed_memory()
        use_threads(self._threads)
        self._dataset = Dataset(self._carried.here().parent).only
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, job: Job) -> Record:
        """Run or resume the trial and return its record; complete steps are skipped."""
        if job.store is None:
            return self._trained(job.trial, job.folder, None)
        with tempfile.TemporaryDirectory(prefix="rna-trial-") as folder:
            mirror = Mirror(Path(folder), job.store)
            mirror.fetch()
            try:
                return self._trained(job.trial, Path(folder), mirror)
            finally:
                mirror.send()

    def _trained(self, trial: Trial, folder: Path, mirror: Mirror | None) -> Record:
        from rna_bench.frontier.trials.trial_run import run_trial

        folder.mkdir(parents=True, exist_ok=True)
        with _log(folder / "log.txt"):
            if self._table is None:
                self._table = SampleTable(self._dataset.training_samples(), device=self._device)
            send = _nothing if mirror is None else mirror.send
            return run_trial(trial, self._dataset, folder, self._device, self._table, send)

    def kill(self) -> None:
        """The worker is a process, and is ended with it."""


def _nothing() -> None:
    pass


@contextmanager
def _log(path: Path) -> Iterator[None]:
    """Redirects output, and the traceback of a failure, to a file."""
    with path.open("a") as file, redirect_stdout(file), redirect_stderr(file):
        try:
            yield
        except Exception:
            traceback.print_exc()
            raise

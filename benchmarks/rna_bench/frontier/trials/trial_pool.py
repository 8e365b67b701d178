"""Runs trials concurrently, in workers that keep the dataset's samples loaded."""

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from rna_bench.frontier.trials.trial import Trial
from rna_bench.frontier.trials.trial_record import Record
from rna_bench.frontier.trials.trial_worker import Job, TrialWorker
from rna_sdk.errors import TrainingError
from rna_sdk.machine.cores import core_count
from rna_work.backend import Backend, Needs
from rna_work.executors import Executor, check_shared, this_machine
from rna_work.pool import Pool

_PROCESS_BYTES = 1_000_000_000  # of a worker without samples


@dataclass(frozen=True)
class TrialWorkers:
    """The workers of trials.

    count: how many side by side; None for all that there is room for. threads: of each.
    memory: of each, bytes, that a node of a cluster has to have.
    """

    count: int | None
    threads: int
    device: str
    executor: Executor = field(default_factory=this_machine)
    memory: int = 0

    @classmethod
    def usual(
        cls,
        device: str,
        workers: int | None = None,
        executor: Executor | None = None,
        dataset: Path | None = None,
    ) -> "TrialWorkers":
        """A worker for each core of a CPU, or one for a GPU; a machine's cores are shared evenly.

        device: `auto` is the GPU if there is one. dataset: that each worker of a cluster
        holds. Raises `TrainingError` for `cuda` without one.
        """
        executor = executor or this_machine()
        gpus = executor.gpus()
        if device == "cuda" and not gpus:
            raise TrainingError("--device cuda: there is no CUDA device")
        device = "cuda" if gpus and device != "cpu" else "cpu"
        if executor.far:
            memory = 0 if dataset is None else memory_for(dataset)
            return cls(workers, 1, device, executor, memory)
        cores = core_count()
        count = workers or (1 if device == "cuda" else cores)
        return cls(count, max(1, cores // count), device, executor)

    def backend(self) -> Backend:
        """Its room for workers, which share its GPUs evenly if there are more of them."""
        gpus = 0.0
        if self.device == "cuda":
            gpus = min(1.0, self.executor.gpus() / self.count) if self.count else 1.0
        needs = Needs("processes", self.threads, gpus, self.memory)
        return self.executor.workers(needs, self.count)


def memory_for(dataset: Path) -> int:
    """Bytes that a worker with a dataset takes, about: its samples twice, while it reads them."""
    shards = sum(path.stat().st_size for path in (dataset / "train").glob("*.safetensors"))
    return _PROCESS_BYTES + 2 * shards


class TrialPool:
    """Runs trials; a context.

    A worker loads the dataset once, before its first trial. What a trial prints is in `log.txt`
    of its folder. tell: gets a line for each trial that is run again.
    """

    def __init__(self, dataset: Path, workers: TrialWorkers, tell: Callable[[str], None] = print):
        self._executor = workers.executor
        check_shared(self._executor, dataset)
        make = partial(TrialWorker, dataset.resolve(), workers.threads, workers.device)
        self._pool: Pool[Job, Record] = Pool(workers.backend(), make, tell=tell)

    def __enter__(self) -> "TrialPool":
        return self

    def __exit__(self, *exception: object) -> None:
        self._pool.__exit__(*exception)

    def nodes(self) -> Counter[str]:
        """Number of workers by node."""
        return self._pool.nodes()

    def run(self, trials: list[tuple[Trial, Path]]) -> Iterator[Record]:
        """Records of trials, each with its folder, as they are finished.

        One that fails does not keep the others from running: `TrainingError` names all of them
        at the end, with the last lines of their logs.
        """
        if trials:
            check_shared(self._executor, trials[0][1].parent)
        failures = []
        for outcome in self._pool.run([Job(trial, folder.resolve()) for trial, folder in trials]):
            job = outcome.item
            if outcome.failure is None:
                yield outcome.value()
            else:
                failures.append(f"{job}: {outcome.failure}; {job.last_words()}")
        if failures:
            raise TrainingError("\n".join(failures))


def largest_first(trials: list[Trial]) -> list[Trial]:
    """The trials by decreasing cost, which keeps all processes busy to the end."""

    def numbers(trial: Trial) -> int:
        m = trial.preset.model
        decoder = m.hidden_layers * m.width**2
        return trial.preset.training.steps * (decoder + m.resolution**2)

    return sorted(trials, key=numbers, reverse=True)

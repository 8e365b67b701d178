"""Ctrl-C and failures in a capture, with stand-ins for Blender and for the tasks."""

import threading
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from rna_export.capture.blender_process import capture_worker
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.capture_worker import CaptureWorker
from rna_export.capture.capture_settings import CaptureSettings
from rna_sdk.errors import CaptureError
from rna_work.pool import Pool
from rna_work.sources import InPlace
from rna_work.threads import Threads


@dataclass
class Blender:
    """Answers nothing until it is killed."""

    starts: int = 0
    restarts: int = 0
    killed: threading.Event = field(default_factory=threading.Event)

    def __enter__(self) -> "Blender":
        self.starts += 1
        return self

    def close(self) -> None:
        pass

    def restart(self) -> None:
        self.restarts += 1

    def kill(self) -> None:
        self.killed.set()


SETTINGS = CaptureSettings.usual("surface")
DATASET = SimpleNamespace(manifest=SimpleNamespace(settings=SETTINGS))


@dataclass(eq=False)
class Task:
    """Runs until its worker is killed, or fails of its own the first `failures` times."""

    folder: Path
    failures: int | None = None
    runs: int = 0
    begun: threading.Event = field(default_factory=threading.Event)

    def path(self, dataset: object) -> Path:
        return self.folder / "shard"

    def paths_to_trace(self, dataset: object) -> int:
        return SETTINGS.lights_per_shard * SETTINGS.rays * SETTINGS.samples

    def run(self, dataset: object, scene: object, worker: Blender) -> None:
        self.runs += 1
        self.begun.set()
        if self.failures is None:
            assert worker.killed.wait(10.0)
        if self.failures is None or self.runs <= self.failures:
            raise CaptureError("the Blender worker ended without an answer")


@pytest.fixture
def blender(monkeypatch):
    blender = Blender()
    monkeypatch.setattr(capture_worker, "BlenderWorker", lambda *_, **__: blender)
    monkeypatch.setattr(capture_worker, "opened", lambda *_: (DATASET, None))
    monkeypatch.setattr(capture_worker, "blender_env", SimpleNamespace(find_or_set_up=Path))
    return blender


def pool(tmp_path: Path) -> Pool[Any, None]:
    path = tmp_path / "ball.blend"
    path.touch()
    job = capture_worker.CaptureJob(
        InPlace(path), None, Source(path), InPlace(path), scratch=tmp_path
    )
    return Pool(Threads(1), lambda name: CaptureWorker(job, name), attempts=2)


def test_ctrl_c_ends_blender_and_repeats_nothing(blender, tmp_path):
    stopped, later = Task(tmp_path), Task(tmp_path)

    def items() -> Any:
        yield stopped
        assert stopped.begun.wait(10.0)
        raise KeyboardInterrupt  # where the pool looks for more to give
        yield later

    with (
        pytest.raises(KeyboardInterrupt),
        pool(tmp_path) as workers,
        closing(workers.run(items())) as outcomes,
    ):
        workers._backend = Threads(2)  # so that it looks for more
        list(outcomes)
    assert (stopped.runs, later.runs, blender.killed.is_set()) == (1, 0, True)


def test_a_task_is_repeated_once_where_blender_died(blender, tmp_path):
    task = Task(tmp_path, failures=1)
    with pool(tmp_path) as workers:
        [outcome] = workers.run([task])
    assert outcome.failure is None and (task.runs, blender.starts) == (2, 2)

    task = Task(tmp_path, failures=2)
    with pool(tmp_path) as workers:
        [outcome] = workers.run([task])
    assert isinstance(outcome.failure, CaptureError) and task.runs == 2


def test_what_a_lost_worker_had_finished_is_not_done_again(blender, tmp_path):
    (tmp_path / "shard").touch()
    task = Task(tmp_path)
    with pool(tmp_path) as workers:
        assert [o.failure for o in workers.run([task])] == [None]
    assert task.runs == 0


def test_blender_is_fresh_after_a_dozen_tasks(blender, tmp_path):
    tasks = [Task(tmp_path, failures=0) for _ in range(25)]
    with pool(tmp_path) as workers:
        list(workers.run(tasks))
    assert (blender.starts, blender.restarts) == (1, 2)

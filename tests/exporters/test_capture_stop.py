"""Ctrl-C in a capture, with stand-ins for Blender and for the tasks."""

from __future__ import annotations

import threading
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from rna_export.capture import run
from rna_sdk.errors import CaptureError


@dataclass
class Worker:
    """A Blender that answers nothing until it is killed."""

    starts: int = 0
    killed: threading.Event = field(default_factory=threading.Event)

    def __enter__(self) -> Worker:
        self.starts += 1
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def restart(self) -> None:
        self.starts += 1

    def kill(self) -> None:
        self.killed.set()


@dataclass
class Task:
    """Runs until its worker is killed, or fails of its own the first `failures` times."""

    failures: int = 0
    runs: int = 0
    begun: threading.Event = field(default_factory=threading.Event)

    def run(self, dataset: object, scene: object, worker: Worker) -> None:
        self.runs += 1
        self.begun.set()
        if self.failures == 0:
            assert worker.killed.wait(10.0)
        if self.failures == 0 or self.runs <= self.failures:
            raise CaptureError("the Blender worker ended without an answer")

    def paths_to_trace(self, dataset: object) -> int:
        return 1


def shift(task: Task, worker: Worker) -> Any:
    crew = SimpleNamespace(workers=1, worker=lambda source, name: worker)
    bar = SimpleNamespace(update=lambda paths: None)
    source: Any = Path("ball.blend")
    result = run._Shift(dataset=None, scene=None, source=source, crew=crew, bar=bar)
    result.todo.put(task)
    return result


def test_ctrl_c_repeats_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    task, worker = Task(), Worker()
    pressed = []

    def press_once(_: float) -> None:
        assert task.begun.wait(10.0)
        if not pressed:
            pressed.append(True)
            raise KeyboardInterrupt

    monkeypatch.setattr(run, "time", SimpleNamespace(sleep=press_once))
    with pytest.raises(KeyboardInterrupt):
        shift(task, worker).work()
    assert (task.runs, worker.starts) == (1, 1)


def test_a_task_is_repeated_once_where_blender_died() -> None:
    task, worker = Task(failures=1), Worker()
    work = shift(task, worker)
    work.work()
    assert (task.runs, worker.starts, work.failures) == (2, 2, [])

    task, worker = Task(failures=2), Worker()
    work = shift(task, worker)
    work.work()
    assert task.runs == 2 and len(work.failures) == 1

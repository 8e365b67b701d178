"""Object storage between workers and the folder of a dataset."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from uuid import uuid4

import pytest

from rna_export.capture import run as run_module
from rna_export.capture.dataset import Dataset
from rna_export.capture.run import CaptureCrew, finish
from rna_export.capture.worker import Source
from rna_sdk.errors import WorkError
from rna_work.store import Store
from tests.exporters.test_capture_time import WithoutBlender
from tests.exporters.test_capture_time import dataset as dataset
from tests.work.stores import s3


@pytest.fixture(params=["memory", "s3"])
def store(request: pytest.FixtureRequest) -> Iterator[Store]:
    if request.param == "memory":
        yield Store(f"memory://{uuid4().hex}")
        return
    with s3() as bucket:
        yield bucket


pytestmark = pytest.mark.filterwarnings("ignore")  # of moto and its requirements


def test_files_come_back_as_they_were(store: Store, tmp_path: Path) -> None:
    assert store.names() == set()
    store.check()
    local, back = tmp_path / "a", tmp_path / "deep" / "b"
    local.write_bytes(os.urandom(100_000))
    store.below("x").put(local, "train/0.bin")
    assert store.names() == {"x/train/0.bin"} and store.below("x").names() == {"train/0.bin"}
    store.get("x/train/0.bin", back)
    assert back.read_bytes() == local.read_bytes()
    with pytest.raises(WorkError, match="x/gone"):
        store.get("x/gone", tmp_path / "c")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a", "deep"]


def test_addresses_that_cannot_be_used_say_so() -> None:
    with pytest.raises(WorkError, match="--store nothing://x: "):
        Store("nothing://x").check()


def test_a_capture_is_gathered(
    store: Store, dataset: Dataset, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is finished goes through the store; what it has is not rendered again."""
    made: list[str] = []

    def run(task: object, dataset: Dataset, *_: object) -> None:
        made.append(str(task))
        task.path(dataset).write_bytes(str(task).encode())

    for kind in (run_module.TrainingShard, type(run_module.all_tasks(dataset)[0])):
        monkeypatch.setattr(kind, "run", run)
    monkeypatch.setattr(run_module, "CaptureWorker", WithoutBlender)
    crew = CaptureCrew(Path("python"), tmp_path / "scratch", 1, store=store)
    tasks = run_module.all_tasks(dataset)
    finish(dataset, Source(Path("ball.py")), crew, say=lambda _: None)
    assert len(made) == len(tasks) == len(store.names())
    for task in tasks[::2]:
        task.path(dataset).unlink()
    finish(dataset, Source(Path("ball.py")), crew, say=lambda _: None)
    assert len(made) == len(tasks)
    assert all(task.path(dataset).read_bytes() == str(task).encode() for task in tasks)

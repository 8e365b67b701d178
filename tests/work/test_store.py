"""Object storage between workers and the folder of a dataset."""

import os
import shutil
from pathlib import Path
from uuid import uuid4

import numpy as np
import pytest

from rna_export.capture import capture_run as run_module
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.capture_run import CaptureWorkers, finish
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.sample_files import write_arrays
from rna_sdk.errors import WorkError
from rna_work.cluster.store import Store
from tests.exporters.test_capture_time import WithoutBlender
from tests.exporters.test_capture_time import dataset as dataset
from tests.work.stores import s3


@pytest.fixture(params=["memory", "s3"])
def store(request):
    if request.param == "memory":
        yield Store(f"memory://{uuid4().hex}")
        return
    with s3() as bucket:
        yield bucket


pytestmark = pytest.mark.filterwarnings("ignore")  # of moto and its requirements


def test_files_come_back_as_they_were(store, tmp_path):
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


def test_addresses_that_cannot_be_used_say_so():
    with pytest.raises(WorkError, match="--store nothing://x: "):
        Store("nothing://x").check()


def test_a_capture_is_gathered(store, dataset, tmp_path, monkeypatch):
    """Finished shards go through the store; its shards are not rendered again."""
    made: list[str] = []

    def run(task: object, dataset: Dataset, *_: object) -> None:
        made.append(str(task))
        write_arrays(task.path(dataset), {"asset/wo": np.ones((3, 3)), str(task): np.zeros(3)})

    tasks = run_module.all_tasks(dataset)
    for kind in {type(task) for task in tasks}:
        monkeypatch.setattr(kind, "run", run)
    monkeypatch.setattr(run_module, "CaptureWorker", WithoutBlender)
    workers = CaptureWorkers(Path("python"), tmp_path / "scratch", 1, store=store)
    finish(dataset, Source(Path("ball.py")), workers, say=lambda _: None)
    assert len(made) == len(tasks) == len(store.names())
    for task in tasks[::2]:
        task.path(dataset).unlink()
    finish(dataset, Source(Path("ball.py")), workers, say=lambda _: None)
    assert len(made) == len(tasks)
    assert all(str(task).encode() in task.path(dataset).read_bytes() for task in tasks)
    cut = tasks[0].path(dataset)
    whole, name = cut.read_bytes(), tasks[0].path(dataset).relative_to(dataset.folder).as_posix()
    there = next(name_there for name_there in store.names() if name_there.endswith(name))
    (tmp_path / "cut").write_bytes(whole[:-5])
    store.put(tmp_path / "cut", there)
    cut.unlink()
    finish(dataset, Source(Path("ball.py")), workers, say=lambda _: None)
    assert len(made) == len(tasks) + 1  # what was cut is made again, and kept
    store.get(there, tmp_path / "again")
    assert cut.read_bytes() == (tmp_path / "again").read_bytes() == whole


@pytest.mark.parametrize(
    "key", ["../../escaped", "train/../../escaped", "C:/escaped", "..\\escaped"]
)
def test_an_object_that_leads_out_of_the_folder_is_refused(key, tmp_path):
    """Object storage keeps such names, and whoever may write to it can put one there."""
    store = Store(f"memory://{uuid4().hex}/trial")
    (tmp_path / "last.ckpt").write_bytes(b"x")
    store.put(tmp_path / "last.ckpt", "last.ckpt")
    system, root = store._opened()
    path = f"{root}/{key}"
    system.store[path] = system.store[f"{root}/last.ckpt"]
    folder = tmp_path / "a" / "b" / "c"
    for call in (store.names, lambda: store.get(key, folder / "x")):
        with pytest.raises(WorkError, match="relative path without"):
            call()
    with pytest.raises(WorkError, match="relative path without"):
        store.put(tmp_path / "last.ckpt", key)
    assert sorted(p.name for p in tmp_path.rglob("*")) == ["last.ckpt"]


@pytest.fixture
def sent(tmp_path):
    """A store in a folder, that folder, and a file that is sent to it."""
    first = tmp_path / "data" / "manifest.json"
    first.parent.mkdir()
    first.write_bytes(b"whole")
    return Store(f"file://{tmp_path / 'there'}"), tmp_path / "there", first


def test_a_file_in_a_folder_is_put_whole_or_not(sent, monkeypatch):
    store, there, first = sent
    store.put(first, "x")

    def full(_: object, to: Path) -> None:
        to.write_bytes(b"wh")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(shutil, "copyfile", full)
    with pytest.raises(WorkError, match="No space"):
        store.put(first, "x")
    assert [p.name for p in there.iterdir()] == ["x"] and (there / "x").read_bytes() == b"whole"
    (there / ".x.0123456789ab.part").write_bytes(b"wh")  # of a process that was ended
    assert store.names() == {"x"}

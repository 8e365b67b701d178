"""Trainings on machines that share no folder: dataset and checkpoints go through a store.

`test_cluster_commands.py` has them on a cluster.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from uuid import uuid4

import pytest

from rna_bench.frontier.trials.trial import Trial
from rna_bench.frontier.trials.trial_pool import TrialPool, TrialWorkers
from rna_bench.frontier.trials.trial_record import Record
from rna_bench.frontier.trials.trial_worker import Job, TrialWorker
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.training.optimization.fitting import Fitting
from rna_work.cluster.store import Store
from rna_work.cluster.stored import Mirror, StoredFolder
from rna_work.executors import open_executor
from rna_work.sources import InPlace
from tests.exporters.synthetic import hurried_packages, make_dataset, tiny
from tests.work.stores import s3

pytestmark = pytest.mark.filterwarnings("ignore")  # of Ray and moto
TRIALS = [Trial(name=f"t{k}", family="ours", preset=tiny(steps=12), seed=k) for k in range(2)]


@pytest.fixture(scope="module", autouse=True)
def hurried() -> Iterator[None]:
    with hurried_packages():
        yield


@pytest.fixture
def memory() -> Store:
    return Store(f"memory://{uuid4().hex}")


@pytest.fixture
def dataset(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> DatasetPart:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return make_dataset(tmp_path / "ball.rays")


def test_a_mirror_sends_what_changed_and_removes_what_is_gone(
    memory: Store, tmp_path: Path
) -> None:
    one, other = tmp_path / "one", tmp_path / "other"
    one.mkdir()
    for name in ("a", "b"):
        (one / name).write_text(name)
    (one / "c.part").write_text("unfinished")
    mirror = Mirror(one, memory)
    mirror.send()
    assert memory.names() == {"a", "b"}
    Mirror(other, memory).fetch()
    assert (other / "b").read_text() == "b"
    (one / "a").unlink()
    (one / "b").write_text("new")
    mirror.send()
    again = Mirror(other, memory)
    again.fetch()
    assert memory.names() == {"b"} and (other / "b").read_text() == "new"


def test_a_file_is_sent_once_whatever_its_name(memory: Store, dataset: DatasetPart) -> None:
    manifest = dataset.folder / "manifest.json"
    first = StoredFolder.of(manifest, memory)
    there = memory.names()
    shard = dataset.folder / "train" / "00000.safetensors"
    (shard.parent / "00009.safetensors").write_bytes(shard.read_bytes())
    assert StoredFolder.of(manifest, memory).sha256 != first.sha256
    assert memory.names() == there
    here = first.here()
    assert here != manifest and here.read_bytes() == manifest.read_bytes()
    assert (here.parent / "train" / shard.name).read_bytes() == shard.read_bytes()
    assert not (here.parent / "train" / "00009.safetensors").exists()


def test_a_lost_worker_s_training_goes_on_from_its_last_checkpoint(
    memory: Store, dataset: DatasetPart, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    manifest = InPlace(dataset.folder / "manifest.json")
    trial = Trial(name="long", family="ours", preset=tiny(steps=12), seed=1)
    monkeypatch.setattr("rna_bench.frontier.trials.trial_run._VALIDATED_EVERY", 4)

    def trained(store: Store) -> Record:
        with TrialWorker(manifest, 1, "cpu", "0") as worker:
            return worker.run(Job(trial, tmp_path / "unused", store))

    expected = trained(memory.below("whole")).points
    steps: list[float] = []
    step = Fitting.step

    def lost_once(self: Fitting, rows: object, progress: float) -> object:
        steps.append(progress)
        if len(steps) == 10:
            raise KeyboardInterrupt
        return step(self, rows, progress)

    monkeypatch.setattr(Fitting, "step", lost_once)
    with pytest.raises(KeyboardInterrupt):
        trained(memory.below("lost"))
    assert "last.ckpt" in memory.below("lost").names()
    assert trained(memory.below("lost")).points == expected
    assert len(steps) == 10 + 4  # from the checkpoint after 8 of 12 on
    assert not {n for n in memory.below("lost").names() if n in ("last.ckpt", "best-so-far.ckpt")}
    assert not (tmp_path / "unused").exists()


@pytest.fixture(params=["file", "s3"])
def store(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Store]:
    if request.param == "file":
        yield Store(f"file://{tmp_path}/store")
        return
    with s3() as bucket:
        yield bucket


def test_what_is_in_the_store_is_not_trained_again(
    store: Store, dataset: DatasetPart, tmp_path: Path
) -> None:
    with open_executor(None) as here:
        workers = TrialWorkers(1, 1, "cpu", here, store)
        logs = []
        for name in ("a", "b"):
            with TrialPool(dataset.folder, workers) as pool:
                actual = list(pool.run([(t, tmp_path / name / t.name) for t in TRIALS]))
            assert sorted(record.trial.name for record in actual) == ["t0", "t1"]
            logs.append((tmp_path / name / "t0" / "log.txt").read_text())
            assert (tmp_path / name / "t0" / "int8-int8.rna").is_file()
    assert "samples" in logs[0] and logs[1] == logs[0]

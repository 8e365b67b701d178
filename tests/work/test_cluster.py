"""The pool of workers on a Ray cluster of three nodes."""

import time
from types import SimpleNamespace
from typing import Any

import pytest

from rna_sdk.errors import WorkError
from rna_work.backend import Needs
from rna_work.executors import open_executor
from rna_work.pool import Pool
from rna_work.workers import WorkerLost
from tests.work.workers import CannotStart, Doubling, Once, Repeating

pytestmark = pytest.mark.filterwarnings("ignore")  # Ray's own, of its future versions


@pytest.fixture(scope="module")
def executor(ray_address):
    with open_executor(ray_address) as executor:
        yield executor


CORE = Needs("processes")


def test_every_item_has_an_outcome_and_all_nodes_work(executor):
    with Pool(executor.workers(CORE, None), Doubling, ahead=1) as pool:
        first = [o.value() for o in pool.run([0.2] * 12)]
        assert len(pool.nodes()) == 3
        values = [o.value() for o in pool.run(range(50), ordered=True)]
    assert first == [0.4] * 12 and values == list(range(0, 100, 2))


def test_failures_are_as_on_one_machine(executor, tmp_path):
    with Pool(executor.workers(CORE, 2), Repeating, attempts=2) as pool:
        assert [o.value() for o in pool.run([Once(tmp_path / "a", "fail")])] == ["done"]
        [failed] = pool.run(["fail"])
        assert isinstance(failed.failure, ValueError)
        assert [o.value() for o in pool.run([Once(tmp_path / "b", "die")])] == ["done"]
    with Pool(executor.workers(CORE, 1), CannotStart) as pool:
        with pytest.raises(ValueError, match="cannot start"):
            list(pool.run([1]))


def test_a_worker_that_dies_over_and_over_fails_its_item(executor):
    with Pool(executor.workers(CORE, 2), Doubling) as pool:
        outcomes = list(pool.run(["die", 1]))
    assert sorted(o.failure is None for o in outcomes) == [False, True]
    assert any(isinstance(o.failure, WorkerLost) for o in outcomes)


def test_a_source_travels_with_what_lies_beside_it(executor, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    source, texture = tmp_path / "a" / "toy.py", tmp_path / "maps" / "wood.png"
    for path in (source, texture):
        path.parent.mkdir()
    source.write_text("toy")
    texture.write_bytes(b"wood")
    carried = executor.carry(source, [texture, source])
    here = carried.here()
    assert here != source and here.read_text() == "toy"
    assert (here.parent / "../maps/wood.png").read_bytes() == b"wood"
    assert carried.here() == here and executor.carry(source, [texture]).here() == here
    texture.write_bytes(b"oak")
    assert executor.carry(source, [texture]).here() != here


def test_files_that_are_elsewhere_and_missing_are_an_error(executor, tmp_path):
    from rna_work.cluster.travelling import check_elsewhere

    source, outside = tmp_path / "a" / "toy.blend", tmp_path / "b" / "wood.png"
    for path in (source, outside):
        path.parent.mkdir()
        path.write_bytes(b"x")
    executor.carry(source, fixed=[outside])  # all nodes are this machine, which has it
    with pytest.raises(WorkError, match=r"toy\.blend reads .*gone\.png by an absolute path"):
        check_elsewhere(source, {tmp_path / "gone.png": "0"})


class BusyHead:
    """Stands for Ray with a head that is too busy to serve the first sessions."""

    def __init__(self, failures: int) -> None:
        self.failures, self.connected = failures, False

    def is_initialized(self) -> bool:
        return self.connected

    def init(self, **options: Any) -> None:
        if self.failures:
            self.failures -= 1
            raise ConnectionAbortedError("Initialization failure from server:\nIt did not start.")
        self.connected = True

    def shutdown(self) -> None:
        self.connected = False


def test_a_busy_head_is_asked_again(monkeypatch):
    head = BusyHead(failures=2)
    monkeypatch.setattr("rna_work.cluster.ray_cluster.imported_ray", lambda: head)
    with open_executor("auto"):
        assert head.connected
    head.failures = 3
    with (
        pytest.raises(WorkError, match=r"^--cluster auto: no cluster answers: It did not start\.$"),
        open_executor("auto"),
    ):
        pass


def test_workers_share_a_gpu(cluster, executor):
    """Ray believes what a node says of its GPUs; whether CUDA works there is not seen here."""
    node = cluster.add_node(num_cpus=2, num_gpus=1)
    try:
        while not executor.gpus():
            time.sleep(0.1)
        with Pool(executor.workers(Needs("processes", 1, 0.5), 2), Doubling) as pool:
            actual = [o.value() for o in pool.run(["gpus"] * 8)]
            assert pool.nodes().total() == 2
        assert actual == ["0"] * 8
        assert executor.workers(Needs("processes", 1, 1.0), None).width() == 1
    finally:
        cluster.remove_node(node)


def test_workers_go_where_there_is_memory(cluster, executor):
    node = cluster.add_node(num_cpus=1, memory=1 << 40)
    try:
        needs = Needs("processes", memory=1 << 39)
        backend = executor.workers(needs, None)
        while not backend.width():
            time.sleep(0.1)
        assert backend.width() == 1
        with Pool(backend, Doubling) as pool:
            assert [o.value() for o in pool.run([1])] == [2]
    finally:
        cluster.remove_node(node)


def test_local_is_a_cluster_of_its_own(monkeypatch):
    """Without an address Ray takes one that runs on this machine."""
    seen: dict[str, object] = {}
    ray = SimpleNamespace(
        is_initialized=lambda: False, init=lambda **o: seen.update(o), shutdown=seen.clear
    )
    monkeypatch.setattr("rna_work.cluster.ray_cluster.imported_ray", lambda: ray)
    with open_executor("local"):
        assert seen["address"] == "local"
    assert not seen

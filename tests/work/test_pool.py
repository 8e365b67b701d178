"""The pool of workers, on threads and on processes."""

import threading
import time
from collections.abc import Iterator
from concurrent.futures import Future

import pytest

from rna_sdk.errors import WorkError
from rna_work.pool import Pool
from rna_work.processes import Processes
from rna_work.threads import Threads
from rna_work.timeouts import Timeouts
from rna_work.workers import TimedOut, WorkerLost
from tests.work.workers import CannotStart, Doubling, Once, Repeating

BACKENDS = [Threads(2), Processes(2)]
ids = ["threads", "processes"]


@pytest.mark.parametrize("backend", BACKENDS, ids=ids)
def test_every_item_has_an_outcome(backend):
    with Pool(backend, Doubling) as pool:
        assert sorted(o.value() for o in pool.run(range(20))) == list(range(0, 40, 2))
        assert [o.value() for o in pool.run([])] == []
        assert [o.value() for o in pool.run([4])] == [8]  # the workers are there still


def test_order_is_kept_where_it_is_asked_for():
    slow_first = [0.3, 0.0, 0.01, 0.1, 0.0, 0.02]
    with Pool(Threads(3), Doubling, ahead=1) as pool:
        actual = [o.value() for o in pool.run(slow_first, ordered=True)]
    assert actual == [2 * s for s in slow_first]


class OutOfTurn:
    """A backend of one worker, whose pairs of items are told of in reverse, as Ray may do."""

    losses = 1
    name = "0"

    def __init__(self) -> None:
        self.ready: Future[str] = Future()
        self.ready.set_result("here")
        self._given: list[tuple[int, Future[int]]] = []

    def width(self) -> int:
        return 1

    def slot(self, make: object, name: str) -> "OutOfTurn":
        return self

    def give(self, item: int) -> Future[int]:
        future: Future[int] = Future()
        self._given.append((item, future))
        if len(self._given) == 2:
            threading.Timer(0.01, self._settle, [self._given]).start()
            self._given = []
        return future

    @staticmethod
    def _settle(given: list[tuple[int, Future[int]]]) -> None:
        for item, future in reversed(given):
            future.set_result(2 * item)

    def processor_seconds(self) -> None:
        pass

    def close(self, kill: bool) -> None:
        pass


@pytest.mark.parametrize("ordered", [False, True])
def test_a_result_belongs_to_its_item_whatever_is_told_of_first(ordered):
    with Pool(OutOfTurn(), Doubling, ahead=1) as pool:
        outcomes = list(pool.run(range(20), ordered=ordered))
    assert all(o.result == 2 * o.item for o in outcomes)
    assert sorted(o.item for o in outcomes) == list(range(20))
    if ordered:
        assert [o.item for o in outcomes] == list(range(20))


def test_items_are_taken_when_workers_are_free_for_them():
    taken: list[int] = []

    def items() -> Iterator[int]:
        for k in range(10_000):
            taken.append(k)
            yield k

    with Pool(Threads(2), Doubling, ahead=1) as pool:
        for seen, outcome in enumerate(pool.run(items(), ordered=True)):
            assert outcome.result == 2 * seen
            assert len(taken) <= seen + 2 * 2 * 2 + 1
            if seen == 1000:
                break
    assert len(taken) < 1020


def test_a_run_that_was_left_does_not_disturb_the_next():
    with Pool(Threads(2), Doubling) as pool:
        next(iter(pool.run([0.0, 0.2, 0.2, 0.2])))
        assert sorted(o.value() for o in pool.run([1, 2, 3])) == [2, 4, 6]


@pytest.mark.parametrize("backend", BACKENDS, ids=ids)
def test_a_failure_is_the_outcome_of_its_item_alone(backend):
    with Pool(backend, Doubling) as pool:
        outcomes = list(pool.run([1, "fail", 2]))
    assert sorted(o.result for o in outcomes if o.failure is None) == [2, 4]
    [failed] = [o for o in outcomes if o.failure is not None]
    with pytest.raises(ValueError, match="was told to fail"):
        failed.value()


@pytest.mark.parametrize("backend", BACKENDS, ids=ids)
def test_a_failed_item_is_run_again_by_a_fresh_worker(backend, tmp_path):
    item = Once(tmp_path / "mark", "fail")
    with Pool(backend, Repeating, attempts=2) as pool:
        [outcome] = pool.run([item])
        assert outcome.value() == "done" and outcome.worker != "0"
        [failed] = pool.run(["fail"])
    assert isinstance(failed.failure, ValueError)


def test_a_process_that_ends_is_replaced():
    with Pool(Processes(1), Doubling) as pool:
        outcomes = list(pool.run([1, "die", 2]))
    assert [o.result for o in outcomes] == [2, None, 4]
    assert isinstance(outcomes[1].failure, WorkerLost) and "killed" in str(outcomes[1].failure)


@pytest.mark.parametrize("backend", BACKENDS, ids=ids)
def test_what_hangs_is_ended_and_run_again(backend, tmp_path):
    def timeouts() -> Timeouts:
        return Timeouts(least=0.5)

    item = Once(tmp_path / "mark", "hang")
    with Pool(backend, Repeating, attempts=2, timeouts=timeouts()) as pool:
        outcomes = list(pool.run([1, 2, 3, item, 4]))
    assert sorted(str(o.value()) for o in outcomes) == ["2", "4", "6", "8", "done"]
    with Pool(backend, Doubling, timeouts=timeouts()) as pool:
        hung = [o for o in pool.run([1, 2, 3, "hang"]) if o.failure is not None]
    assert len(hung) == 1 and isinstance(hung[0].failure, TimedOut)


@pytest.mark.parametrize("backend", BACKENDS, ids=ids)
def test_what_is_slow_beside_other_programs_is_left_to_finish(backend):
    with Pool(backend, Doubling, timeouts=Timeouts(least=0.2)) as pool:
        outcomes = list(pool.run([1, 2, 3, "slow"]))
    assert [o.failure for o in outcomes] == [None] * 4


@pytest.mark.parametrize("backend", BACKENDS, ids=ids)
def test_what_runs_in_circles_is_ended(backend):
    with Pool(backend, Doubling, timeouts=Timeouts(least=0.3)) as pool:
        [failed] = [o for o in pool.run([1, 2, 3, "circles"]) if o.failure is not None]
    assert isinstance(failed.failure, TimedOut) and "of processor time" in str(failed.failure)


@pytest.mark.parametrize("backend", BACKENDS, ids=ids)
def test_workers_that_cannot_start_say_why(backend):
    with Pool(backend, CannotStart) as pool, pytest.raises(ValueError, match="cannot start"):
        list(pool.run([1]))


class NoRoom(Threads):
    def width(self) -> int:
        return 0


def test_no_room_for_workers_is_an_error(monkeypatch):
    monkeypatch.setattr("rna_work.pool._NO_ROOM", 0.1)
    with Pool(NoRoom(1), Doubling) as pool, pytest.raises(WorkError, match="no node had resources"):
        list(pool.run([1]))


def test_a_worker_that_does_not_start_is_told_of_once(monkeypatch):
    class Late(Doubling):
        def __enter__(self) -> "Late":
            time.sleep(0.8)
            return self

    monkeypatch.setattr("rna_work.pool._NO_ROOM", 0.1)
    monkeypatch.setattr("rna_work.pool._LOOK", 0.05)
    messages: list[str] = []
    with Pool(Threads(1), Late, tell=messages.append) as pool:
        assert [o.value() for o in pool.run([1, 2])] == [2, 4]
    assert len(messages) == 1 and "has started for" in messages[0]


def test_there_are_no_more_workers_than_items():
    with Pool(Processes(8), Doubling) as pool:
        pids = {o.value() for o in pool.run(["pid", "pid"])}
        assert len(pids) <= 2 and sum(pool.nodes().values()) <= 2


def test_processes_end_with_the_pool():
    start = time.monotonic()
    with Pool(Processes(2), Doubling) as pool:
        next(iter(pool.run([0.0, "hang"])))
    assert time.monotonic() - start < 20.0

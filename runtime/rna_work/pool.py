"""Gives items to workers as they become free, wherever they are, and takes care of failures."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Generator, Iterable, Iterator, Sized
from concurrent.futures import Future
from dataclasses import dataclass, field
from itertools import count
from math import inf
from queue import Empty, SimpleQueue
from time import monotonic
from typing import Any, Generic

from rna_sdk.errors import WorkError
from rna_work.backend import Backend, Slot
from rna_work.timeouts import Timeouts, Watch
from rna_work.workers import Item, MakeWorker, Outcome, Result, TimedOut, WorkerLost

_FAILED_STARTS = 3  # one after the other, for what a worker itself raises
_NO_ROOM = 60.0  # seconds
_LOOK = 1.0  # seconds between looks at time limits and at the room for workers


@dataclass(eq=False)
class _Job:
    """An item that is not finished."""

    number: int
    item: Any
    errors: int = 0
    losses: int = 0


@dataclass(eq=False)
class _Member:
    """A slot and its items, oldest first."""

    slot: Slot
    node: str = ""
    jobs: deque[_Job] = field(default_factory=deque)
    watch: Watch = field(default_factory=lambda: Watch(0.0, None))  # of its first job


class Pool(Generic[Item, Result]):
    """Workers of one kind; a context, at whose end they are closed.

    make: makes each worker. attempts: how often an item is run that fails; each further time on a
    fresh worker. ahead: items that a worker has waiting beside the one that it runs. timeouts: time
    limits; None for none. tell: gets a line for each item that is run again.
    """

    def __init__(
        self,
        backend: Backend,
        make: MakeWorker,
        attempts: int = 1,
        ahead: int = 0,
        timeouts: Timeouts | None = None,
        tell: Callable[[str], None] = lambda line: None,
    ) -> None:
        self._backend, self._make = backend, make
        self._attempts, self._most, self._timeouts = attempts, 1 + ahead, timeouts
        self._tell_user = tell
        self._names = count()
        self._events: SimpleQueue[tuple[_Member, _Job | None, Future[Any]]] = SimpleQueue()
        self._starting: set[_Member] = set()
        self._ready: dict[_Member, None] = {}  # in order of their starts
        self._failed_starts = 0
        self._looked = -inf
        self._room = 0
        self._without = monotonic()  # since when there is no worker and no room
        self._unready: float | None = monotonic()  # since when no worker is ready; None once told

    def __enter__(self) -> Pool[Item, Result]:
        return self

    def __exit__(self, *_: object) -> None:
        for member in [*self._starting, *self._ready]:
            member.slot.close(kill=member in self._starting)
        self._starting.clear()
        self._ready.clear()

    def nodes(self) -> Counter[str]:
        """Number of workers by node."""
        return Counter(member.node for member in self._ready)

    def run(
        self, items: Iterable[Item], ordered: bool = False
    ) -> Generator[Outcome[Item, Result], None, None]:
        """The outcome of every item, as they are finished or in the order of the items.

        Items are taken when a worker is free for them. Raises what kept workers from starting.
        """
        feed = _Feed(items)
        try:
            yield from self._run(feed, ordered)
        finally:  # of a run that was left early
            for member in [m for m in self._ready if m.jobs]:
                self._give_up(member, feed)

    def _run(self, feed: _Feed, ordered: bool) -> Iterator[Outcome[Item, Result]]:
        held: dict[int, Outcome[Item, Result]] = {}
        following = count()
        wanted = next(following)
        while True:
            self._fill(feed, wanted + self._window() if ordered else None)
            if not self._under_way() and feed.is_empty():
                return
            for number, outcome in self._next_outcomes(feed):
                if not ordered:
                    yield outcome
                    continue
                held[number] = outcome
                while wanted in held:
                    yield held.pop(wanted)
                    wanted = next(following)

    def _window(self) -> int:
        """Maximum distance of ordered results behind the last item; bounds how many are held."""
        return self._most * max(1, len(self._ready))

    def _under_way(self) -> bool:
        return any(member.jobs for member in self._ready)

    def _fill(self, feed: _Feed, end: int | None) -> None:
        """Start workers there is room for, and give items to the free ones, evenly.

        end: number of the first item that is not to be given yet.
        """
        self._hire(feed)
        for depth in range(1, self._most + 1):
            for member in list(self._ready):
                while len(member.jobs) < depth:
                    job = feed.take(end)
                    if job is None:
                        return
                    self._give(member, job)

    def _give(self, member: _Member, job: _Job) -> None:
        if not member.jobs:
            member.watch = self._watch(member)
        member.jobs.append(job)
        self._tell(member, job, member.slot.give(job.item))

    def _watch(self, member: _Member) -> Watch:
        """From now on."""
        return Watch(monotonic(), member.slot.processor_seconds() if self._timeouts else None)

    def _tell(self, member: _Member, job: _Job | None, future: Future[Any]) -> None:
        """Have its end put among the events; job: None where it is the member's start."""
        future.add_done_callback(lambda done: self._events.put((member, job, done)))

    def _hire(self, feed: _Feed) -> None:
        if monotonic() - self._looked >= _LOOK:
            self._room, self._looked = self._backend.width(), monotonic()
        idle = sum(not member.jobs for member in self._ready)
        new = self._room - len(self._starting) - len(self._ready)
        for _ in range(int(min(new, feed.most_left() - idle - len(self._starting)))):
            member = _Member(self._backend.slot(self._make, str(next(self._names))))
            self._starting.add(member)
            self._tell(member, None, member.slot.ready)

    def _next_outcomes(self, feed: _Feed) -> list[tuple[int, Outcome[Item, Result]]]:
        """Outcomes of the next event; empty if it is of another kind, or on timeout."""
        try:
            member, job, future = self._events.get(timeout=_LOOK)
        except Empty:
            self._wait_for_room()
            return self._out_of_time(feed)
        if member in self._starting:
            self._started(member, future)
            return []
        if job is None or member not in self._ready:
            return []  # of a worker that was given up
        outcome = self._finished(member, job, future, feed)
        late = self._out_of_time(feed) if monotonic() - self._looked >= _LOOK else []
        return late if outcome is None else [outcome, *late]

    def _wait_for_room(self) -> None:
        """Raises WorkError where there has been no worker and no room for one for a minute.

        Tells where there is said to be room and none has started: a cluster may grow for it.
        """
        if self._ready or (self._starting and self._room):
            self._without = monotonic()
        if self._ready:
            self._unready = monotonic()
        elif self._starting and self._room:
            if self._unready is not None and monotonic() - self._unready > _NO_ROOM:
                self._tell_user(f"no worker ({self._backend}) has started for {_NO_ROOM:.0f} s")
                self._unready = None
        elif monotonic() - self._without > _NO_ROOM:
            raise WorkError(
                f"no node had resources for a worker ({self._backend}) for {_NO_ROOM:.0f} s"
            )

    def _started(self, member: _Member, future: Future[Any]) -> None:
        self._starting.remove(member)
        failure = future.exception()
        if failure is None:
            member.node = future.result()
            self._ready[member] = None
            self._failed_starts = 0
            return
        member.slot.close(kill=True)
        self._failed_starts += 1
        lost = isinstance(failure, WorkerLost)
        if self._failed_starts >= min(self._backend.losses, inf if lost else _FAILED_STARTS):
            raise failure

    def _finished(
        self, member: _Member, job: _Job, future: Future[Any], feed: _Feed
    ) -> tuple[int, Outcome[Item, Result]] | None:
        failure = future.exception()
        if failure is not None and not isinstance(failure, Exception):
            raise failure
        member.jobs.remove(job)  # not always the first: a cluster may tell of a later one before
        begun, member.watch = member.watch, self._watch(member)
        seconds = member.watch.since - begun.since
        if failure is None:
            if self._timeouts is not None:
                self._timeouts.learn(job.item, seconds, begun.used(member.watch.processor))
            return job.number, self._outcome(member, job, seconds, future.result(), None)
        if isinstance(failure, WorkerLost):
            again = self._after_loss(member, job, feed)
        else:
            job.errors += 1
            again = job.errors < self._attempts
            if again:
                self._give_up(member, feed)
        if again:
            self._run_again(member, job, failure, feed)
            return None
        return job.number, self._outcome(member, job, seconds, None, failure)

    def _after_loss(self, member: _Member, job: _Job, feed: _Feed) -> bool:
        self._give_up(member, feed)
        job.losses += 1
        return job.losses < self._backend.losses

    def _out_of_time(self, feed: _Feed) -> list[tuple[int, Outcome[Item, Result]]]:
        """End workers that hang; returns outcomes of items without retries."""
        if self._timeouts is None:
            return []
        result = []
        for member in [m for m in self._ready if m.jobs]:
            seconds = monotonic() - member.watch.since
            if seconds <= self._timeouts.least:
                continue
            fault = member.watch.fault(
                timeouts=self._timeouts,
                item=member.jobs[0].item,
                now=monotonic(),
                processor=member.slot.processor_seconds(),
            )
            if not fault:
                continue
            job = member.jobs.popleft()
            self._give_up(member, feed)
            job.errors += 1
            failure = TimedOut(fault)
            if job.errors < self._attempts:
                self._run_again(member, job, failure, feed)
                continue
            result.append((job.number, self._outcome(member, job, seconds, None, failure)))
        return result

    def _run_again(self, member: _Member, job: _Job, failure: Exception, feed: _Feed) -> None:
        feed.put_back([job])
        who = f"worker {member.slot.name} on {member.node}"
        self._tell_user(f"{job.item} runs again; {who}: {failure}")

    def _give_up(self, member: _Member, feed: _Feed) -> None:
        """Drop a worker; its unstarted items go to others."""
        del self._ready[member]
        feed.put_back(member.jobs)
        member.jobs.clear()
        member.slot.close(kill=True)
        self._looked = -inf

    def _outcome(
        self, member: _Member, job: _Job, seconds: float, result: Any, failure: Exception | None
    ) -> Outcome[Item, Result]:
        return Outcome(job.item, result, failure, member.slot.name, member.node, seconds)


class _Feed:
    """Unassigned items: first returned ones, then new ones."""

    def __init__(self, items: Iterable[Any]) -> None:
        self._new = iter(items)
        self._total = len(items) if isinstance(items, Sized) else None
        self._back: deque[_Job] = deque()
        self._taken = 0
        self._ended = False

    def take(self, end: int | None) -> _Job | None:
        """The next one; None if there is none, or none before number `end`."""
        if self._back:
            return self._back.popleft()
        if self._ended or (end is not None and self._taken >= end):
            return None
        for item in self._new:
            self._taken += 1
            return _Job(self._taken - 1, item)
        self._ended = True
        return None

    def put_back(self, jobs: Iterable[_Job]) -> None:
        self._back.extend(jobs)

    def is_empty(self) -> bool:
        """Whether it is known that nothing is left."""
        return self.most_left() == 0

    def most_left(self) -> float:
        """Upper bound of the remaining items."""
        new = inf if self._total is None else self._total - self._taken
        return len(self._back) + (0 if self._ended else new)

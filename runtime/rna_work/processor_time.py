"""Processor time of threads and processes, as Linux reports it in /proc."""

import os
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

_PROC = Path("/proc")


@dataclass(frozen=True)
class _Times:
    parent: int
    process_itself: float  # s
    of_ended_children: float  # s
    threads: int


def thread_seconds(thread: int | None) -> float | None:
    """Processor time of a thread of this process, s; None where the system does not tell.

    thread: its `native_id`.
    """
    times = _times(_PROC / "self" / "task" / str(thread))
    return None if times is None else times.process_itself


def process_seconds(process: int | None) -> float | None:
    """Processor time of a process and of all it has started, s; None where the system has none.

    process: its identifier.
    """
    processes = _tree(process)
    return (
        sum(times.process_itself + times.of_ended_children for times in processes.values())
        if processes
        else None
    )


def process_threads(process: int) -> int:
    """Number of threads of a process and of all it has started; 0 where the system reports none."""
    return sum(times.threads for times in _tree(process).values())


def _tree(process: int | None) -> dict[int | None, _Times]:
    """Times of a process and of its descendants, by their identifiers."""
    first = _times(_PROC / str(process))
    if first is None:
        return {}
    children = defaultdict(list)
    for entry in os.listdir(_PROC):
        if entry.isdigit() and (times := _times(_PROC / entry)) is not None:
            children[times.parent].append((int(entry), times))
    processes: dict[int | None, _Times] = {}
    pending: list[tuple[int | None, _Times]] = [(process, first)]
    while pending:
        number, times = pending.pop()
        processes[number] = times
        pending += children[number or 0]
    return processes


def _times(folder: Path) -> _Times | None:
    """proc(5), /proc/pid/stat: the fields after the name, which may hold spaces and brackets."""
    try:
        fields = (folder / "stat").read_text(errors="replace").rpartition(")")[2].split()
        ticks = os.sysconf("SC_CLK_TCK")
        self_time, ended = (sum(map(int, fields[k : k + 2])) / ticks for k in (11, 13))
        return _Times(int(fields[1]), self_time, ended, int(fields[17]))
    except (OSError, ValueError, IndexError):
        return None  # it has ended, or the system has no such files

"""Processor time of threads and processes, as Linux tells it in /proc."""

from __future__ import annotations

import os
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

_PROC = Path("/proc")


@dataclass(frozen=True)
class _Times:
    parent: int
    own: float  # s
    of_ended_children: float  # s
    threads: int


def thread_seconds(thread: int | None) -> float | None:
    """Processor time of a thread of this process, s; None where the system does not tell.

    thread: its `native_id`.
    """
    found = _times(_PROC / "self" / "task" / str(thread))
    return None if found is None else found.own


def process_seconds(process: int | None) -> float | None:
    """Processor time of a process and of all it has started, s; None where the system has none.

    process: its identifier.
    """
    found = _tree(process)
    return sum(times.own + times.of_ended_children for times in found.values()) if found else None


def process_threads(process: int) -> int:
    """Number of threads of a process and of all it has started; 0 where the system tells none."""
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
    found: dict[int | None, _Times] = {}
    pending: list[tuple[int | None, _Times]] = [(process, first)]
    while pending:
        number, times = pending.pop()
        found[number] = times
        pending += children[number or 0]
    return found


def _times(folder: Path) -> _Times | None:
    """proc(5), /proc/pid/stat: the fields after the name, which may hold spaces and brackets."""
    try:
        fields = (folder / "stat").read_text(errors="replace").rpartition(")")[2].split()
        ticks = os.sysconf("SC_CLK_TCK")
        own, ended = (sum(map(int, fields[k : k + 2])) / ticks for k in (11, 13))
        return _Times(int(fields[1]), own, ended, int(fields[17]))
    except (OSError, ValueError, IndexError):
        return None  # it has ended, or the system has no such files

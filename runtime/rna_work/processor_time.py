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
    first = _times(_PROC / str(process))
    if first is None:
        return None
    children = defaultdict(list)
    for entry in os.listdir(_PROC):
        if entry.isdigit() and (found := _times(_PROC / entry)) is not None:
            children[found.parent].append((int(entry), found))
    total, pending = 0.0, [(process, first)]
    while pending:
        number, found = pending.pop()
        total += found.own + found.of_ended_children
        pending += children[number or 0]
    return total


def _times(folder: Path) -> _Times | None:
    """proc(5), /proc/pid/stat: the fields after the name, which may hold spaces and brackets."""
    try:
        fields = (folder / "stat").read_text(errors="replace").rpartition(")")[2].split()
        ticks = os.sysconf("SC_CLK_TCK")
        own, ended = (sum(map(int, fields[k : k + 2])) / ticks for k in (11, 13))
        return _Times(int(fields[1]), own, ended)
    except (OSError, ValueError, IndexError):
        return None  # it has ended, or the system has no such files

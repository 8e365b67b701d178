"""CPU time of a render by kernel: decoder, queries, rays; what is left is the rest."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from typing import Any
from unittest.mock import patch

import numpy as np

from rna_sdk.runtime.engine.decoder_sessions import Decoder
from rna_sdk.runtime.engine.tiles import QueryFiller
from rna_trace.embree import kernels as embree_kernels

KERNELS = ("decoder", "queries", "rays", "rest")

_PLACES: tuple[tuple[str, Any, str], ...] = (
    ("decoder", Decoder, "run"),
    ("queries", QueryFiller, "fill"),
    ("rays", embree_kernels, "intersect"),
    ("rays", embree_kernels, "occluded"),
    ("rays", embree_kernels, "transmitted"),
    ("rays", embree_kernels, "intersect_through"),
)
"""Kernel, and where the renderer calls it by name."""


@dataclass
class KernelTimes:
    """CPU time of a render by kernel; complete when the `with` statement is left.

    seconds: CPU seconds of all threads, by KERNELS. rows: queries and rays that were handed over.
    """

    seconds: dict[str, float] = field(default_factory=dict)
    rows: dict[str, int] = field(default_factory=dict)

    @property
    def total(self) -> float:
        """CPU seconds."""
        return sum(self.seconds.values())

    def as_json(self) -> dict[str, Any]:
        """Seconds by kernel, and ns per row where rows are counted."""
        ns = {k: 1e9 * self.seconds[k] / n for k, n in self.rows.items() if n}
        return {
            "cpu_seconds": {k: round(self.seconds[k], 4) for k in KERNELS},
            "rows": self.rows,
            "ns_a_row": {k: round(value, 1) for k, value in ns.items()},
        }


@contextmanager
def kernel_times() -> Iterator[KernelTimes]:
    """Times everything that is rendered meanwhile in this process, on any number of threads."""
    calls: list[tuple[str, float, int]] = []  # appending is safe from several threads
    times = KernelTimes()
    with ExitStack() as patches:
        for kernel, owner, name in _PLACES:
            called = _timed(kernel, getattr(owner, name), calls)
            patches.enter_context(patch.object(owner, name, called))
        begun = time.process_time()
        yield times
        total = time.process_time() - begun
    for kernel in KERNELS[:-1]:
        of_kernel = [call for call in calls if call[0] == kernel]
        times.seconds[kernel] = sum(seconds for _, seconds, _ in of_kernel)
        times.rows[kernel] = sum(rows for *_, rows in of_kernel)
    times.seconds["rest"] = max(total - times.total, 0.0)


def _timed(
    kernel: str, function: Callable[..., Any], calls: list[tuple[str, float, int]]
) -> Callable[..., Any]:
    def called(*arguments: Any, **named: Any) -> Any:
        begun = time.thread_time()
        result = function(*arguments, **named)
        calls.append((kernel, time.thread_time() - begun, _rows(arguments)))
        return result

    return called


def _rows(arguments: tuple[Any, ...]) -> int:
    """Rows of the longest array in the arguments: queries or rays."""
    parts = (part for a in arguments for part in (a if isinstance(a, tuple) else (a,)))
    return max((len(a) for a in parts if isinstance(a, np.ndarray) and a.ndim == 2), default=0)

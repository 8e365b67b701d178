"""Compilation of kernels before a first render: its progress is shown, and it runs in parallel."""

import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from rna_render.command.compile_ahead import compiling_ahead
from rna_sdk.machine.compiled import watched_compilations
from rna_sdk.machine.cores import core_count

_APART = 1.0  # s between lines that replace one another
_WORTH_TELLING = 3  # kernels: fewer take no more than a second or two


@contextmanager
def compilations_reported(scene: Path) -> Iterator[None]:
    """A context whose compilations are counted on standard error.

    On a terminal the count is renewed in place, else told once. At the end comes the time that
    they took. Where there is a second core, `compile_ahead` helps from the first kernel on.
    scene: the file that is rendered.
    """
    count, begun, last, reported = 0, 0.0, 0.0, 0.0
    is_terminal = sys.stderr.isatty()

    def watch(is_compiled: bool) -> None:
        nonlocal count, begun, last, reported
        now = last = time.monotonic()
        if not begun and core_count() > 1:
            ahead.enter_context(compiling_ahead(scene))
        begun, count = begun or now, count + is_compiled
        if count >= _WORTH_TELLING and (is_terminal or not reported) and now - reported > _APART:
            reported = now
            start, end = ("\r", "") if is_terminal else ("", "\n")
            print(f"{start}compiling kernels, once: {count}", end=end, file=sys.stderr, flush=True)

    with ExitStack() as ahead, watched_compilations(watch):
        yield
    if reported:
        seconds = f"{last - begun:.0f} s"
        print(f"compiled {count} kernels in {seconds}; the next start finds them", file=sys.stderr)

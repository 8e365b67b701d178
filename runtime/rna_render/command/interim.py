"""The picture so far, written while it is rendered, for programs that show it."""

from __future__ import annotations

import time
from collections.abc import Callable

from rna_render.image.film import Film


class Interim:
    """Hands a film on after a sample, if enough time has passed since it did so last.

    seconds: from the end of one writing to the next, the first being after the first sample; None
    for no writing. write: is given the film.
    """

    def __init__(self, seconds: float | None, write: Callable[[Film], None]) -> None:
        self._seconds, self._write = seconds, write
        self._next = 0.0

    def __call__(self, film: Film) -> None:
        if self._seconds is not None and time.monotonic() >= self._next:
            self._write(film)
            self._next = time.monotonic() + self._seconds

"""Progress bars on a terminal; in a pipe or a log, lines."""

import sys
from time import monotonic
from typing import Any

from tqdm import tqdm

_APART = 10.0  # seconds between lines
_DRAWN = "|{bar}|"
_LINE = (
    "{desc}: {percentage:3.0f}%| {n_fmt}/{total_fmt} [{elapsed}<{remaining}, {rate_fmt}{postfix}]"
)


class Bar(tqdm):  # type: ignore[misc]
    """A bar of tqdm; where standard error is no terminal, a line every ten seconds.

    A line, too, when a described stage begins, and at the end of a bar that stays.
    """

    def __init__(self, *iterable: Any, **options: Any) -> None:
        self._is_drawn = sys.stderr.isatty()
        self._next = monotonic() + _APART
        if not self._is_drawn and options.get("total"):
            options["bar_format"] = options.get("bar_format", _LINE).replace(_DRAWN, "|")
        super().__init__(*iterable, **options)

    def display(self, msg: str | None = None, pos: int | None = None) -> Any:
        """As tqdm's; a line only when it is due."""
        if self._is_drawn:
            return super().display(msg, pos)
        if monotonic() >= self._next:
            self._next = monotonic() + _APART
            self._write_line()
        return True

    def clear(self, *arguments: Any, **options: Any) -> None:
        """As tqdm's; a line stays."""
        if self._is_drawn:
            super().clear(*arguments, **options)

    def set_description_str(self, desc: str | None = None, refresh: bool = True) -> None:
        """As tqdm's: the next stage begins."""
        self._next = 0.0
        super().set_description_str(desc, refresh)

    def close(self) -> None:
        """As tqdm's."""
        if not self._is_drawn and not self.disable:
            if self.leave:
                self._write_line()
            self.sp = None  # so that tqdm writes no end of its own
        super().close()

    def _write_line(self) -> None:
        self.fp.write(f"{self}\n")
        self.fp.flush()

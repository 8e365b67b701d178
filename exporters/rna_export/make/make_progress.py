"""One progress bar for captures and trainings."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from tqdm import tqdm

from rna_work.bar import Bar

_FORMAT = "{desc}: {percentage:3.0f}%|{bar}| {elapsed}{left}{postfix}"
_UNITS = 1000  # of the bar for a stage of weight 1


_ENOUGH = 0.02  # of a stage, to tell from how long the rest takes


@dataclass
class Clock:
    """Time of a make, over all its runs.

    spent: seconds so far. limit: seconds in all; None for no limit. stage: when the stage began.
    """

    spent: Callable[[], float]
    limit: float | None = None
    stage: float = 0.0

    def left(self, done: float) -> str:
        """Time left, in words: of the limit, or of a stage of which a share is done."""
        now = self.spent()
        if self.limit is not None:
            over = now - self.limit
            return f", {_in_words(-over)} left" if over < 0.0 else f", {_in_words(over)} over time"
        if done < _ENOUGH:
            return ""
        return f", {_in_words((now - self.stage) * (1.0 - done) / done)} left of this step"


def _in_words(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min"


class _Bar(Bar):
    """A bar with the time of a clock, and the time left."""

    def __init__(self, clock: Clock, **options: Any):
        self.clock = clock
        self._begun, self._units = 0.0, 1.0  # of the stage
        super().__init__(**options)

    def begin_stage(self, units: float) -> float:
        """A stage of so many units begins here; returns how many there were before."""
        self._begun, self._units = self.n, units
        self.clock.stage = self.clock.spent()
        return self._begun

    @property
    def format_dict(self) -> dict[str, Any]:
        done = (self.n - self._begun) / self._units
        shown: dict[str, Any] = super().format_dict
        return {**shown, "elapsed": self.clock.spent(), "left": self.clock.left(done)}


class Progress:
    """The bar of a whole make; its stages fill it, each by its weight.

    weight: of all stages that are known. done: of those that an earlier run has finished.
    """

    def __init__(self, weight: float, clock: Clock, done: float = 0.0):
        self._bar = _Bar(
            clock,
            total=_UNITS * weight,
            initial=_UNITS * done,
            bar_format=_FORMAT,
            desc="rna-make",
            mininterval=0.5,
        )

    def more(self, weight: float) -> None:
        """Adds the weight of stages that were not known before."""
        self._bar.total += _UNITS * weight

    def stage(self, label: str, weight: float) -> Stage:
        """A stage begins; the ones before it are done."""
        self._bar.set_description_str(label)
        return Stage(self._bar, _UNITS * weight, self._bar.begin_stage(_UNITS * weight))

    def say(self, line: str) -> None:
        """A line above the bar."""
        self._bar.write(line)

    def close(self) -> None:
        """Closes the bar."""
        self._bar.close()


class Stage:
    """A share of the bar, filled by one bar after another, as `tqdm` would show them alone."""

    def __init__(self, bar: tqdm, units: float, begun: float):
        self._bar, self._units, self._begun = bar, units, begun

    def part(self, first: float, share: float) -> Callable[..., _Part]:
        """Makes bars that fill the share from `first` on, both of the stage."""
        begun, units = self._begun + first * self._units, share * self._units
        return lambda **options: _Part(self._bar, begun, units, **options)

    def done(self) -> None:
        """The whole of the share is full."""
        _fill(self._bar, self._begun + self._units)


class _Part:
    """The subset of `tqdm`'s interface that captures and trainings use."""

    def __init__(self, bar: tqdm, begun: float, units: float, **options: Any):
        self._bar, self._begun, self._units = bar, begun, units
        self.total: float = options["total"]
        self._n: float = options.get("initial", 0)

    def __enter__(self) -> _Part:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """The share is full, whatever is left of the total."""
        _fill(self._bar, self._begun + self._units)

    def write(self, line: str) -> None:
        """A line above the bar."""
        self._bar.write(line)

    def update(self, n: float = 1) -> None:
        """n more of the total are done."""
        self._n += n
        _fill(self._bar, self._begun + self._units * min(self._n / self.total, 1.0))

    def set_postfix(self, **shown: str) -> None:
        """Behind the bar."""
        self._bar.set_postfix(refresh=False, **shown)

    def set_postfix_str(self, shown: str, refresh: bool = True) -> None:
        """Text after the bar."""
        self._bar.set_postfix_str(shown, refresh)


def _fill(bar: tqdm, n: float) -> None:
    bar.update(max(min(n, bar.total) - bar.n, 0.0))


def quiet(_: str) -> None:
    """Says nothing, where the bar tells enough."""

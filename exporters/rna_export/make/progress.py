"""One progress bar for captures and trainings."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tqdm import tqdm

_FORMAT = "{desc}: {percentage:3.0f}%|{bar}| {elapsed}{postfix}"
_UNITS = 1000  # of the bar for a stage of weight 1


class Progress:
    """The bar of a whole make; its stages fill it, each by its weight.

    weight: of all stages that are known.
    """

    def __init__(self, weight: float):
        self._bar = tqdm(
            total=_UNITS * weight, bar_format=_FORMAT, desc="rna-make", mininterval=0.5
        )
        self._begun = 0.0  # where the stage began

    def more(self, weight: float) -> None:
        """Adds the weight of stages that were not known before."""
        self._bar.total += _UNITS * weight

    def stage(self, label: str, weight: float) -> Stage:
        """A stage begins; the ones before it are done."""
        self._bar.set_description_str(label)
        self._begun = self._bar.n
        return Stage(self._bar, _UNITS * weight, self._begun)

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

"""How long an item may take: many times as long as its fellows, measured by their cost."""

from bisect import insort
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

_FEWEST = 3  # finished items, before which nothing is known
_FACTOR = 10.0
_REMEMBERED = 1001
_LEAST_USE = 0.005  # of a core: what a process with work gets however busy the machine is


@dataclass
class Timeouts:
    """Time limits from finished items.

    cost: of an item, in any unit. least: seconds that every item may take.
    """

    cost: Callable[[Any], float] = lambda item: 1.0
    least: float = 120.0
    _rates: list[float] = field(default_factory=list)  # seconds a unit of cost, sorted
    _processor_rates: list[float] = field(default_factory=list)  # the same of processor time

    def learn(self, item: Any, seconds: float, processor_seconds: float | None = None) -> None:
        """Record the time of a finished item; processor time if it is known."""
        for rates, taken in ((self._rates, seconds), (self._processor_rates, processor_seconds)):
            if taken is not None and len(rates) < _REMEMBERED:
                insort(rates, taken / max(self.cost(item), 1e-9))

    def limit(self, item: Any) -> float:
        """Seconds without progress after which an item counts as hanging."""
        return self._limit(self._rates, item)

    def processor_limit(self, item: Any) -> float:
        """Seconds of processor time after which an item counts as running in circles."""
        return self._limit(self._processor_rates, item)

    def _limit(self, rates: list[float], item: Any) -> float:
        if len(rates) < _FEWEST:
            return float("inf")
        return max(self.least, _FACTOR * rates[len(rates) // 2] * self.cost(item))


@dataclass
class Watch:
    """Watches a worker's item: an item that uses the processor is not hung, only slow.

    since: when the item began, s of any clock. processor: the worker's time on the processor then,
    s; None where it cannot be told, and the clock alone decides.
    """

    since: float
    processor: float | None
    _seen: tuple[float, float] | None = None  # time and processor time when it was last at work

    def used(self, processor: float | None) -> float | None:
        """Processor time of the item by now."""
        known = processor is not None and self.processor is not None
        return processor - self.processor if known else None  # type: ignore[operator]

    def fault(self, timeouts: Timeouts, item: Any, now: float, processor: float | None) -> str:
        """Why the item counts as hanging; empty where it does not."""
        seconds, limit = now - self.since, timeouts.limit(item)
        used, most = self.used(processor), timeouts.processor_limit(item)
        if used is None:
            reason = f"no result after {seconds:.0f} s, expected within {limit:.0f} s"
            return reason if seconds > limit else ""
        if used > most:
            return f"no result after {used:.0f} s of processor time, expected within {most:.0f} s"
        then, before = self._seen or (self.since, 0.0)
        if now - then <= limit:
            return ""
        if used - before >= _LEAST_USE * (now - then):
            self._seen = now, used
            return ""
        return (
            f"no result after {seconds:.0f} s, the last {now - then:.0f} s without use of the "
            "processor"
        )

"""How long an item may take: many times as long as its fellows, measured by their cost."""

from __future__ import annotations

from bisect import insort
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

_FEWEST = 3  # finished items, before which nothing is known
_FACTOR = 10.0
_REMEMBERED = 1001


@dataclass
class Patience:
    """Time limits from finished items.

    cost: of an item, in any unit. least: seconds that every item may take.
    """

    cost: Callable[[Any], float] = lambda item: 1.0
    least: float = 120.0
    _rates: list[float] = field(default_factory=list)  # seconds a unit of cost, sorted

    def learn(self, item: Any, seconds: float) -> None:
        """Record the duration of a finished item, in seconds."""
        if len(self._rates) < _REMEMBERED:
            insort(self._rates, seconds / max(self.cost(item), 1e-9))

    def limit(self, item: Any) -> float:
        """Seconds after which an item counts as hanging."""
        if len(self._rates) < _FEWEST:
            return float("inf")
        median = self._rates[len(self._rates) // 2]
        return max(self.least, _FACTOR * median * self.cost(item))

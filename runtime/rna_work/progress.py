"""One bar for all workers: rate and time left of the whole, places of work, failures."""

from collections.abc import Callable, Iterator
from typing import Any

from rna_work.bar import Bar
from rna_work.pool import Pool
from rna_work.workers import Outcome


class Progress:
    """A bar of items, by their cost; a context.

    bars: makes it, with the arguments of `tqdm`.
    """

    def __init__(
        self, total: float, unit: str, what: str, done: float = 0.0, bars: Callable[..., Any] = Bar
    ) -> None:
        scaled = {"unit_scale": total >= 1000, "smoothing": 0.05}
        self._is_spread = False  # over nodes, or was
        self._bar = bars(total=total, initial=done, unit=unit, desc=what, **scaled)

    def __enter__(self) -> "Progress":
        return self

    def __exit__(self, *_: object) -> None:
        self._bar.close()

    def tell(self, line: str) -> None:
        """Print a line above the bar."""
        self._bar.write(line)

    def of(
        self,
        pool: Pool[Any, Any],
        outcomes: Iterator[Outcome[Any, Any]],
        cost: Callable[[Any], float] = lambda item: 1.0,
    ) -> Iterator[Outcome[Any, Any]]:
        """The outcomes, while the bar follows them."""
        for outcome in outcomes:
            self.advance(pool.nodes(), cost(outcome.item) if outcome.failure is None else 0.0)
            yield outcome

    def advance(self, nodes: dict[str, int], cost: float = 1.0) -> None:
        """An item of a cost is finished. nodes: how many workers each has."""
        self._is_spread = self._is_spread or len(nodes) > 1
        if self._is_spread:
            self._bar.set_postfix_str(who(nodes), refresh=False)
        self._bar.update(cost)


def who(nodes: dict[str, int]) -> str:
    """Number of workers, and the nodes with the most."""
    named = sorted(nodes.items(), key=lambda pair: -pair[1])
    shown = ", ".join(f"{node}: {count}" for node, count in named[:3])
    more = f", and {len(named) - 3} more nodes" if len(named) > 3 else ""
    return f"{sum(nodes.values())} workers ({shown}{more})"

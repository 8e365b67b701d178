"""A case of the suite: its variation, measurement, threshold and chart."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from matplotlib.figure import FigureBase

if TYPE_CHECKING:
    from rna_bench.stability.fixtures import Fixtures

Row = dict[str, Any]
"""One measurement, as JSON has it."""


@dataclass(frozen=True)
class Verdict:
    """Whether a case's mark is met, and the figure that decides, in a few words."""

    passed: bool
    found: str


@dataclass(frozen=True)
class Case:
    """One way to fail.

    Attributes:
        name: on the command line, and of its files.
        title: of its chart.
        varies: what is varied, in a few words.
        mark: what it must reach.
        needs: what must have been given: "dataset", "package" (or a dataset to make one from),
            "source".
        kinds: of the given asset that the case is for.
        measure: the rows; all of the cost.
        judge: the verdict on rows.
        draw: the rows as a chart.
    """

    name: str
    title: str
    varies: str
    mark: str
    measure: Callable[[Fixtures], list[Row]]
    judge: Callable[[list[Row]], Verdict]
    draw: Callable[[FigureBase, list[Row]], None]
    needs: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ("surface", "fiber")


@dataclass(frozen=True)
class Result:
    """Result of a case: rows, or the reason why it was skipped."""

    case: Case
    rows: list[Row]
    skipped: str | None = None

    @property
    def verdict(self) -> Verdict | None:
        """None where it was skipped."""
        return None if self.skipped else self.case.judge(self.rows)

    @property
    def status(self) -> str:
        """One word for the table."""
        return "skipped" if self.verdict is None else ("pass" if self.verdict.passed else "fail")

    @property
    def found(self) -> str:
        """The decisive measurement, or the reason why the case was skipped."""
        return self.skipped or self.case.judge(self.rows).found

    @property
    def summary(self) -> str:
        """A line for the user."""
        return f"{self.case.name}: {self.status}, {self.found}"


def values(rows: list[Row], name: str, **where: Any) -> list[Any]:
    """Column `name` of the rows whose columns match `where`."""
    return [row[name] for row in rows if all(row[k] == v for k, v in where.items())]

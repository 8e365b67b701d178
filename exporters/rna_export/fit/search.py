"""Finds the cheapest candidate within an error, or the best within a cost, in rungs of training.

On the first rung every candidate is trained for a sixteenth of the steps; those that another beats
at its cost by far are dropped. On the second, a quarter, the search halves the range of costs that
may hold the answer: a candidate whose error, were it to fall on as fast as it did, would still miss
the limit, and not by mere luck, rules out all cheaper ones. On the last, the cheapest that is left
is trained to the end; the next dearer one where it fails.

After Karnin et al., "Almost Optimal Exploration in Multi-Armed Bandits", 2013 (successive
halving), but for the question: not the best of all, but the cheapest that suffices.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from math import ceil

from rna_export.fit.goal import Goal
from rna_export.trials.scores import ModelScores
from rna_export.trials.trial import Trial
from rna_sdk.errors import TrainingError


@dataclass
class Candidate:
    """A trial at one precision."""

    trial: Trial
    precision: str
    ns: float  # per query on all threads
    scores: dict[int, ModelScores] = field(default_factory=dict)  # by steps of training
    verdict: str = ""  # why it was chosen, or was not

    @property
    def name(self) -> str:
        return f"{self.trial.name} {self.precision}"

    def errors(self, goal: Goal) -> list[tuple[int, float]]:
        """Steps and errors in dB of the trainings so far, longer ones last."""
        return [(steps, goal.error_db(self.scores[steps])) for steps in sorted(self.scores)]

    def hoped_for(self, goal: Goal, steps: int) -> float:
        """The least error in dB that more training may lead to.

        A line through the last two errors over the logarithm of their steps: gains only shrink.
        Minus infinity while there are not two.
        """
        known = self.errors(goal)
        if known and known[-1][0] >= steps:
            return known[-1][1]
        if len(known) < 2:
            return float("-inf")
        (few, first), (many, last) = known[-2:]
        gain = max(0.0, first - last)
        return min(first, last) - gain * (_octaves(many, steps) / _octaves(few, many))


def _octaves(few: int, many: int) -> int:
    """Number of doublings from few to many steps, rounded down."""
    return max(1, (many // few).bit_length() - 1)


Train = Callable[[list[Candidate], int], None]
"""Trains candidates for so many steps and sets their scores; all precisions of their trials."""

FRACTIONS = (16, 4, 1)
"""Rungs: the steps of the last one over those of each."""

_TOLERANCE_DB = 1.0  # how far behind a cheaper one a candidate may be after the first rung
_LUCK_DB = 0.3  # by which trainings of one model differ; see docs/stability.md
_KEPT = 3  # of a rung's candidates, one of so many goes on where the cost is limited


def search(
    candidates: list[Candidate], goal: Goal, steps: int, train: Train, width: int
) -> Candidate:
    """The candidate to use, trained for `steps`; the verdicts of all say why.

    width: how many trainings run side by side. Raises `TrainingError` when no candidate is within
    the limit.
    """
    rungs = [max(1, steps // fraction) for fraction in FRACTIONS]
    if goal.limits_cost:
        return _best_within_cost(_affordable(candidates, goal), goal, rungs, train)
    tried = _until_one_suffices(candidates, goal, rungs[0], train, width)
    return _Range(tried, goal, rungs, train, width).cheapest()


def _until_one_suffices(
    candidates: list[Candidate], goal: Goal, steps: int, train: Train, width: int
) -> list[Candidate]:
    """Trains candidates on the first rung, cheapest first, until one meets the limit."""
    ordered = sorted(candidates, key=lambda c: c.ns)
    for k in range(0, len(ordered), width):
        train(ordered[k : k + width], steps)
        found = next((c for c in ordered[: k + width] if goal.met_by(c.scores[steps])), None)
        if found is None:
            continue
        for dearer in ordered[k + width :]:
            dearer.verdict = (
                f"dearer than {found.name}, which meets the limit after {steps:,} steps"
            )
        return ordered[: k + width]
    return ordered


class _Range:
    """The candidates that may be the answer, cheapest first."""

    def __init__(
        self,
        candidates: list[Candidate],
        goal: Goal,
        rungs: list[int],
        train: Train,
        width: int,
    ):
        self._goal, self._rungs, self._train, self._width = goal, rungs, train, width
        self._left = _near_front(candidates, goal, rungs[0])

    def cheapest(self) -> Candidate:
        low, high = 0, len(self._left)  # those before `low` miss; the one at `high` will do
        while low < high:
            probes = _spread(low, high, self._width)
            self._train([self._left[k] for k in probes], self._rungs[1])
            for k in probes:
                if self._misses(self._left[k]):
                    low = max(low, k + 1)
                else:
                    high = min(high, k)
        return self._first_that_holds(low)

    def _first_that_holds(self, low: int) -> Candidate:
        for k, candidate in enumerate(self._left):
            if k < low:
                if not candidate.verdict:
                    candidate.verdict = "cheaper than one that misses the limit"
                continue
            self._train([candidate], self._rungs[1])
            if self._misses(candidate):
                continue
            self._train([candidate], self._rungs[2])
            found = self._goal.error_db(candidate.scores[self._rungs[2]])
            if found <= self._goal.limit_db:
                candidate.verdict = "chosen: the cheapest that meets the limit"
                for dearer in self._left[k + 1 :]:
                    dearer.verdict = dearer.verdict or "dearer than the one chosen"
                return candidate
            candidate.verdict = f"trained to the end: {self._goal.shown(found)}"
        raise TrainingError(
            f"no model has a {self._goal}: the best found has "
            + self._goal.shown(min(e for c in self._left for _, e in c.errors(self._goal)))
        )

    def _misses(self, candidate: Candidate) -> bool:
        hoped = candidate.hoped_for(self._goal, self._rungs[2])
        if hoped <= self._goal.limit_db + _LUCK_DB:
            return False
        candidate.verdict = (
            f"misses the limit: {self._goal.shown(hoped)} at best, were its error to fall on as it "
            "fell between the rungs"
        )
        return True


def _near_front(candidates: list[Candidate], goal: Goal, steps: int) -> list[Candidate]:
    """Candidates that no cheaper one beats by more than the tolerance, cheapest first."""
    best, kept = float("inf"), []
    leader = None
    for candidate in sorted(candidates, key=lambda c: (c.ns, goal.error_db(c.scores[steps]))):
        error = goal.error_db(candidate.scores[steps])
        if leader is not None and error > best + _TOLERANCE_DB:
            candidate.verdict = f"{error - best:.1f} dB behind {leader.name}, which costs less"
            continue
        kept.append(candidate)
        if error < best:
            best, leader = error, candidate
    return kept


def _spread(low: int, high: int, width: int) -> list[int]:
    """Up to `width` places that part the range evenly."""
    count = min(width, high - low)
    return sorted({low + (high - low) * (k + 1) // (count + 1) for k in range(count)})


def _affordable(candidates: list[Candidate], goal: Goal) -> list[Candidate]:
    for candidate in candidates:
        if candidate.ns > goal.value:
            candidate.verdict = "costs more than the limit"
    left = [c for c in candidates if not c.verdict]
    if not left:
        cheapest = min(candidates, key=lambda c: c.ns)
        raise TrainingError(
            f"no model has a {goal}: the cheapest, {cheapest.name}, takes {cheapest.ns:.0f} ns"
        )
    return left


def _best_within_cost(
    left: list[Candidate], goal: Goal, rungs: list[int], train: Train
) -> Candidate:
    for rung, steps in enumerate(rungs):
        train(left, steps)
        left = sorted(left, key=lambda c: goal.error_db(c.scores[steps]))
        kept = 1 if rung == len(rungs) - 1 else ceil(len(left) / _KEPT)
        for candidate in left[kept:]:
            behind = goal.error_db(candidate.scores[steps]) - goal.error_db(left[0].scores[steps])
            candidate.verdict = f"{behind:.1f} dB behind {left[0].name} after {steps:,} steps"
        left = left[:kept]
    left[0].verdict = "chosen: the most accurate within the limit"
    return left[0]

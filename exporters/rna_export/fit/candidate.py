"""A candidate model of a fit, and its results so far."""

from __future__ import annotations

from dataclasses import dataclass, field

from rna_export.fit.goal import Goal
from rna_export.trials.scores import ModelScores
from rna_export.trials.trial import Trial


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

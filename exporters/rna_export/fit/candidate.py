"""A model that a fit may choose, and what is known of it so far."""

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
    ns: float  # a query on all threads
    scores: dict[int, ModelScores] = field(default_factory=dict)  # by steps of training
    verdict: str = ""  # why it was chosen, or was not

    @property
    def name(self) -> str:
        return f"{self.trial.name} {self.precision}"

    def errors(self, goal: Goal) -> list[tuple[int, float]]:
        """Steps and errors in dB of the trainings so far, longer ones last."""
        return [(steps, goal.error_db(self.scores[steps])) for steps in sorted(self.scores)]

    def hoped_for(self, goal: Goal, steps: int, share: float = 1.0) -> float:
        """The least error in dB that more training may lead to.

        A line through the last two errors over the logarithm of their steps: gains only shrink.
        share: how much of that gain to count on. Minus infinity while there are not two errors.
        """
        known = self.errors(goal)
        if known and known[-1][0] >= steps:
            return known[-1][1]
        if len(known) < 2:
            return float("-inf")
        before, last = known[-2:]
        return min(before[1], last[1]) - share * _promised(before, last, steps)

    def share_come_true(self, goal: Goal) -> float:
        """Of the gain that the line through the two trainings before the last promised for it.

        1 where they promised none, or there are not three.
        """
        known = self.errors(goal)
        if len(known) < 3:
            return 1.0
        before, between, (steps, error) = known[-3:]
        promised = _promised(before, between, steps)
        return max(0.0, between[1] - error) / promised if promised > 0.0 else 1.0


def _promised(before: tuple[int, float], last: tuple[int, float], steps: int) -> float:
    """How far an error falls on until `steps`, in dB, if as fast as between two trainings."""
    gain = max(0.0, before[1] - last[1])
    return gain * _octaves(last[0], steps) / _octaves(before[0], last[0])


def _octaves(few: int, many: int) -> int:
    """How often a number of steps doubles, about."""
    return max(1, (many // few).bit_length() - 1)

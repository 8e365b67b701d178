"""Stopping criterion: the goal is met, or the error has stopped falling."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

Verdict = Literal["goal met", "stopped falling", "time is up", "lights used up"]

LEAST_GAIN_DB = 0.3
"""By which the error has to fall over `ROUNDS` rounds, or it has stopped falling.

Trainings of one model differ by as much: see docs/stability.md.
"""
ROUNDS = 2
MARGIN_DB = 0.1  # that a package may lose against the model in training


def verdict(errors_db: Sequence[float], limit_db: float) -> Verdict | None:
    """Why to stop, by the validation errors of the rounds so far; None: go on.

    errors_db: as `Goal.error_db` has them, in order. limit_db: minus infinity without a goal.
    """
    if min(errors_db, default=float("inf")) <= limit_db - MARGIN_DB:
        return "goal met"
    if len(errors_db) <= ROUNDS:
        return None
    gain = min(errors_db[:-ROUNDS]) - min(errors_db)
    return "stopped falling" if gain < LEAST_GAIN_DB else None

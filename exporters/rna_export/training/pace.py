"""How far a run is, 0 to 1, of its steps or of its time: learning rates and blur follow it."""

from __future__ import annotations

from time import monotonic
from typing import Any

_MOST_A_STEP = 0.02


class StepPace:
    """A run of so many steps."""

    def __init__(self, steps: int):
        self.steps = steps

    def progress(self, step: int) -> float:
        """Before the step of this number."""
        return min(step / self.steps, 1.0)


class TimePace:
    """A run of so many seconds, whatever its steps take.

    All that happens between two steps counts, and time is kept for the validation at the end.
    Progress moves in proportion to the time that is left, so that it makes up for what came late;
    but by 2% a step at most: after a stall, as of a suspended machine, the rates still come down
    in steps.

    state: of a run that goes on.
    """

    def __init__(self, seconds: float, begun: float, state: dict[str, float] | None = None):
        """begun: as `monotonic` has it."""
        self._seconds, self._last = seconds, begun
        self._spent, self._progress, self._validation = 0.0, 0.0, 0.0
        if state is not None:
            self._spent, self._progress = state["spent"], state["progress"]
            self._validation = state["validation"]
        self._validation_began: float | None = None

    def progress(self, _step: int) -> float:
        """Now."""
        return self._progress

    def advance(self) -> None:
        """A step is done."""
        now = monotonic()
        took, self._last = now - self._last, now
        left = self._seconds - self._validation - self._spent
        share = took / left if took < left else 1.0
        self._progress += min((1.0 - self._progress) * share, _MOST_A_STEP)
        self._spent += took
        if self._progress > 1.0 - 1e-9:
            self._progress = 1.0

    def validation_begins(self) -> None:
        """What follows, to the next step, is as long as the validation at the end will be."""
        self._validation_began = monotonic()

    def step_begins(self) -> None:
        """A validation, if there was one, is over, with all that it wrote."""
        if self._validation_began is not None:
            self._validation = monotonic() - self._validation_began
            self._validation_began = None

    def state(self) -> dict[str, float]:
        """For a checkpoint."""
        spent = self._spent + monotonic() - self._last
        return {"spent": spent, "progress": self._progress, "validation": self._validation}


Pace = StepPace | TimePace


def length(minutes: float | None, steps: int) -> str:
    """What a run was asked to take."""
    return f"{steps} steps" if minutes is None else f"{minutes:g} minutes"


def resumed(minutes: float, begun: float, saved: dict[str, Any] | None) -> TimePace:
    """The pace of a run of so many minutes, continued from its checkpoint if there is one."""
    return TimePace(60.0 * minutes, begun, saved["pace"] if saved else None)

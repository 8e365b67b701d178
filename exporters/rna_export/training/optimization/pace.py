"""Progress of a run, 0 to 1, by steps or time; schedules learning rate and blur."""

from time import monotonic

_MOST_A_STEP = 0.02


class StepPace:
    """A run with a given number of steps, of which `done` are done."""

    def __init__(self, steps: int, done: int = 0):
        self._steps, self._done = steps, done

    @property
    def progress(self) -> float:
        """Now."""
        return min(self._done / self._steps, 1.0)

    def advance(self) -> None:
        """A step is done."""
        self._done += 1

    def validated(self) -> None:
        """A validation is done, with all that it wrote."""

    def state(self) -> dict[str, float]:
        """State for a checkpoint: none, since the number of steps suffices."""
        return {}


class TimePace:
    """A run of a given number of seconds, whatever its steps take.

    All that happens between two steps counts, and time is kept for the validation at the end.
    Progress moves in proportion to the time that is left, so that it makes up for what came late;
    but by 2% a step at most: after a stall (a suspended machine) the rates still come down in
    steps.

    begun: as `monotonic` has it. state: of a resumed run.
    """

    def __init__(self, seconds: float, begun: float, state: dict[str, float] | None = None):
        self._seconds, self._last = seconds, begun
        self._spent, self._progress, self._validation = 0.0, 0.0, 0.0
        if state:
            self._spent, self._progress = state["spent"], state["progress"]
            self._validation = state["validation"]

    @property
    def progress(self) -> float:
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

    def validated(self) -> None:
        """A validation is done: the one at the end may take as long as the longest so far."""
        self._validation = max(self._validation, monotonic() - self._last)

    def state(self) -> dict[str, float]:
        """State for a checkpoint."""
        spent = self._spent + monotonic() - self._last
        return {"spent": spent, "progress": self._progress, "validation": self._validation}


Pace = StepPace | TimePace


def length(minutes: float | None, steps: int) -> str:
    """The requested length of a run, as text."""
    return f"{steps} steps" if minutes is None else f"{minutes:g} minutes"

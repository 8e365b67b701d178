"""Size of each capture and training round, by goal or by time limit."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal

from pydantic import BaseModel

from rna_export.capture.time_plan import IMAGE_SHARE

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


_FIRST = 1 / 8  # of the usual lights, and of the preset's steps, in the first round
_STEPS_GROW = 1.5  # a round's, over those of the round before
_MORE = 0.5  # lights of a round over all before it, and at most over the usual ones

_TIMED_ROUNDS = 4
_SHORT_SECONDS, _SHORT_ROUNDS = 240.0, 2  # each start of Blender costs seconds
CAPTURE = 0.5
"""Share of the time for capture, all rounds together, if they end at an error."""
_MOST_CAPTURE = {"cpu": 0.75, "cuda": 0.85}
_TRAINING_SECONDS = {"cpu": 120.0, "cuda": 60.0}
"""Device -> of 64 neurons' width, after which more lights gain more."""
_BETWEEN = 0.15  # share for trainings between captures, if there are several
_SLACK = 1.3  # lights planned over those expected: the clock ends a capture, not the plan
_LEAST_CAPTURE = 0.3  # share of more minutes, after those of an earlier run
_SPARED = 0.5  # of a training, by one before it that it starts from
_EXPORT_SECONDS, _EXPORT_SHARE = 30.0, 0.05  # kept for the package, a tier: the lesser of both


def capture_share(seconds: float, widths: Sequence[int], device: str = "cpu") -> float:
    """Share of the time for capture in a single round: a half at least.

    seconds: in all. widths: neurons of a hidden layer, of each preset to train. device: of
    trainings.
    """
    training = _TRAINING_SECONDS[device] * sum(widths) / 64
    return min(max(1.0 - training / seconds, CAPTURE), _MOST_CAPTURE[device])


class Length(BaseModel, extra="forbid", frozen=True):
    """Length of a training: at most one of the two; with neither, the preset's steps."""

    steps: int | None = None
    minutes: float | None = None


@dataclass(frozen=True)
class OpenPlan:
    """Rounds that grow until the stop rule ends them.

    lights: that a capture usually has. shard: lights that are captured together. steps: of the
    preset.
    """

    lights: int
    shard: int
    steps: int
    rounds = None
    image_seconds = None

    def lights_of(self, round_: int, before: int) -> int:
        """Lights after a round, with `before` of the rounds before it."""
        more = _FIRST * self.lights if round_ == 0 else _MORE * min(before, self.lights)
        return in_shards(before + more, before, self.shard)

    def capture_seconds(self, round_: int, left: float) -> float | None:
        """Time limit of a round's capture: none."""

    def phase(self, round_: int, left: float) -> Length:
        """A round's training."""
        return Length(steps=round(min(1.0, _FIRST * _STEPS_GROW**round_) * self.steps))

    def last_phase(self, left: float, models: int) -> Length:
        """The full one of a model at the end."""
        return Length(steps=self.steps)


@dataclass(frozen=True)
class FixedPlan:
    """One capture of a fixed number of lights, then one training of each preset.

    steps: of the trainings; None: each preset's own.
    """

    lights: int
    steps: int | None
    rounds = 1
    image_seconds = None
    end: ClassVar[Verdict] = "lights used up"

    def lights_of(self, round_: int, before: int) -> int:
        """Lights after the only round: all."""
        return self.lights

    def capture_seconds(self, round_: int, left: float) -> float | None:
        """Time limit of the capture: none."""

    def phase(self, round_: int, left: float) -> Length | None:
        """No training between captures."""

    def last_phase(self, left: float, models: int) -> Length:
        """The last phase of a model."""
        return Length(steps=self.steps)


class _WithinTime:
    """The end of a plan that a time limits."""

    seconds: float
    tiers: int
    end: ClassVar[Verdict] = "time is up"

    def last_phase(self, left: float, models: int) -> Length:
        """Length of a model's last phase, with `models` left to train, itself included."""
        return _minutes(self._usable(left) / models)

    def _usable(self, left: float) -> float:
        return max(left - self.tiers * min(_EXPORT_SECONDS, _EXPORT_SHARE * self.seconds), 1.0)


@dataclass(frozen=True)
class TimedPlan(_WithinTime):
    """Rounds that fill a time: each stage gets its share of the time left.

    seconds: in all. lights: that fit into the share of it that is for capture. tiers: to export.
    has_goal: whether a round may end it earlier. capture: share of the time for capture. overlaps:
    whether the training after a capture goes on beside the next one.
    """

    lights: int
    shard: int
    seconds: float
    tiers: int = 1
    has_goal: bool = True
    capture: float = CAPTURE
    overlaps: bool = False

    @property
    def image_seconds(self) -> float:
        """Time limit of the validation images."""
        return IMAGE_SHARE * self.seconds

    @property
    def rounds(self) -> int:
        """Captures; after the last of them comes the last phase."""
        if not self.has_goal:
            return 1
        return _SHORT_ROUNDS if self.seconds < _SHORT_SECONDS else _TIMED_ROUNDS

    def lights_of(self, round_: int, before: int) -> int:
        """Lights after a round, more than there may be time for."""
        return in_shards(before + _SLACK * self.lights / self.rounds, before, self.shard)

    def capture_seconds(self, round_: int, left: float) -> float:
        """Time limit of a round's capture."""
        share = self.capture / self.rounds
        return self._usable(left) * share / self._ahead(round_)

    def phase(self, round_: int, left: float) -> Length | None:
        """A round's training; None after the last capture."""
        if round_ == self.rounds - 1:
            return None
        share = self._between / (self._ahead(round_) - self.capture / self.rounds)
        return _minutes(self._usable(left) * share)

    def _ahead(self, round_: int) -> float:
        """Shares of the stages from a round's capture on."""
        between = 0.0 if self.overlaps else self._between
        return 1.0 - round_ * (self.capture / self.rounds + between)

    @property
    def _between(self) -> float:
        """Share of the training after a capture that is not the last."""
        return 0.0 if self.rounds == 1 else _BETWEEN / (self.rounds - 1)


@dataclass(frozen=True)
class MorePlan(_WithinTime):
    """One more capture, then the last phase on all rays, within more minutes.

    seconds: more of them. captured: what earlier captures took. lights: that those had. before:
    rounds of them. share: of the whole time, for captures of a single run of that length.
    whole: seconds of such a run. tiers: to export.
    """

    shard: int
    seconds: float
    captured: float
    lights: int
    before: int
    share: float
    whole: float
    tiers: int = 1
    image_seconds = None

    @property
    def rounds(self) -> int:
        """All captures."""
        return self.before + 1

    def lights_of(self, round_: int, before: int) -> int:
        """Lights after the round, more than there may be time for."""
        rate = self.lights / max(self.captured, 1.0)
        return in_shards(before + _SLACK * rate * self.seconds, before, self.shard)

    def capture_seconds(self, round_: int, left: float) -> float:
        """Time limit of the capture.

        It leaves the last phase as much as in a single run, less what the old model spares it.
        """
        usable, spent = self._usable(left), self.whole - self.seconds
        spared = _SPARED * (spent - self.captured)
        wanted = usable - ((1.0 - self.share) * self.whole - spared)
        return min(max(wanted, _LEAST_CAPTURE * usable), self.share * usable)

    def phase(self, round_: int, left: float) -> Length | None:
        """No training between captures."""


Plan = OpenPlan | FixedPlan | TimedPlan | MorePlan


def in_shards(wanted: float, before: int, shard: int) -> int:
    """Lights in whole shards: about the wanted number, at least one shard more than before."""
    return max(round(wanted / shard) * shard, before + shard)


def _minutes(seconds: float) -> Length:
    # Rounded: a resumed run has exactly the same length.
    return Length(minutes=round(max(seconds, 0.6) / 60.0, 3))

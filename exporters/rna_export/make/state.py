"""`make.json`: settings and progress of an `rna-make` run."""

from __future__ import annotations

from pathlib import Path

from pydantic import BaseModel, ConfigDict, ValidationError

from rna_export.capture.dataset.dataset_manifest import what_is_wrong
from rna_export.make.plan import Length
from rna_sdk.atomic_file import write_atomically
from rna_sdk.errors import TrainingError

_NAME = "make.json"
WRITTEN = (_NAME, "rays", "runs", "scratch")
"""Names of all that a run, of this version or an earlier one, writes into its work folder."""


class RunSettings(BaseModel):
    """Settings that must match to resume a run; `settings` in the file."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    source: str
    source_sha256: str
    arguments: tuple[str, ...]
    settings: dict[str, int | float | str | bool | tuple[int, ...]]
    scene: str | None
    presets: tuple[str, ...]
    goal: str
    minutes: float | None
    steps: int | None
    seed: int


class Score(BaseModel):
    """Score over the validation images, all parts together; flip: of the asset's pixels."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    psnr: float
    flip: float


class Round(BaseModel):
    """A capture, and the training of the leading preset on all rays so far."""

    model_config = ConfigDict(extra="forbid")

    lights: int  # after it
    is_captured: bool = False
    phase: Length | None = None
    score: Score | None = None


class Last(BaseModel):
    """The last phase of a preset."""

    model_config = ConfigDict(extra="forbid")

    phase: Length
    score: Score | None = None


class State(BaseModel):
    """Progress of a run. `save` writes it into the work folder."""

    model_config = ConfigDict(extra="forbid")

    settings: RunSettings
    lights: int  # that the capture was planned with
    seconds: float = 0.0  # spent so far
    rounds: list[Round] = []
    last: dict[str, Last] = {}

    def save(self, work: Path) -> None:
        """The file is written atomically."""
        write_atomically(work / _NAME, (self.model_dump_json(indent=1) + "\n").encode())


def is_work_folder(folder: Path) -> bool:
    """Whether a run has begun there."""
    return (folder / _NAME).is_file()


def load_state(work: Path, settings: RunSettings) -> State | None:
    """The state in a work folder; None if no make has begun there.

    Raises `TrainingError` when it is damaged or belongs to a run with other settings.
    """
    path = work / _NAME
    if not path.is_file():
        return None
    try:
        state = State.model_validate_json(path.read_bytes())
    except ValidationError as error:
        raise TrainingError(
            f"{path}: {what_is_wrong(error)}; delete {work} to start over"
        ) from error
    for name in RunSettings.model_fields:
        begun, now = getattr(state.settings, name), getattr(settings, name)
        if begun != now:
            raise TrainingError(
                f"{work} was started with {name} {begun}, found {now}: delete it to start over, or "
                "choose another --work"
            )
    return state

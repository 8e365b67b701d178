"""`make.json`: settings and progress of an `rna-make` run."""

from pathlib import Path

from pydantic import BaseModel, ValidationError

from rna_export.capture.dataset.dataset_manifest import what_is_wrong
from rna_export.make.plan import Length
from rna_sdk.errors import TrainingError
from rna_sdk.files.atomic_file import write_atomically

_NAME = "make.json"
WRITTEN = (_NAME, "rays", "runs", "before", "scratch")
"""Names of all that a run writes into its work folder."""


class RunSettings(BaseModel, extra="forbid", frozen=True):
    """Settings that must match to resume a run; `settings` in the file."""

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


class Score(BaseModel, extra="forbid", frozen=True):
    """Score over the validation images, all parts together; flip: of the asset's pixels.

    without_noise: whether the images' noise does not count in psnr, as it never does in flip.
    """

    psnr: float
    flip: float
    without_noise: bool = False


class Round(BaseModel, extra="forbid"):
    """A capture, and the training of the leading preset on all rays so far."""

    lights: int  # after it
    is_captured: bool = False
    phase: Length | None = None
    score: Score | None = None


class Last(BaseModel, extra="forbid"):
    """The last phase of a preset."""

    phase: Length
    score: Score | None = None


class More(BaseModel, extra="forbid", frozen=True):
    """Minutes requested later, by `rna-make --more`.

    begun: seconds spent before them. rounds: that were captured before.
    """

    minutes: float
    begun: float
    rounds: int


class State(BaseModel, extra="forbid"):
    """Progress of a run. `save` writes it into the work folder.

    images: side, paths a pixel and number of the validation images that those of rounds are smaller
    than.
    before: scores of models that earlier minutes ended with, by preset; `before/PRESET` has them.
    starts: parts whose training starts from these models: only their material has changed.
    """

    settings: RunSettings
    lights: int  # that the capture was planned with
    seconds: float = 0.0  # spent so far
    capture_seconds: float = 0.0  # of them, for rounds of rays
    image_seconds: float = 0.0  # of them, for validation images
    image_paths: int = 0  # that these took
    images: tuple[int, ...] | None = None
    rounds: list[Round] = []
    last: dict[str, Last] = {}
    more: More | None = None
    before: dict[str, Score] = {}
    starts: tuple[str, ...] | None = None  # None: this is no update
    is_finished: bool = False

    def save(self, work: Path) -> None:
        """The file is written atomically."""
        write_atomically(work / _NAME, (self.model_dump_json(indent=1) + "\n").encode())


def read_state(work: Path) -> State | None:
    """The state in a work folder; None if no make has begun there.

    Raises `TrainingError` when it is damaged.
    """
    path = work / _NAME
    if not path.is_file():
        return None
    try:
        return State.model_validate_json(path.read_bytes())
    except ValidationError as error:
        raise TrainingError(
            f"{path}: {what_is_wrong(error)}; delete {work} to start over"
        ) from error


_FOR_NEW_RAYS = ("sharpest", "samples")
"""Settings of the capture that may change between rays of one dataset."""


_OF_RAYS = ("source", "source_sha256", "arguments", "settings", "scene")
"""Settings that rays depend on: more of them need the same."""


def check_same(
    state: State, requested: RunSettings, work: Path, for_more: bool
) -> dict[str, int | float]:
    """Settings of the capture that are new, for rays to come.

    for_more: whether rays and models of the run are gone on from, not the run itself. Raises
    `TrainingError` where the state belongs to a run with other settings.
    """
    begun = state.settings
    if begun.source == requested.source and begun.source_sha256 != requested.source_sha256:
        raise TrainingError(
            f"{begun.source} has changed since its rays were captured: --update captures it anew "
            f"and starts from the old model; or delete {work} to start over"
        )
    new = {}
    for name in _FOR_NEW_RAYS:
        value = requested.settings.get(name)
        if value is not None and value != begun.settings.get(name):
            assert isinstance(value, int | float)
            new[name] = value
    settings = {**requested.settings, **{k: begun.settings[k] for k in new if k in begun.settings}}
    for name in new.keys() - begun.settings.keys():
        settings.pop(name)
    for name in _OF_RAYS if for_more else RunSettings.model_fields:
        before = getattr(begun, name)
        now = settings if name == "settings" else getattr(requested, name)
        if before != now:
            raise TrainingError(
                f"{work} was started with {name} {before}, found {now}: delete it to start over, "
                "or choose another --work"
            )
    return new

"""The record of a finished trial: `record.json`."""

from pathlib import Path

from pydantic import BaseModel, Field

from rna_bench.frontier.trials.scores import ModelScores
from rna_bench.frontier.trials.trial import Trial
from rna_sdk.errors import TrainingError
from rna_sdk.files.atomic_file import write_atomically


class Point(BaseModel, extra="forbid", frozen=True):
    """A trained model at one precision."""

    bytes: int | None = Field(description="of a package with nothing else, geometry included")
    multiply_adds: int = Field(description="of the decoder per query")
    scores: ModelScores


class Record(BaseModel, extra="forbid", frozen=True):
    """A finished trial."""

    trial: Trial
    dataset_sha256: str = Field(description="of the dataset's source")
    device: str
    seconds: float = Field(description="of training: of all CPU threads together, or of the GPU")
    points: dict[str, Point] = Field(description="by precision of decoder and planes")
    curve: tuple[tuple[int, float], ...] = Field(
        (), description="steps done and PSNR in PyTorch, of each validation while it trained"
    )
    nearby: tuple[float, ...] = Field((), description="lengths of nearby light, metres")

    def write(self, folder: Path) -> None:
        """Write `record.json`; with it the trial is finished."""
        write_atomically(folder / "record.json", (self.model_dump_json(indent=1) + "\n").encode())


def read_record(folder: Path, trial: Trial, dataset_sha256: str) -> Record | None:
    """The record of a trial that was finished in this folder; None where it was not.

    Raises `TrainingError` when the folder belongs to another trial or dataset.
    """
    path = folder / "record.json"
    if not path.is_file():
        return None
    try:
        record = Record.model_validate_json(path.read_bytes())
    except ValueError as error:
        raise TrainingError(f"{path}: not the record of a trial: {error}") from error
    found, expected = (record.trial, record.dataset_sha256), (trial, dataset_sha256)
    if found != expected:
        raise TrainingError(f"{path}: belongs to another model or dataset: choose another --out")
    return record

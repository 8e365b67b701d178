"""Continues an earlier `rna-make`: more minutes, or a changed material."""

import shutil
from collections.abc import Sequence
from pathlib import Path

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.make.state import More, Score, State, read_state
from rna_export.training.part_runs import part_folder
from rna_sdk.errors import TrainingError

_BEFORE = "before"  # folder of models that earlier minutes ended with, and of their geometry
_GEOMETRY = "geometry"


def go_on(state: State, work: Path, minutes: float) -> None:
    """Begin more minutes; a run of them that was stopped goes on with its own."""
    if state.more is not None and not state.is_finished:
        return
    captured = [round_ for round_ in state.rounds if round_.is_captured]
    if not captured:
        raise TrainingError(
            f"{work}: no capture of it is finished: run the first command again, then --more"
        )
    for round_ in captured:
        round_.phase = round_.score = None
    state.more = More(minutes=minutes, begun=state.seconds, rounds=len(captured))
    state.rounds, state.last, state.is_finished = captured, {}, False
    shutil.rmtree(work / "runs", ignore_errors=True)
    state.save(work)


def begin_update(work: Path) -> None:
    """Take away the rays and the state of a finished make; its models and geometry stay.

    Raises `TrainingError` where there is none.
    """
    state = read_state(work)
    if state is None and (work / _BEFORE / _GEOMETRY).is_dir():
        return  # stopped before the new capture began
    if state is None or not state.is_finished:
        raise TrainingError(
            f"{work}: --update starts from the rays and models of a finished rna-make, found none"
        )
    before = work / _BEFORE / _GEOMETRY
    shutil.rmtree(before, ignore_errors=True)
    shutil.copytree(work / "rays" / "geometry", before)
    (work / "make.json").unlink()
    for name in ("rays", "runs"):
        shutil.rmtree(work / name, ignore_errors=True)


def same_parts(work: Path, dataset: Dataset) -> tuple[str, ...]:
    """Names of the parts with the same geometry as in the models before."""
    before = work / _BEFORE / _GEOMETRY
    return tuple(
        part.name
        for part in dataset.parts
        if (old := before / dataset.geometry_path(part.name).name).is_file()
        and old.read_bytes() == dataset.geometry_path(part.name).read_bytes()
    )


def before_folder(work: Path, preset: str) -> Path:
    """Folder of a preset's models that earlier minutes ended with."""
    return work / _BEFORE / preset


def starts_of(state: State, work: Path, preset: str, dataset: Dataset) -> dict[str, Path]:
    """Checkpoints of parts to start from: in an update, and with more minutes."""
    folder, names = before_folder(work, preset), state.starts or ()
    if state.more is not None:
        names = tuple(part.name for part in dataset.parts)
    paths = {name: part_folder(folder, dataset, name) / "best.ckpt" for name in names}
    return {part: path for part, path in paths.items() if path.is_file()}


def finish(state: State, work: Path, best: dict[str, tuple[Path, Score]]) -> None:
    """Keep the start of later runs: the rays, and the best model of each preset.

    best: folder and score by preset.
    """
    for preset, (folder, score) in best.items():
        before = before_folder(work, preset)
        if folder != before:
            shutil.rmtree(before, ignore_errors=True)
            shutil.copytree(folder, before, ignore=shutil.ignore_patterns("last.ckpt", "*.png"))
        state.before[preset] = score
    for path in (work / "runs").rglob("last.ckpt"):
        path.unlink()
    state.is_finished = True
    state.save(work)


def size_of(folders: Sequence[Path]) -> int:
    """Bytes of all files below the folders."""
    return sum(p.stat().st_size for folder in folders for p in folder.rglob("*") if p.is_file())

"""Continues an earlier `rna-make`: more minutes, or a changed material; omitted options stay."""

import argparse
import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.make.state import More, Score, State, read_state
from rna_export.training.part_runs import part_folder
from rna_sdk.errors import TrainingError

_BEFORE = "before"  # folder of models that earlier minutes ended with, and of their geometry
_GEOMETRY = "geometry"
_PRESETS = ("small",)
_UPDATE = 1 / 3  # of the time that was spent
_LEAST = 0.1  # minutes that are worth going on for


def go_on(state: State, work: Path, minutes: float) -> None:
    """Begin more minutes; a run of as many that was stopped goes on."""
    if state.more is not None and state.more.minutes == minutes and not state.is_finished:
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


@dataclass(frozen=True)
class CarriedOptions:
    """Options that a run takes over: see `MakeOptions`. settings: all except the given ones."""

    presets: tuple[str, ...]
    arguments: tuple[str, ...]
    settings: dict[str, Any]
    seed: int
    minutes: float | None
    more: float | None


def carried_options(
    args: argparse.Namespace, work: Path, arguments: tuple[str, ...], elsewhere: float = 0.0
) -> CarriedOptions:
    """The options of this command, with the options of the run that it continues.

    `--minutes` above those of the run there are more minutes for it. elsewhere: of the given
    minutes, those that are not for rays and models. Raises `TrainingError` for a damaged run, and
    where no time is left.
    """
    state, given = read_state(work), tuple(args.presets or ())
    total, more = (None if m is None else m - elsewhere for m in (args.minutes, args.more))
    if state is not None and more is None and not args.update:
        more = _more(total, state)
    if state is None or not (more or args.update):
        return CarriedOptions(given or _PRESETS, arguments, {}, args.seed, total, more)
    before = state.settings
    minutes = before.minutes
    if args.update and (state.is_finished or total is not None):
        minutes = total or round(max(1.0, _UPDATE * state.seconds / 60.0), 2)
    return CarriedOptions(
        given or before.presets,
        arguments or before.arguments,
        {k: v for k, v in before.settings.items() if k != "lights" or not args.update},
        args.seed or before.seed,
        minutes,
        more,
    )


def _more(total: float | None, state: State) -> float | None:
    """Minutes to go on for; None where none are due. total: minutes in all."""
    before = state.settings.minutes
    if total is None or before is None or total == before:
        return None
    spent = state.seconds / 60.0
    if state.more is not None and not state.is_finished:
        spent = state.more.begun / 60.0
    if total < spent + _LEAST:
        raise TrainingError(
            f"--minutes {total:g}: {spent:.1f} are spent already, expected more; --more 10 goes on "
            "for another 10"
        )
    return total - spent

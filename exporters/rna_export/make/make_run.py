"""Runs `rna-make`: alternates capture and training until the stopping criterion, then exports."""

import math
import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from time import monotonic

from rna_export.capture.capture_plan import parts_lines
from rna_export.capture.capture_run import say_dropped
from rna_export.capture.dataset.completeness import check_kept
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.export.extras import add_extras
from rna_export.export.package_build import build_package
from rna_export.export.precision import Precision
from rna_export.make.capture_rounds import Rays, open_rays, rays_folder
from rna_export.make.carry_on import (
    before_folder,
    begin_update,
    finish,
    go_on,
    same_parts,
    starts_of,
)
from rna_export.make.chosen_plan import chosen_plan, decoder_size, end_of, plan_text
from rna_export.make.goal import Goal
from rna_export.make.make_options import MakeOptions
from rna_export.make.make_progress import Clock, Progress, Stage, quiet
from rna_export.make.phases import Phase, Trainer, phase_folder, score, trained_in
from rna_export.make.plan import Length, Verdict, verdict
from rna_export.make.round_images import RoundImages
from rna_export.make.state import Last, Round, Score, State, check_same, read_state
from rna_export.make.training_floor import too_few_steps
from rna_export.training.checkpoint import Trained
from rna_export.training.training_options import device_name
from rna_export.training.validation import reference_warnings
from rna_sdk.errors import TrainingError
from rna_sdk.package import Manifest

_RAYS, _PHASE, _LAST = 1.0, 1.0, 3.0  # weights of stages in the progress bar


@dataclass(frozen=True)
class Made:
    """The outcome of an `rna-make` run."""

    dataset: Dataset
    why: Verdict
    rounds: int
    checkpoints: tuple[Path, ...]  # folders of the presets, as requested
    lead: str  # the preset that the goal is for
    without_noise: bool = False  # whether its PSNR was judged so

    def trained(self) -> list[Trained]:
        """The models of all parts and presets."""
        return [one for folder in self.checkpoints for one in trained_in(folder, self.dataset)]


class Make:
    """One `rna-make` run in its work folder; an interrupted one resumes.

    begun: when its time began, of `time.monotonic`. Raises `TrainingError` where the work folder is
    of another make.
    """

    def __init__(self, options: MakeOptions, begun: float, say: Callable[[str], None]):
        self._options, self._begun = options, begun
        self._by_cost = sorted(options.presets, key=decoder_size, reverse=True)
        self._lead = self._by_cost[0]
        self._state = self._opened_state(say)
        self._spent_before = self._state.seconds
        self._trainer = Trainer(options.overlaps)
        self._seconds = dict.fromkeys(("capture", "training"), 0.0)
        dataset = Dataset(rays_folder(options))
        check_kept(dataset)
        for note in dataset.manifest.all_notes:
            say(f"note: {note}")
        self._rays = Rays(options, dataset)
        self._goal = options.goal or Goal("min_psnr", math.inf)
        self._end = end_of(options, self._state)
        self._plan = chosen_plan(options, self._state, dataset)
        self._images = RoundImages(self._rays, self._state, options.settings)
        if self._plan.rounds is None and not self._state.rounds:
            self._images.shrink(self._plan.lights_of(0, 0))
        geometries = {part.name: part.geometry() for part in dataset.parts}
        plan = plan_text(self._plan, options, self._state, dataset)
        say(f"{parts_lines(dataset.manifest.name, geometries)}{plan}")

    def run(self) -> Made:
        """Capture and train to the end."""
        clock = Clock(self._spent, None if math.isinf(self._end) else self._end)
        self._progress = Progress(self._known_weight(), clock, self._finished_weight())
        try:
            self._capture_images()
            with self._trainer:
                for number, round_ in enumerate(self._state.rounds):
                    if round_.is_captured and round_.score is None:
                        self._train(number, round_)
                while (why := self._verdict()) is None or self._grow_images():
                    if why is None:
                        self._round()
                self._trainer.wait()
            self._progress.say(f"{why} after round {len(self._state.rounds)}")
            say_dropped(self._rays.dataset, self._progress.say)
            for preset in self._by_cost:
                if preset != self._lead or why != "goal met":
                    self._last_phase(preset)
            self._progress.say(self._times_text())
        finally:
            self._progress.close()
            self._save()
        best = {preset: self._best(preset) for preset in self._options.presets}
        folders = {preset: folder for preset, (folder, _) in best.items()}
        few = None
        if why == "time is up":
            seconds = self._state.seconds - self._state.capture_seconds
            few = too_few_steps(self._options.work, folders, self._rays.dataset, seconds)
        finish(self._state, self._options.work, best)
        if few is not None:
            raise TrainingError(few)
        dataset, rounds = self._rays.dataset, len(self._state.rounds)
        without_noise = best[self._lead][1].without_noise
        return Made(dataset, why, rounds, tuple(folders.values()), self._lead, without_noise)

    def _opened_state(self, say: Callable[[str], None]) -> State:
        """State of the work folder with the present request; a new one if there is none."""
        options = self._options
        state = read_state(options.work)
        if options.update and (state is None or state.is_finished or state.starts is None):
            begin_update(options.work)
            return self._first_state(say)
        if state is None:
            if options.more is not None:
                raise TrainingError(
                    f"{options.work}: found no rays to continue with, expected rays of an "
                    "rna-make without --discard"
                )
            return self._first_state(say)
        new = check_same(state, options.requested, options.work, for_more=options.more is not None)
        if options.more is not None:
            go_on(state, options.work, options.more)
        elif new and state.is_finished:
            names = ", ".join(f"--{name}" for name in new)
            raise TrainingError(f"{names}: is for new rays, and all are captured: give --more too")
        if new:
            Dataset(rays_folder(options)).change_settings(new)
            settings = {**state.settings.settings, **new}
            state.settings = state.settings.model_copy(update={"settings": settings})
            state.save(options.work)
        if state.rounds:
            minutes = f"after {state.seconds / 60:.1f} min"
            say(f"resuming {options.work} {minutes}, in round {len(state.rounds)}")
        return state

    def _first_state(self, say: Callable[[str], None]) -> State:
        options = self._options
        say(
            f"opening {options.source.path.name} in Blender: its geometry, the speed of Cycles here"
        )
        shutil.rmtree(rays_folder(options), ignore_errors=True)  # of a start that was not finished
        options.work.mkdir(parents=True, exist_ok=True)
        dataset = open_rays(options, self._begun, say)
        state = State(settings=options.requested, lights=dataset.manifest.settings.lights)
        state.seconds = monotonic() - self._begun
        if options.update:
            state.starts = same_parts(options.work, dataset)
            for part in dataset.parts:
                how = (
                    "has the same geometry: its training starts from the old model"
                    if part.name in state.starts
                    else "has another geometry: its training starts anew"
                )
                say(f"{part.name} {how}")
        state.save(options.work)
        self._begun = monotonic()
        return state

    def _capture_images(self) -> None:
        stage = self._progress.stage("rendering validation images in Cycles", _RAYS)
        with self._timed("capture"):
            self._images.capture(self._plan.image_seconds, stage)
        self._save()
        stage.done()
        for line in reference_warnings(self._rays.dataset.whole_views()):
            self._progress.say(line)

    def _grow_images(self) -> bool:
        """Replace small images by larger ones, if it is due, and score the rounds anew."""
        self._trainer.wait()
        if not self._images.grow(self._spent()):
            return False
        rounds = self._state.rounds
        for round_ in rounds:
            round_.score = None
        self._save()
        self._progress.more(_RAYS + _PHASE * len(rounds))
        self._capture_images()
        for number, round_ in enumerate(rounds):
            self._train(number, round_)
        self._trainer.wait()
        return True

    def _round(self) -> None:
        """The round that is not captured, or a new one, and its training."""
        rounds = self._state.rounds
        if not rounds or rounds[-1].is_captured:
            before = rounds[-1].lights if rounds else 0
            lights = self._plan.lights_of(len(rounds), before)
            rounds.append(Round(lights=lights))
            if self._plan.rounds is None and len(rounds) > 1:
                self._progress.more(_RAYS + _PHASE)
            self._save()
        number, round_ = len(rounds) - 1, rounds[-1]
        stage = self._progress.stage(f"round {number + 1}: rendering light in Cycles", _RAYS)
        begun = monotonic()
        with self._timed("capture"):
            self._rays.capture(round_, self._plan.capture_seconds(number, self._left()), stage)
        self._state.capture_seconds += monotonic() - begun
        self._save()
        stage.done()
        self._train(number, round_)

    def _train(self, number: int, round_: Round) -> None:
        """The training of a round, if the plan has one; a GPU's goes on beside the next capture."""
        round_.phase = round_.phase or self._plan.phase(number, self._left())
        if round_.phase is None:
            return
        self._save()
        stage = self._progress.stage(f"round {number + 1}: training {self._lead}", _PHASE)
        shards = self._rays.dataset.finished_shards()
        self._trainer.run(partial(self._short_phase, number, round_, shards, stage))

    def _short_phase(
        self, number: int, round_: Round, shards: Sequence[Path], stage: Stage
    ) -> None:
        """The training of the leading preset in a round."""
        assert round_.phase is not None
        lead, phase = self._lead, self._phase(self._lead, round_.phase, number)
        with self._timed("training"):
            phase.run(shards, stage)
        stage.done()
        trained = trained_in(phase.folder, phase.dataset)
        round_.score = score(trained, phase.dataset, self._images.are_noisy)
        self._save()
        text = f"{round_.lights:,} lights, {lead} has {_score_text(round_.score)}"
        self._progress.say(f"round {number + 1}: {text}")

    def _last_phase(self, preset: str) -> None:
        """The full one, on all rays."""
        stage = self._progress.stage(f"last training: {preset}", _LAST)
        last = self._state.last.get(preset)
        if last is None:
            ahead = len(self._by_cost) - self._by_cost.index(preset)
            last = Last(phase=self._plan.last_phase(self._left(), ahead))
            self._state.last[preset] = last
            self._save()
        if last.score is None:
            phase = self._phase(preset, last.phase, None)
            with self._timed("training"):
                phase.run(phase.dataset.finished_shards(), stage)
            trained = trained_in(phase.folder, phase.dataset)
            last.score = score(trained, phase.dataset, self._images.are_noisy)
            self._save()
            self._progress.say(f"last training: {preset} has {_score_text(last.score)}")
        stage.done()

    def _phase(self, preset: str, length: Length, number: int | None) -> Phase:
        """A training in a round, counted from 0, or the last one."""
        options, dataset, state = self._options, self._rays.dataset, self._state
        folder = phase_folder(options.work, preset, number)
        starts = starts_of(state, options.work, preset, dataset)
        return Phase(dataset, preset, length, folder, options, starts)

    def _verdict(self) -> Verdict | None:
        rounds = self._state.rounds
        errors = [self._goal.error_db(r.score) for r in rounds if r.score is not None]
        result = verdict(errors, self._goal.limit_db)
        if self._plan.rounds is None or result == "goal met":
            return result
        captured = sum(r.is_captured for r in rounds)
        return self._plan.end if captured == self._plan.rounds else None

    def _best(self, preset: str) -> tuple[Path, Score]:
        """Folder and score of the model with the smallest error."""
        work, last = self._options.work, self._state.last.get(preset)
        found: list[tuple[Path, Score | None]] = []
        if preset == self._lead:
            rounds = enumerate(self._state.rounds)
            found += [(phase_folder(work, preset, k), r.score) for k, r in rounds]
        if last is not None:
            found.append((phase_folder(work, preset, None), last.score))
        if preset in self._state.before:
            found.append((before_folder(work, preset), self._state.before[preset]))
        scored = [(folder, score) for folder, score in found if score is not None]
        return min(scored, key=lambda one: self._goal.error_db(one[1]))

    def _left(self) -> float:
        """Seconds; infinite without a limit."""
        return self._end - self._spent()

    def _spent(self) -> float:
        return self._spent_before + monotonic() - self._begun

    @contextmanager
    def _timed(self, what: str) -> Iterator[None]:
        """Adds the block's seconds to the final summary."""
        begun = monotonic()
        try:
            yield
        finally:
            self._seconds[what] += monotonic() - begun

    def _times_text(self) -> str:
        """Resources that this run used, its duration, and its longest part."""
        capture, training = self._seconds["capture"] / 60, self._seconds["training"] / 60
        workers, device = self._options.workers, device_name(self._options.device)
        images = self._state.image_seconds / max(self._spent(), 1e-3)
        return (
            f"time: {capture:.1f} min of Cycles with {workers.backend().width()} workers, "
            f"{training:.1f} min of training on {device}; validation images took {images:.0%} of "
            "all; the bottleneck is " + ("Cycles" if capture > training else "training")
        )

    def _save(self) -> None:
        self._state.seconds = self._spent()
        self._state.save(self._options.work)

    def _finished_weight(self) -> float:
        """Weight of the rounds that earlier runs finished, which have no stage any more."""
        return sum(_RAYS + _PHASE for round_ in self._state.rounds if round_.score is not None)

    def _known_weight(self) -> float:
        """Total weight of all known stages."""
        if self._state.more is not None:
            return 2.0 * _RAYS + _LAST * len(self._by_cost)
        rounds = self._plan.rounds or max(len(self._state.rounds), 1)
        phases = rounds if self._plan.rounds is None else rounds - 1
        return _RAYS * (1 + rounds) + _PHASE * phases + _LAST * len(self._by_cost)


def export(
    made: Made,
    out: Path,
    credit: str | None,
    license_: str,
    precisions: Mapping[str, Sequence[Precision]],
    name: str | None,
) -> Manifest:
    """Write the package of the trained models; precisions: of each preset's tiers."""
    models, dataset, loss = made.trained(), made.dataset, math.inf
    manifest = build_package(
        models, dataset, out, credit, license_, quiet, precisions, max_loss=loss, name=name
    )
    add_extras(out, made.dataset, None, (), False, quiet)
    return manifest


def _score_text(score: Score) -> str:
    noise = " without noise" if score.without_noise else ""
    return f"FLIP {score.flip:.3f}, PSNR {score.psnr:.2f} dB{noise}"

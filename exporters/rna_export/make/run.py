"""Runs a make: captures and trains by turns until the stop rule ends it, then exports."""

from __future__ import annotations

import math
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from time import monotonic
from typing import Any

from rna_export.capture.dataset import Dataset
from rna_export.capture.guide import Guide
from rna_export.capture.run import Crew, begin, finish
from rna_export.capture.tasks import Task, TrainingShard, ValidationHalf, all_tasks
from rna_export.capture.time_plan import TimeLimit
from rna_export.capture.worker import Source
from rna_export.export.build import build_package
from rna_export.export.dressing import dress
from rna_export.fit.goal import Goal
from rna_export.make.phases import Phase, score, trained_in
from rna_export.make.plan import CAPTURE, OpenPlan, Plan, TimedPlan
from rna_export.make.progress import Progress
from rna_export.make.state import Asked, Last, Round, Score, State, load_state
from rna_export.make.stop import Verdict, verdict
from rna_export.make.unseen import guide_from
from rna_export.training.model import NeuralAsset
from rna_export.training.presets import PRESETS
from rna_render.scene_file import SceneFile
from rna_sdk.package import Manifest

_HELD_OUT = 8  # one of so many shards of the first round tests the first model
_CAPTURE_WEIGHT, _PHASE_WEIGHT, _LAST_WEIGHT = 1.0, 1.0, 3.0  # of the progress bar


@dataclass(frozen=True)
class Order:
    """One make, as asked for."""

    source: Source
    settings: dict[str, Any]  # of the capture, that are not to be the usual ones
    for_scene: SceneFile | None
    work: Path
    presets: tuple[str, ...]
    goal: Goal | None
    minutes: float | None
    steps: int | None  # of the last phase; None: the preset's
    seed: int
    device: str
    crew: Crew


@dataclass(frozen=True)
class Made:
    """What a make came to."""

    dataset: Dataset
    why: Verdict
    rounds: int
    checkpoints: tuple[Path, ...]  # folders of the presets, as they were asked for
    lead: str  # the preset that the goal is for


class Make:
    """One make in its work folder; a stopped one goes on.

    begun: when its time began, of `time.monotonic`. Raises `TrainingError` where the work folder is
    of another make.
    """

    def __init__(self, order: Order, asked: Asked, begun: float, say: Callable[[str], None]):
        self._order, self._begun, self._say = order, begun, say
        self._rays = order.work / "rays"
        state = load_state(order.work, asked)
        if state is None:
            shutil.rmtree(self._rays, ignore_errors=True)  # of a start that was not finished
            dataset = self._opened()
            state = State(asked=asked, lights=dataset.manifest.settings.lights)
            dataset.plan_lights(min(state.lights, dataset.manifest.settings.lights_per_shard))
            state.save(order.work)
        else:
            say(f"continuing {order.work}, round {len(state.rounds)}")
        self._state, self._spent_before = state, state.seconds
        self._dataset = Dataset(self._rays)
        self._goal = order.goal or Goal("min_psnr", math.inf)
        self._plan = self._chosen_plan()
        for note in self._dataset.manifest.notes:
            say(f"note: {note}")

    def run(self) -> Made:
        """Capture and train to the end."""
        self._progress = Progress(self._known_weight())
        try:
            self._capture_images()
            while (why := self._verdict()) is None:
                self._round()
            self._progress.say(f"{why} after round {len(self._state.rounds)}")
            for preset in self._presets_by_cost:
                self._last_phase(preset, why)
        finally:
            self._progress.close()
            self._save()
        folders = tuple(self._best_folder(preset) for preset in self._order.presets)
        return Made(self._dataset, why, len(self._state.rounds), folders, self._lead)

    # Capture

    def _opened(self) -> Dataset:
        order, limit = self._order, None
        if order.minutes is not None:
            limit = TimeLimit(order.minutes, self._begun, CAPTURE)
        order.work.mkdir(parents=True, exist_ok=True)
        asked = {"lights_per_shard": _SHARD, **order.settings}
        return begin(order.source, asked, self._rays, order.crew, limit, _quiet, order.for_scene)

    def _capture_images(self) -> None:
        images = [t for t in all_tasks(self._dataset) if isinstance(t, ValidationHalf)]
        stage = self._progress.stage("validation images", _CAPTURE_WEIGHT)
        finish(
            self._dataset,
            self._order.source,
            self._order.crew,
            say=_quiet,
            tasks=images,
            bars=stage.part(0.0, 1.0),
        )
        stage.done()
        self._save()

    def _capture(self, number: int) -> None:
        round_ = self._state.rounds[number]
        stage = self._progress.stage(f"round {number + 1}: rays", _CAPTURE_WEIGHT)
        if not round_.is_captured:
            guide = self._guide(number)
            self._dataset.plan_lights(round_.lights)
            seconds = self._plan.capture_seconds(number, self._left())
            finish(
                self._dataset,
                self._order.source,
                self._order.crew,
                None if seconds is None else TimeLimit(seconds / 60.0),
                _quiet,
                [_guided(task, round_.first_shard, guide) for task in all_tasks(self._dataset)],
                stage.part(0.0, 1.0),
            )
            round_.lights = self._dataset.manifest.settings.lights
            round_.is_captured = True
            self._save()
        stage.done()

    def _guide(self, number: int) -> Guide | None:
        """For the rays of a round; None for those of the first one, or where nothing is unseen."""
        if number == 0:
            return None
        path = self._order.work / f"guide-{number + 1:02d}.safetensors"
        captured = tuple(part.captured for part in self._dataset.parts)
        if not path.is_file():
            # The rays of the round before test the model that was there before them; those of the
            # first round were kept back for that.
            tested = max(number - 2, 0)
            unseen = self._held_out() if number == 1 else self._shards_of(number - 1)
            if not unseen:
                return None
            models = self._models(self._phase_folder(self._lead, tested))
            guide_from(self._dataset, models, unseen, self._order.seed).save(path)
        return Guide.load(path, captured)

    def _models(self, folder: Path) -> list[NeuralAsset]:
        return [one.model.to(self._order.device) for one in trained_in(folder, self._dataset)]

    def _shards_of(self, number: int) -> list[Path]:
        """That a round has added."""
        rounds = self._state.rounds
        first = rounds[number].first_shard
        end = self._dataset.manifest.shards
        if number + 1 < len(rounds):
            end = rounds[number + 1].first_shard
        return [self._dataset.train_path(k) for k in range(first, end)]

    def _held_out(self) -> list[Path]:
        """Shards of the first round that its training leaves out."""
        shards = self._shards_of(0)
        return shards[-max(1, len(shards) // _HELD_OUT) :] if len(shards) > 1 else []

    # Training

    def _round(self) -> None:
        """The round that is not finished, or a new one."""
        rounds = self._state.rounds
        if not rounds or rounds[-1].score is not None:
            before = rounds[-1].lights if rounds else 0
            lights = self._plan.lights_of(len(rounds), before)
            first = -(-before // self._dataset.manifest.settings.lights_per_shard)
            rounds.append(Round(first_shard=first, lights=lights))
            if self._plan.rounds is None and len(rounds) > 1:
                self._progress.more(_CAPTURE_WEIGHT + _PHASE_WEIGHT)
            self._save()
        number, round_ = len(rounds) - 1, rounds[-1]
        self._capture(number)
        if round_.phase is None:
            round_.phase = self._plan.phase(number, self._left())
            self._save()
        if round_.phase is None:
            return
        stage = self._progress.stage(f"round {number + 1}: {self._lead}", _PHASE_WEIGHT)
        shards = self._dataset.finished_shards()
        if number == 0:
            shards = [path for path in shards if path not in self._held_out()]
        start = self._phase_folder(self._lead, number - 1) if number else None
        phase = self._phase(self._lead, round_.phase, number, start)
        phase.run(shards, stage)
        round_.score = score(phase.trained(), self._dataset)
        stage.done()
        self._save()
        self._progress.say(
            f"round {number + 1}: {round_.lights:,} lights, {self._lead} has {_told(round_.score)}"
        )

    def _last_phase(self, preset: str, why: Verdict) -> None:
        """The full one; none for the leading preset where its rounds have met the goal."""
        if preset == self._lead and why == "goal met":
            return
        stage = self._progress.stage(f"last phase: {preset}", _LAST_WEIGHT)
        last = self._state.last.get(preset)
        if last is None:
            undone = len(self._presets_by_cost) - len(self._state.last)
            undone -= why == "goal met"
            last = Last(phase=self._plan.last_phase(self._left(), undone))
            self._state.last[preset] = last
            self._save()
        if last.score is None:
            phases = [k for k, r in enumerate(self._state.rounds) if r.score is not None]
            leads = preset == self._lead and bool(phases)
            start = self._phase_folder(preset, phases[-1]) if leads else None
            phase = self._phase(preset, last.phase, None, start)
            phase.run(self._dataset.finished_shards(), stage)
            last.score = score(phase.trained(), self._dataset)
            self._save()
            self._progress.say(f"last phase: {preset} has {_told(last.score)}")
        stage.done()

    def _phase(self, preset: str, length: Any, number: int | None, start: Path | None) -> Phase:
        folder = self._phase_folder(preset, number)
        order = self._order
        return Phase(self._dataset, preset, length, folder, start, order.seed, order.device)

    def _phase_folder(self, preset: str, number: int | None) -> Path:
        name = "last" if number is None else f"round-{number + 1:02d}"
        return self._order.work / "runs" / preset / name

    def _best_folder(self, preset: str) -> Path:
        """Of the phase with the least error."""
        found: list[tuple[Score, int | None]] = []
        if preset == self._lead:
            rounds = enumerate(self._state.rounds)
            found += [(r.score, k) for k, r in rounds if r.score is not None]
        if preset in self._state.last:
            found.append((self._state.last[preset].score, None))
        best = min(found, key=lambda pair: self._goal.error_db(pair[0]))
        return self._phase_folder(preset, best[1])

    # Decisions

    def _chosen_plan(self) -> Plan:
        manifest, shard = self._dataset.manifest, self._dataset.manifest.settings.lights_per_shard
        if self._order.minutes is None:
            usual = max(PRESETS[p.kind][self._lead].training.steps for p in manifest.parts)
            return OpenPlan(self._state.lights, shard, self._order.steps or usual)
        tiers = len(self._order.presets)
        return TimedPlan(self._state.lights, shard, 60.0 * self._order.minutes, tiers)

    def _verdict(self) -> Verdict | None:
        scores = [r.score for r in self._state.rounds if r.score is not None]
        found = verdict([self._goal.error_db(s) for s in scores], self._goal.limit_db)
        if self._plan.rounds is None or found == "goal met":
            return found
        captured = sum(r.is_captured for r in self._state.rounds)
        return "time is up" if captured == self._plan.rounds else None

    @property
    def _lead(self) -> str:
        """The preset with the dearest decoder: rays are chosen for it, and the goal is its."""
        return self._presets_by_cost[0]

    @cached_property
    def _presets_by_cost(self) -> list[str]:
        def cost(name: str) -> int:
            model = PRESETS["surface"][name].model
            return model.hidden_layers * model.width**2

        return sorted(self._order.presets, key=cost, reverse=True)

    # Time

    def _spent(self) -> float:
        return self._spent_before + monotonic() - self._begun

    def _left(self) -> float:
        """Seconds; infinite without --minutes."""
        minutes = self._order.minutes
        return math.inf if minutes is None else 60.0 * minutes - self._spent()

    def _save(self) -> None:
        self._state.seconds = self._spent()
        self._state.save(self._order.work)

    def _known_weight(self) -> float:
        """Of all stages that are known to come."""
        rounds = self._plan.rounds or max(len(self._state.rounds), 1)
        phases = rounds if self._plan.rounds is None else rounds - 1
        last = _LAST_WEIGHT * len(self._order.presets)
        return _CAPTURE_WEIGHT * (1 + rounds) + _PHASE_WEIGHT * phases + last


def export(made: Made, out: Path, credit: str | None, license_: str) -> Manifest:
    """Write the package of what was made."""
    trained = [one for folder in made.checkpoints for one in trained_in(folder, made.dataset)]
    manifest = build_package(
        trained, made.dataset, out, credit, license_, _quiet, max_loss=math.inf
    )
    dress(out, made.dataset, None, (), False, _quiet)
    return manifest


def _guided(task: Task, first: int, guide: Guide | None) -> Task:
    if isinstance(task, TrainingShard) and task.index >= first:
        return TrainingShard(task.index, guide)
    return task


def _told(found: Score) -> str:
    return f"PSNR {found.psnr:.2f} dB, FLIP {found.flip:.4f}"


def _quiet(_: str) -> None:
    pass


_SHARD = 16  # lights; a worker begins anew after 12 shards

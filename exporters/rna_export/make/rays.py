"""The rays of an `rna-make` run: a dataset that grows by rounds, guided by held-out errors."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from rna_export.capture.dataset import Dataset
from rna_export.capture.run import begin, finish
from rna_export.capture.tasks import Task, TrainingShard, ValidationHalf, all_tasks
from rna_export.capture.time_plan import TimeLimit
from rna_export.make.order import Order
from rna_export.make.phases import phase_folder, trained_in
from rna_export.make.plan import CAPTURE
from rna_export.make.progress import Stage
from rna_export.make.state import Round
from rna_export.make.unseen import guide_from

_SHARD = 16  # lights; a worker begins anew after 12 shards
_HELD_OUT = 8  # one of so many shards of the first round tests the first model


def open_rays(order: Order, begun: float) -> Dataset:
    """A dataset without rays, planned with as many lights as are usual, or fit into the minutes.

    begun: when those began, of `time.monotonic`.
    """
    limit = None if order.minutes is None else TimeLimit(order.minutes, begun, CAPTURE)
    asked = {"lights_per_shard": _SHARD, **order.settings}
    return begin(
        order.source, asked, rays_folder(order), order.crew, limit, _quiet, order.for_scene
    )


def rays_folder(order: Order) -> Path:
    """Of the dataset."""
    return order.work / "rays"


class Rays:
    """Captures the dataset's rounds. lead: the preset whose model tests them."""

    def __init__(self, order: Order, dataset: Dataset, rounds: Sequence[Round], lead: str):
        self._order, self.dataset, self._rounds, self._lead = order, dataset, rounds, lead

    @property
    def shard(self) -> int:
        """Lights that are captured together."""
        return self.dataset.manifest.settings.lights_per_shard

    def capture_images(self, stage: Stage) -> None:
        """The validation images."""
        tasks = [t for t in all_tasks(self.dataset) if isinstance(t, ValidationHalf)]
        self._finish(tasks, None, stage)

    def capture(self, number: int, seconds: float | None, stage: Stage) -> None:
        """The rays of a round, or as many as fit into the seconds; sets the round's lights."""
        round_, guide = self._rounds[number], self._guide(number)
        self.dataset.plan_lights(round_.lights)
        tasks = [_guided(task, round_.first_shard, guide) for task in all_tasks(self.dataset)]
        self._finish(tasks, None if seconds is None else TimeLimit(seconds / 60.0), stage)
        round_.lights = self.dataset.manifest.settings.lights
        round_.is_captured = True

    def to_train_on(self, number: int) -> list[Path]:
        """The shards that a round's phase sees."""
        held_out = self._held_out() if number == 0 else []
        return [path for path in self.dataset.finished_shards() if path not in held_out]

    def _finish(self, tasks: Sequence[Task], limit: TimeLimit | None, stage: Stage) -> None:
        bars = stage.part(0.0, 1.0)
        order = self._order
        finish(self.dataset, order.source, order.crew, limit, _quiet, tasks, bars)

    def _guide(self, number: int) -> int | None:
        """Number of that for the rays of a round; None for the first, or where nothing is unseen.

        The rays of the round before test the model that was there before them; for the second
        round those that the first phase left out.
        """
        if number == 0:
            return None
        path = self.dataset.guide_path(number + 1)
        if not path.is_file():
            unseen = self._held_out() if number == 1 else self._shards_of(number - 1)
            if not unseen:
                return None
            folder = phase_folder(self._order.work, self._lead, max(number - 2, 0))
            trained = trained_in(folder, self.dataset)
            models = [one.model.to(self._order.device) for one in trained]
            guide_from(self.dataset, models, unseen, self._order.seed).save(path)
        return number + 1

    def _shards_of(self, number: int) -> list[Path]:
        """That a round added, and that are there."""
        first, lights = self._rounds[number].first_shard, self._rounds[number].lights
        return [self.dataset.train_path(k) for k in range(first, -(-lights // self.shard))]

    def _held_out(self) -> list[Path]:
        """Shards of the first round that its phase leaves out."""
        shards = self._shards_of(0)
        return shards[-max(1, len(shards) // _HELD_OUT) :] if len(shards) > 1 else []


def _guided(task: Task, first: int, guide: int | None) -> Task:
    if isinstance(task, TrainingShard) and task.index >= first:
        return TrainingShard(task.index, guide)
    return task


def _quiet(_: str) -> None:
    pass

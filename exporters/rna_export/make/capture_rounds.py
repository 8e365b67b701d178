"""The rays of an `rna-make` run: a dataset that grows by rounds."""

from collections.abc import Callable, Sequence
from pathlib import Path

from rna_export.capture.capture_run import begin, finish
from rna_export.capture.capture_tasks import Task, ValidationHalf, WhiteRays, all_tasks
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.time_plan import TimeLimit
from rna_export.make.make_options import MakeOptions
from rna_export.make.make_progress import Stage, quiet
from rna_export.make.state import Round

_SHARD = 16  # lights, where rounds grow


def open_rays(options: MakeOptions, begun: float, say_first: Callable[[str], None]) -> Dataset:
    """A dataset without rays, planned with as many lights as are usual, or fit into the minutes.

    begun: when those began, of `time.monotonic`. say_first: gets lines on how well
    materials are learnt, and what the asset is expected to gain.
    """
    share, minutes = options.capture_share, options.minutes
    limit = None if minutes is None else TimeLimit(minutes, begun, share)
    small = {} if options.fixes_lights else {"lights_per_shard": _SHARD}
    settings = {**small, **options.settings}
    return begin(
        options.source,
        settings,
        rays_folder(options),
        options.workers,
        limit,
        quiet,
        options.for_scene,
        say_first,
    )


def rays_folder(options: MakeOptions) -> Path:
    """Folder of the dataset."""
    return options.work / "rays"


class Rays:
    """Captures the dataset's rounds."""

    def __init__(self, options: MakeOptions, dataset: Dataset):
        self._options, self.dataset = options, dataset

    def images(self) -> list[ValidationHalf | WhiteRays]:
        """The tasks of all validation images, and of the rays in a white world."""
        held_out = ValidationHalf | WhiteRays
        return [task for task in all_tasks(self.dataset) if isinstance(task, held_out)]

    def capture_images(self, seconds: float | None, stage: Stage) -> None:
        """The held-out images, or as many as the time allows."""
        self._finish(self.images(), _limit(seconds), stage)

    def capture(self, round_: Round, seconds: float | None, stage: Stage) -> None:
        """Capture the rays of a round, or as many as the time allows; sets the round's lights."""
        self.dataset.plan_lights(round_.lights)
        self._finish(all_tasks(self.dataset), _limit(seconds), stage)
        round_.lights = self.dataset.manifest.settings.lights
        round_.is_captured = True

    def _finish(self, tasks: Sequence[Task], limit: TimeLimit | None, stage: Stage) -> None:
        bars = stage.part(0.0, 1.0)
        options = self._options
        finish(self.dataset, options.source, options.workers, limit, quiet, tasks, bars)


def _limit(seconds: float | None) -> TimeLimit | None:
    return None if seconds is None else TimeLimit(seconds / 60.0)

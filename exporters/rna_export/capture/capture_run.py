"""Runs a capture: opens the source, plans, renders missing tasks; resumable at any time."""

import hashlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from time import monotonic
from typing import Any

from tqdm import tqdm

import rna_sdk
from rna_export.capture.blender_process import blender_env
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.capture_worker import CaptureJob, CaptureWorker, opened
from rna_export.capture.capture_plan import parts_lines, plan_lines
from rna_export.capture.capture_tasks import Task, TrainingShard, ValidationHalf, all_tasks
from rna_export.capture.check.self_check import PICTURE, WORTH_A_NOTE, SelfCheck
from rna_export.capture.dataset.collect import Collector
from rna_export.capture.dataset.completeness import forget, record_files
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_manifest import CaptureManifest
from rna_export.capture.estimate.gain import gain_text, table_of
from rna_export.capture.estimate.pilot import LIGHTS, Pilot, pilot_paths
from rna_export.capture.geometry.followed_source import captured_poses
from rna_export.capture.opened_source import CHECK_RENDERS, OpenedSource
from rna_export.capture.preflight.verdicts import not_learnt
from rna_export.capture.time_plan import (
    LEAST_IMAGES,
    LEAST_LIGHTS,
    TimeLimit,
    planned,
    shrunk,
)
from rna_render.scene import SceneFile
from rna_sdk.errors import CaptureError
from rna_sdk.files.atomic_file import write_atomically
from rna_sdk.machine.cpu import processor_key
from rna_work.backend import Backend, Needs
from rna_work.bar import Bar
from rna_work.cluster.store import Store
from rna_work.executors import Executor, this_machine
from rna_work.pool import Pool
from rna_work.progress import Progress
from rna_work.sources import Carried
from rna_work.timeouts import Timeouts

_RESOURCE = "rna_blender"  # of a cluster's nodes that have Blender
_MATTERS = 0.1  # of what is seen
_ATTEMPTS = 2  # Blender may die of its own; a second failure is ours


@dataclass(frozen=True)
class CaptureWorkers:
    """The workers of a capture.

    python, scratch: of Blender on this machine. count: how many, each with one thread, since a
    small render scales badly; None for all that there is room for. store: where workers put what is
    finished; None if they all see the dataset's folder.
    """

    python: Path
    scratch: Path
    count: int | None
    executor: Executor = field(default_factory=this_machine)
    store: Store | None = None

    def probe(self, source: Source) -> BlenderWorker:
        """A Blender of this machine that is not one of the workers."""
        return BlenderWorker(self.python, source, self.scratch, threads=1, name="probe")

    def carried(self, source: Source) -> Carried:
        """The source for workers, with the other files that it reads, found by opening it here."""
        if not self.executor.far:
            return self.executor.carry(source.path)
        with self.probe(source) as worker:
            files = worker.opened["files"]
        travel, fixed = ([Path(path) for path in files[kind]] for kind in ("travel", "fixed"))
        return self.executor.carry(source.path, travel, fixed)

    def backend(self) -> Backend:
        """The executor's room for workers."""
        return self.executor.workers(Needs("threads", resource=_RESOURCE), self.count)


def measured_pilot(
    source: Source,
    given: dict[str, Any],
    workers: CaptureWorkers,
    say: Callable[[str], None],
    for_scene: SceneFile | None = None,
    lights: int = LIGHTS,
) -> Pilot | None:
    """Open the source and measure as `begin` does, but write nothing.

    say: gets lines on what the source is made of, how well that is learnt, and what `begin` would
    note. lights: of the pilot. None where something is not learnt.
    """
    with workers.probe(source) as worker:
        opened = OpenedSource.of(worker, given, source.path.stem, for_scene)
        say(parts_lines(source.path.stem, opened.exported.geometries).rstrip())
        notes = *worker.opened["notes"], *opened.exported.notes
        for line in (*opened.preflight, *(f"note: {note}" for note in notes)):
            say(line)
        if (why := no_gain(opened)) is not None:
            say(why)
            return None
        for line in without_relief(opened):
            say(line)
        with _trial(CHECK_RENDERS + lights) as bar:
            check, speed = opened.checked(opened.scene, bar.update)
            pilot = opened.pilot(speed, bar.update, lights)
        if (note := check.note()) is not None:
            say(f"note: {note}")
        return pilot


def no_gain(opened: OpenedSource) -> str | None:
    """Reason for promising no gain, or None; from a tenth of the visible area not learnt on."""
    names, share = not_learnt(opened.materials)
    if share < _MATTERS:
        return None
    return f"gain: none is promised, since {names} will not be learnt"


def without_relief(opened: OpenedSource) -> list[str]:
    """A line about the gain without relief, if a tenth of the visible area will lose it."""
    names, share = not_learnt(opened.materials, "relief")
    if share < _MATTERS:
        return []
    return [f"the gain is for the asset without the relief of {names}"]


def _trial(renders: int) -> tqdm:
    """A bar for the renders before a capture."""
    return Bar(total=renders, desc="first renders in Cycles", unit=" render", leave=False)


def begin(
    source: Source,
    given: dict[str, Any],
    out: Path,
    workers: CaptureWorkers,
    limit: TimeLimit | None,
    say: Callable[[str], None],
    for_scene: SceneFile | None = None,
    say_first: Callable[[str], None] | None = None,
) -> Dataset:
    """Open the source once: export the geometry, measure the speed, fix and write the plan.

    `given`: settings, by name, that are not to be the usual ones of the asset's kind. `limit`
    replaces the number of lights by as many as fit, and may make the validation images smaller.
    `for_scene` limits views and lights to its own. `say_first`: gets lines on how well materials
    are learnt, and what the asset is expected to gain in scenes; None for `say`.
    """
    start, say_first = monotonic(), say_first or say
    with workers.probe(source) as worker:
        opening = monotonic() - start
        asset = OpenedSource.of(worker, given, out.stem, for_scene)
        for line in asset.preflight:
            say_first(line)
        settings, exported = asset.settings, asset.exported
        geometries = exported.geometries
        opened = worker.opened
        others = [frame for frame in settings.poses if frame != opened["frame"]]
        poses = dict(captured_poses(worker, geometries, exported.sources, others))
        worker.show_frame(opened["frame"])
        why = no_gain(asset)
        lights, trial = (LIGHTS, pilot_paths(settings)) if why is None else (0, 0)
        with _trial(CHECK_RENDERS * (1 + len(poses)) + lights) as bar:
            check, speed = asset.checked(asset.scene, bar.update)
            rate = speed.rate * workers.backend().width()
            if limit is not None:  # too few minutes are an error before the estimate takes some
                planned(settings, worker.kind, limit, opening + trial / speed.rate, rate, given)
            if why is None:
                gain = gain_text(asset.pilot(speed, bar.update), table_of())
                why = "\n".join([gain, *without_relief(asset)])
            checks = {"": check}
            for frame, positions in poses.items():
                worker.show_frame(frame)
                posed = asset.posed(list(positions.values()))
                checks[f"frame {frame}: "], _ = asset.checked(posed, bar.update)
        say_first(why)
    if limit is None:
        settings = settings.shared_out()
    else:
        usual = settings
        settings = planned(settings, worker.kind, limit, opening, rate, given)
        if note := shrunk(usual, settings):
            say(note)
    manifest = CaptureManifest(
        name=source.path.stem,
        parts=exported.captured(),
        source=source.path.name,
        source_sha256=hashlib.sha256(source.path.read_bytes()).hexdigest(),
        arguments=source.arguments,
        settings=settings,
        rest_frame=opened["frame"],
        poses=(opened["frame"], *poses) if poses else (),
        variants=tuple(exported.variants),
        blender=opened["blender"],
        generator=f"rna-capture {rna_sdk.__version__}",
        opaque_cutouts=exported.has_opaque_cutouts,
        emitters=tuple(opened["emitters"]),
        materials=asset.materials,
        notes=(
            *opened["notes"],
            *exported.notes,
            *(f"{begin}{note}" for begin, c in checks.items() if (note := c.note()) is not None),
        ),
        processors=(processor_key(),),
        scene_domain=asset.limited,
    )
    for note in manifest.all_notes:
        say(f"note: {note}")
    if (marked := _write_picture(list(checks.values()), out / PICTURE)) is not None:
        say(marked)
    dataset = Dataset.create(
        out,
        manifest,
        geometries,
        textures=exported.textures,
        poses=poses,
        sources=exported.sources,
        glass=exported.glass,
        exact=exported.exact,
        materials=exported.material_numbers([each.full_name for each in asset.materials]),
    )
    say(plan_lines(dataset, geometries, rate))
    return dataset


def finish(
    dataset: Dataset,
    source: Source,
    workers: CaptureWorkers,
    limit: TimeLimit | None = None,
    say: Callable[[str], None] = print,
    tasks: Sequence[Task] | None = None,
    bars: Callable[..., tqdm] = Bar,
) -> None:
    """Render every task whose file is missing. Ctrl-C loses only the tasks under way.

    When the time of `limit` is up, the images and lights that are left are taken out of the plan,
    except two images and 16 lights. tasks: of the plan; None: all of it. bars: makes the progress
    bar. Raises CaptureError where a task fails twice, WorkError where a cluster cannot do the work.
    """
    dataset.remove_unfinished()
    every = all_tasks(dataset) if tasks is None else tasks
    missing = [task for task in every if not task.path(dataset).is_file()]
    if not missing:
        record_files(dataset)
        return
    forget(dataset, (task.path(dataset) for task in missing))
    collector = Collector.of(dataset, workers.executor, workers.store)
    missing = collector.fetch(missing)
    workers.executor.on_every_node(blender_env.find_or_set_up, _RESOURCE)
    scratch = None if workers.executor.far else workers.scratch
    job = CaptureJob(collector.carried(), collector.store, source, workers.carried(source), scratch)
    cost = partial(_cost, dataset)
    total = sum(map(cost, missing))
    make = partial(CaptureWorker, job)
    progress = Progress(total, "path", "capture", bars=bars)
    pool: Pool[Task, str] = Pool(
        workers.backend(), make, _ATTEMPTS, timeouts=Timeouts(cost), tell=progress.tell
    )
    with progress, pool:
        clock = _TaskClock(dataset, limit)
        for outcome in progress.of(pool, pool.run(clock.in_time(missing)), cost):
            dataset.record_processors([outcome.value()])
            collector.finished(outcome.item)
            clock.took = outcome.seconds
    opened.cache_clear()
    if limit is not None:
        _drop_late(dataset, every, say)
    record_files(dataset)
    say_dropped(dataset, say)


def _drop_late(dataset: Dataset, tasks: Sequence[Task], say: Callable[[str], None]) -> None:
    """Remove from the plan the tasks that a time limit left undone."""
    settings = dataset.manifest.settings
    lights, there = settings.lights, dataset.lights_finished()
    if there < lights and any(isinstance(task, TrainingShard) for task in tasks):
        dataset.plan_lights(there)
        say(f"time limit reached: {there:,} of {lights:,} lights; the dataset is complete")
    images, there = settings.validation_views, len(dataset.finished_views())
    if there < images:
        dataset.change_settings({"validation_views": there})
        say(
            f"this machine renders more slowly than it was measured to: {there} of {images} "
            "validation images, which leaves the time to rays and training"
        )


def say_dropped(dataset: Dataset, say: Callable[[str], None]) -> None:
    """Say how many view rays made no sample, from 1% on; CaptureError if none did."""
    rays, used = dataset.rays_captured(), dataset.used_rays()
    if not rays:
        return
    if not used:
        raise CaptureError(
            f"{dataset.folder}: none of {rays:,} view rays made a sample: Cycles met nothing at "
            "their points"
        )
    if rays - used >= WORTH_A_NOTE * rays:
        say(
            f"note: {rays - used:,} of {rays:,} view rays ({1.0 - used / rays:.1%}) made no "
            "sample: Cycles met nothing at their points"
        )


def _cost(dataset: Dataset, task: Task) -> float:
    return float(task.paths_to_trace(dataset))


@dataclass
class _TaskClock:
    """Hands out tasks while there is time for them.

    took: seconds, of the last task that was finished.
    """

    dataset: Dataset
    limit: TimeLimit | None
    took: float = 0.0

    def in_time(self, tasks: list[Task]) -> Iterator[Task]:
        """The tasks, of each kind up to the first for which it is too late."""
        late: set[type[Task]] = set()
        for task in tasks:
            if type(task) not in late and not self._is_too_late(task):
                yield task
            else:
                late.add(type(task))

    def _is_too_late(self, task: Task) -> bool:
        """Whether there is no time for half of the task, if it takes as long as the last one."""
        if self.limit is None or self.limit.left() >= self.took / 2.0:
            return False
        if isinstance(task, ValidationHalf):
            return task.view >= LEAST_IMAGES and not task.emission
        if not isinstance(task, TrainingShard):
            return False
        return self.dataset.manifest.settings.lights_per_shard * task.index >= LEAST_LIGHTS


def _write_picture(checks: Sequence[SelfCheck], path: Path) -> str | None:
    """Write the first picture of differences; returns a line that names it, None without one."""
    picture = next((check.picture for check in checks if check.picture is not None), None)
    if picture is None:
        return None
    path.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(path, picture)
    return f"{path} marks the differences from Cycles"

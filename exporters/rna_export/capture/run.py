"""Runs a capture: opens the source, plans, renders what is missing, can be stopped at any time."""

from __future__ import annotations

import hashlib
import queue
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from time import monotonic
from typing import Any

import numpy as np
from tqdm import tqdm

import rna_sdk
from rna_export.capture.asset_scene import AssetScene
from rna_export.capture.dataset import Dataset
from rna_export.capture.directions import light_direction
from rna_export.capture.exported_parts import exported_parts
from rna_export.capture.manifest import CaptureManifest
from rna_export.capture.scene_domain import scene_domain
from rna_export.capture.settings import CaptureSettings
from rna_export.capture.tasks import Task, TrainingShard, all_tasks
from rna_export.capture.time_plan import LEAST_LIGHTS, TimeLimit, planned, shrunk
from rna_export.capture.view_rays import sample_view_rays
from rna_export.capture.worker import BlenderWorker, Source
from rna_render.scene_file import SceneFile
from rna_sdk.errors import CaptureError
from rna_sdk.package import Curves, Domain, Mesh
from rna_sdk.package.manifest_fields import Region
from rna_sdk.runtime import in_region

_COUNTED = 4096
_TASKS_A_PROCESS = 12  # then a fresh Blender: its memory grows over many renders


@dataclass(frozen=True)
class Crew:
    """How workers are started: one thread each, since a small render scales badly."""

    python: Path
    scratch: Path
    workers: int

    def worker(self, source: Source, name: str) -> BlenderWorker:
        return BlenderWorker(self.python, source, self.scratch, threads=1, name=name)


def begin(
    source: Source,
    asked: dict[str, Any],
    out: Path,
    crew: Crew,
    limit: TimeLimit | None,
    say: Callable[[str], None],
    for_scene: SceneFile | None = None,
) -> Dataset:
    """Open the source once: export the geometry, measure the speed, fix and write the plan.

    `asked`: settings, by name, that are not to be the usual ones of the asset's kind. `limit`
    replaces the number of lights by as many as fit, and may make the validation images smaller.
    `for_scene` limits views and lights to its own.
    """
    start = monotonic()
    with crew.worker(source, "probe") as worker:
        opening = monotonic() - start
        settings = CaptureSettings.usual(worker.kind, **asked)
        exported = exported_parts(worker, settings.exact_geometry)
        geometries = exported.geometries
        scene = AssetScene(tuple(geometries.values()), settings.sharpest, exported.transmittances())
        limited = None if for_scene is None else scene_domain(for_scene, out.stem, scene)
        domain = limited or Domain(wo=settings.domain, wi=settings.domain)
        rate = _paths_a_second(scene, settings, domain, worker) * crew.workers
        opened = worker.opened
    if limit is not None:
        usual, settings = settings, planned(settings, limit, opening, rate, asked)
        if note := shrunk(usual, settings):
            say(note)
    manifest = CaptureManifest(
        name=source.path.stem,
        parts=exported.captured(),
        source=source.path.name,
        source_sha256=hashlib.sha256(source.path.read_bytes()).hexdigest(),
        arguments=source.arguments,
        settings=settings,
        blender=opened["blender"],
        generator=f"rna-capture {rna_sdk.__version__}",
        opaque_cutouts=bool(exported.notes),
        emitters=tuple(opened["emitters"]),
        notes=(*opened["notes"], *exported.notes),
        scene_domain=limited,
    )
    for note in manifest.notes:
        say(f"note: {note}")
    dataset = Dataset.create(out, manifest, geometries, exported.textures)
    say(_plan(dataset, geometries, rate))
    return dataset


def scene_of(dataset: Dataset) -> AssetScene:
    """All parts of a dataset, ready to be asked with rays."""
    geometries = [part.geometry() for part in dataset.parts]
    transmittances = [part.transmittance() for part in dataset.parts]
    return AssetScene(geometries, dataset.manifest.settings.sharpest, transmittances)


def finish(
    dataset: Dataset,
    source: Source,
    crew: Crew,
    limit: TimeLimit | None = None,
    say: Callable[[str], None] = print,
    tasks: Sequence[Task] | None = None,
    bars: Callable[..., tqdm] = tqdm,
) -> None:
    """Render every task whose file is missing. Ctrl-C loses only the tasks under way.

    When the time of `limit` is up, the lights that are left are taken out of the plan. tasks: of
    the plan; None: all of it. bars: makes the progress bar.
    """
    for unfinished in dataset.folder.glob("*/*.part"):
        unfinished.unlink()
    asked = all_tasks(dataset) if tasks is None else tasks
    missing = [task for task in asked if not task.path(dataset).is_file()]
    if not missing:
        return
    total = sum(task.paths_to_trace(dataset) for task in missing)
    scene = scene_of(dataset)
    with bars(total=total, unit="path", unit_scale=True, desc="capture", smoothing=0.05) as bar:
        shift = _Shift(dataset, scene, source, crew, bar, limit)
        for task in missing:
            shift.todo.put(task)
        shift.work()
    if shift.failures:
        raise shift.failures[0]
    lights, there = dataset.manifest.settings.lights, dataset.lights_finished()
    if limit is not None and there < lights:
        dataset.plan_lights(there)
        say(f"the time is up: {there:,} of {lights:,} lights, which make a whole dataset")


@dataclass
class _Shift:
    """Threads that render tasks, each with a Blender process of its own.

    stop: when set, no task is begun. failures: what ended the shift before its time.
    """

    dataset: Dataset
    scene: AssetScene
    source: Source
    crew: Crew
    bar: tqdm
    limit: TimeLimit | None = None
    todo: queue.SimpleQueue[Task] = field(default_factory=queue.SimpleQueue)
    stop: threading.Event = field(default_factory=threading.Event)
    failures: list[Exception] = field(default_factory=list)
    workers: list[BlenderWorker] = field(default_factory=list)

    def work(self) -> None:
        """Until nothing is left to do, or to the first failure; Ctrl-C ends the processes."""
        names = map(str, range(self.crew.workers))
        threads = [threading.Thread(target=self._work, args=(name,)) for name in names]
        for thread in threads:
            thread.start()
        try:
            while any(thread.is_alive() for thread in threads):
                time.sleep(0.2)
        finally:
            self.stop.set()
            while any(thread.is_alive() for thread in threads):
                for worker in self.workers:
                    worker.kill()  # again and again: one may be starting
                time.sleep(0.05)

    def _work(self, name: str) -> None:
        try:
            worker = self.crew.worker(self.source, name)
            self.workers.append(worker)
            with worker:
                done, took = 0, 0.0
                while not self.stop.is_set():
                    try:
                        task = self.todo.get_nowait()
                    except queue.Empty:
                        return
                    if self._is_too_late(task, took):
                        return
                    begun = monotonic()
                    if done and done % _TASKS_A_PROCESS == 0:
                        worker.restart()
                    self._run(task, worker)
                    took = monotonic() - begun
                    done += 1
        except Exception as error:  # reported by the main thread
            self.failures.append(error)
            self.stop.set()

    def _is_too_late(self, task: Task, took: float) -> bool:
        """Whether there is no time for half of the task, if it takes as long as the last one."""
        if self.limit is None or not isinstance(task, TrainingShard):
            return False
        first = task.index * self.dataset.manifest.settings.lights_per_shard
        return first >= LEAST_LIGHTS and self.limit.left() < took / 2.0

    def _run(self, task: Task, worker: BlenderWorker) -> None:
        try:
            task.run(self.dataset, self.scene, worker)
        except CaptureError:  # Blender may die of its own; a second failure is ours
            if self.stop.is_set():
                return
            worker.restart()
            task.run(self.dataset, self.scene, worker)
        self.bar.update(task.paths_to_trace(self.dataset))


def _paths_a_second(
    scene: AssetScene, settings: CaptureSettings, domain: Domain, worker: BlenderWorker
) -> float:
    """The mean of three renders as the capture will do them, after one that only warms up."""
    seconds = []
    for k in range(4):
        start = time.perf_counter()
        wi = light_direction(k, settings.seed, domain.wi)
        rng = np.random.default_rng(k)
        rays = sample_view_rays(scene, wi, settings.rays, domain.wo, rng)
        worker.render_rays(rays.origins, rays.directions, wi, settings.samples, k)
        seconds.append(time.perf_counter() - start)
    return settings.rays * settings.samples / float(np.mean(seconds[1:]))


def _plan(dataset: Dataset, geometries: Mapping[str, Mesh | Curves], rate: float) -> str:
    settings = dataset.manifest.settings
    paths = sum(task.paths_to_trace(dataset) for task in all_tasks(dataset))
    samples = settings.lights * settings.rays
    return (
        f"{_parts_lines(dataset.manifest.name, geometries)}"
        f"{_domain_line(dataset.manifest)}"
        f"training: {settings.lights:,} lights x {settings.rays:,} view rays = "
        f"{samples / 1e6:.2f} M samples of {settings.samples} paths\n"
        f"validation: {settings.validation_views} images of {settings.validation_resolution}"
        f"x{settings.validation_resolution}, {settings.validation_samples} paths a pixel\n"
        f"about {paths / rate / 60.0:.1f} minutes at {rate / 1e6:.2f} M paths/s, "
        f"{samples * 4 * _widest(dataset) / 1e6:,.0f} MB"
    )


def _parts_lines(name: str, geometries: Mapping[str, Mesh | Curves]) -> str:
    sizes = {part: _size(geometry) for part, geometry in geometries.items()}
    if len(sizes) == 1:
        return f"{name}: {next(iter(sizes.values()))}\n"
    lines = (f"  {part}: {size}\n" for part, size in sizes.items())
    return f"{name}, {len(sizes)} parts:\n{''.join(lines)}"


def _widest(dataset: Dataset) -> int:
    """Columns of the samples that have the most."""
    return max(sum(part.fields.values()) for part in dataset.parts)


def _domain_line(manifest: CaptureManifest) -> str:
    """What --for made of the scene; nothing without it."""
    if manifest.scene_domain is None:
        return ""
    domain = manifest.scene_domain
    return f"of all directions: {_share(domain.wo)} of views, {_share(domain.wi)} of lights\n"


def _share(region: Region) -> str:
    """Of the sphere, counted on evenly spread directions."""
    spread = np.array([light_direction(k, 0, "sphere") for k in range(_COUNTED)])
    return f"{in_region(region, spread).mean():.1%}"


def _size(geometry: Mesh | Curves) -> str:
    if isinstance(geometry, Curves):
        return f"{len(geometry.offsets) - 1:,} strands, {len(geometry.points):,} points"
    return f"{len(geometry.triangles):,} triangles"

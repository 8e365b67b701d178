"""Workers that render the tasks of a dataset, each with its own Blender process."""

import shutil
import tempfile
import threading
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from rna_export.capture.blender_process import blender_env
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.capture_tasks import Task
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.rays.asset_scene import AssetScene
from rna_export.machine import keep_freed_memory
from rna_sdk.machine.cpu import processor_key
from rna_sdk.machine.kernel_threads import limit_kernel_threads
from rna_work.cluster.store import Store
from rna_work.sources import Carried

_RAYS_A_PROCESS = 12 << 17  # then a fresh Blender: its memory grows over many renders
_opening = threading.Lock()


@dataclass(frozen=True)
class CaptureJob:
    """Data that a worker needs on any machine.

    dataset: the manifest of the dataset, with its geometry. store: where finished files go; None
    for the dataset's own folder. files: the source, and what it reads. scratch: for ray images;
    None for a temporary folder of the worker's machine.
    """

    dataset: Carried
    store: Store | None
    source: Source
    files: Carried
    scratch: Path | None


class CaptureWorker:
    """Renders tasks of a job, one after the other: see `rna_work.workers.Worker`."""

    def __init__(self, job: CaptureJob, name: str) -> None:
        self._job, self._name = job, name
        self._rays = 0  # of the process, about
        self._blender: BlenderWorker | None = None
        self._temporary: Path | None = None

    def __enter__(self) -> "CaptureWorker":
        keep_freed_memory()
        limit_kernel_threads(1)  # each worker has a core
        job = self._job
        with _opening:  # workers that are threads share what is opened
            manifest = job.dataset.here()
            self._dataset, self._scene = opened(manifest.parent, manifest.read_text())
        scratch = job.scratch
        if scratch is None:
            scratch = self._temporary = Path(tempfile.mkdtemp(prefix="rna-capture-"))
        source = replace(job.source, path=job.files.here())
        python = blender_env.find_or_set_up()
        # One thread each, since a small render scales badly.
        self._blender = BlenderWorker(python, source, scratch, threads=1, name=self._name)
        self._blender.__enter__()
        return self

    def __exit__(self, *_: object) -> None:
        if self._blender is not None:
            self._blender.close()
        if self._temporary is not None:
            shutil.rmtree(self._temporary, ignore_errors=True)

    def run(self, task: Task) -> str:
        """Render a task, unless a worker that was lost had finished it; the processor's key."""
        path, blender = task.path(self._dataset), self._blender
        assert blender is not None  # since __enter__
        if path.is_file():
            return processor_key()
        if self._rays >= _RAYS_A_PROCESS:
            blender.restart()
            self._rays = 0
        path.parent.mkdir(exist_ok=True)
        task.run(self._dataset, self._scene, blender)
        self._rays += task.paths_to_trace(self._dataset) // self._dataset.manifest.settings.samples
        if self._job.store is not None:
            self._job.store.put(path, stored_name(task, self._dataset))
            path.unlink()
        return processor_key()

    def kill(self) -> None:
        if self._blender is not None:
            self._blender.kill()

    def processor_seconds(self) -> float | None:
        """See `rna_work.workers.Employer`."""
        return 0.0 if self._blender is None else self._blender.processor_seconds()


def stored_name(task: Task, dataset: Dataset) -> str:
    """Name of the task's file, relative to the dataset's folder."""
    return task.path(dataset).relative_to(dataset.folder).as_posix()


@lru_cache(1)
def opened(folder: Path, manifest: str) -> tuple[Dataset, AssetScene]:
    """The dataset in a folder, and its parts ready for rays.

    manifest: what tells datasets apart that were in the folder one after the other.
    """
    dataset = Dataset(folder)
    return dataset, scene_of(dataset)


def scene_of(dataset: Dataset) -> AssetScene:
    """All parts of a dataset, ready for rays, and its poses and prints."""
    geometries = [part.met_by_rays() for part in dataset.parts]
    transmittances = [part.transmittance() for part in dataset.parts]
    maps = [part.normal_maps() for part in dataset.parts]
    prints = dataset.manifest.prints
    colors = [[part.base_color(variant) for part in dataset.parts] for variant in prints]
    scene = AssetScene(
        geometries=geometries,
        sharpest=dataset.manifest.settings.sharpest,
        transmittances=transmittances,
        normal_maps=maps,
        base_colors=colors,
    )
    posed = ([p.positions(frame) for p in dataset.parts] for frame in dataset.manifest.poses[1:])
    scene.poses = tuple(
        AssetScene(
            geometries=geometries,
            sharpest=dataset.manifest.settings.sharpest,
            transmittances=transmittances,
            normal_maps=maps,
            positions=positions,
            base_colors=colors,
        )
        for positions in posed
    )
    return scene

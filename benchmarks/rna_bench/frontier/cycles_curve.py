"""Cycles at several sample counts: its error on the validation images, its time a shaded point."""

import tempfile
import time
from collections.abc import Iterator
from itertools import count
from pathlib import Path

import numpy as np
from pydantic import BaseModel, Field

from rna_bench.frontier.trials.scores import ModelScores, judge, write_strips
from rna_export.capture.blender_process import blender_env
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.blender_worker import BlenderWorker
from rna_export.capture.blender_process.capture_worker import scene_of
from rna_export.capture.capture_tasks import ValidationHalf
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.dataset_part import DatasetPart
from rna_export.capture.dataset.sample_files import read_part
from rna_export.capture.dataset.validation_view import ValidationView
from rna_sdk.machine.cores import core_count

_NOISE = 7  # names noise that neither half of the references has


class CyclesPoint(BaseModel, extra="forbid", frozen=True):
    """Cycles at one sample count."""

    samples: int = Field(description="paths a pixel")
    ns: float = Field(description="a shaded point, on all cores: of one more path, times paths")
    scores: ModelScores


class CyclesCurve(BaseModel, extra="forbid", frozen=True):
    """Cycles at doubling sample counts."""

    threads: int
    ns_a_path: float
    points: tuple[CyclesPoint, ...]


def render_curve(dataset: DatasetPart, source: Path, seconds: float, folder: Path) -> CyclesCurve:
    """Render the validation images with 1, 2, 4, ... paths per pixel, for about the given time.

    The original is opened with the arguments of the capture. Writes the pictures as
    `cycles-<samples>-render.png` and `-flip.png` into `folder`. Raises `CaptureError` when
    Blender fails.
    """
    views = dataset.validation_views()
    rendered: dict[int, list[np.ndarray]] = {}
    taken: dict[int, float] = {}
    with tempfile.TemporaryDirectory(prefix="rna-bench-") as scratch:
        manifest = dataset.manifest
        opened = Source.captured(source.resolve(), manifest.arguments, manifest.settings)
        python = blender_env.find_python()
        with BlenderWorker(python, opened, Path(scratch), core_count()) as worker:
            for samples in _doubling(taken, seconds, dataset.manifest.settings.validation_samples):
                copy = _at(dataset, samples, Path(scratch) / str(samples))
                _render(copy, views[:1], worker)  # a new sample count starts Blender anew
                start = time.perf_counter()
                rendered[samples] = _render(copy, views, worker)
                taken[samples] = time.perf_counter() - start
    points = sum(len(view.pixel) for view in views)
    # A line through all counts: what is left of one more path, without starting and files.
    slope = max(float(np.polyfit(list(taken), list(taken.values()), 1)[0]), 1e-9)
    ns_a_path = 1e9 * slope / points
    result = []
    for samples, radiance in rendered.items():
        scores, flips = judge(radiance, views)
        write_strips(folder / f"cycles-{samples}", radiance, views, flips)
        result.append(CyclesPoint(samples=samples, ns=samples * ns_a_path, scores=scores))
    return CyclesCurve(threads=core_count(), ns_a_path=ns_a_path, points=tuple(result))


def _doubling(taken: dict[int, float], seconds: float, reference: int) -> Iterator[int]:
    """1, 2, 4, ... until the next would end later than allowed; three at least.

    No more than a quarter of the reference's paths, whose noise counts as error, too.
    """
    for k in count():
        next_one = 2.0 * list(taken.values())[-1] if taken else 0.0
        if k >= 3 and (sum(taken.values()) + next_one > seconds or 4 * 2**k > reference):
            return
        yield 2**k


def _at(dataset: DatasetPart, samples: int, folder: Path) -> DatasetPart:
    """This plan with other paths a pixel, in a folder of its own."""
    settings = dataset.manifest.settings.model_copy(update={"validation_samples": 2 * samples})
    manifest = dataset.manifest.model_copy(update={"settings": settings})
    return Dataset.create(folder, manifest, {dataset.name: dataset.geometry()}).only


def _render(
    dataset: DatasetPart, views: list[ValidationView], worker: BlenderWorker
) -> list[np.ndarray]:
    """Radiance (n, 3) at the rows of each view."""
    scene, radiance = scene_of(dataset.dataset), []
    for view in views:
        task = ValidationHalf(view.index, _NOISE)
        task.run(dataset.dataset, scene, worker)
        result = read_part(task.path(dataset.dataset), dataset.name, {"radiance": 3, "pixel": 1})
        image = np.zeros((view.resolution**2, 3), np.float32)
        image[result["pixel"]] = result["radiance"]
        radiance.append(image[view.pixel])
    return radiance

"""Shards of a capture; the plan of `--minutes`, and that it is kept."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from rna_export.capture import capture_run as run_module
from rna_export.capture import time_plan
from rna_export.capture.blender_process.blender_process import Source
from rna_export.capture.blender_process.capture_worker import CaptureWorker
from rna_export.capture.capture_run import CaptureWorkers, finish
from rna_export.capture.capture_settings import CaptureSettings
from rna_export.capture.capture_tasks import (
    Task,
    TrainingShard,
    ValidationHalf,
    WhiteRays,
    all_tasks,
)
from rna_export.capture.dataset.dataset_folder import Dataset
from rna_export.capture.dataset.sample_files import write_parts
from rna_export.capture.time_plan import TimeLimit, planned, shrunk
from rna_sdk.errors import CaptureError
from rna_work import pool
from tests.exporters.synthetic import manifest_of
from tests.render.assets import sphere

SURFACE_RATE, FIBER_RATE = 0.15e6, 0.03e6  # paths a second of two slow cores


@dataclass
class Clock:
    now: float = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock(monkeypatch):
    clock = Clock()
    monkeypatch.setattr(time_plan, "monotonic", clock)
    monkeypatch.setattr(pool, "monotonic", clock)
    return clock


def seconds(settings: CaptureSettings, rate: float) -> tuple[float, float]:
    """Seconds of the validation images with the white world, and of the training rays."""
    return settings.held_out_paths / rate, settings.lights * settings.rays * settings.samples / rate


@pytest.mark.parametrize(
    ("kind", "minutes", "rate"),
    [("surface", 5, SURFACE_RATE), ("surface", 1, SURFACE_RATE), ("fiber", 8, FIBER_RATE)],
)
def test_validation_images_take_15_percent_at_most(kind, minutes, rate, clock):
    usual = CaptureSettings.usual(kind)
    assert seconds(usual, rate)[0] > 0.15 * 60.0 * minutes
    settings = planned(usual, kind, TimeLimit(minutes, 0.0), 10.0, rate, ())
    images, training = seconds(settings, rate)
    left = 60.0 * minutes - 10.0
    assert 0.1 * left < images <= 0.12 * 60.0 * minutes
    assert images + training == pytest.approx(left, rel=0.1) and images + training <= left
    note = shrunk(usual, settings)
    assert note is not None and f"with {settings.validation_samples} paths a pixel" in note
    assert settings.validation_resolution < usual.validation_resolution
    assert settings.validation_samples < usual.validation_samples


def test_with_time_enough_they_stay_as_they_are(clock):
    usual = CaptureSettings.usual("surface")
    settings = planned(usual, "surface", TimeLimit(60.0, 0.0), 10.0, SURFACE_RATE, ())
    changed = {"lights": settings.lights, "lights_per_shard": settings.lights_per_shard}
    assert settings == usual.model_copy(update=changed)
    assert 10 <= settings.lights / settings.lights_per_shard
    assert shrunk(usual, settings) is None


@pytest.mark.parametrize(
    ("minutes", "lights", "rays"), [(30.0, None, 4096), (5.0, 2000, None), (1.0, None, 1024)]
)
def test_lights_of_surfaces_have_fewer_rays_rather_than_being_few(minutes, lights, rays, clock):
    usual, limit = CaptureSettings.usual("surface"), TimeLimit(minutes, 0.0)
    settings = planned(usual, "surface", limit, 10.0, SURFACE_RATE, ())
    fixed = planned(usual, "surface", limit, 10.0, SURFACE_RATE, ("rays",))
    assert settings.lights == pytest.approx(lights or settings.lights, rel=0.01)
    assert settings.rays == (rays or settings.rays) and 1024 <= settings.rays <= 4096
    total = fixed.lights * 4096
    assert fixed.rays == 4096 and settings.lights * settings.rays == pytest.approx(total, rel=0.01)


@pytest.mark.parametrize("option", ["validation_resolution", "validation_samples"])
def test_what_was_asked_for_stays(option, clock):
    usual = CaptureSettings.usual("surface")
    settings = planned(usual, "surface", TimeLimit(5.0, 0.0), 10.0, SURFACE_RATE, (option,))
    assert getattr(settings, option) == getattr(usual, option)
    assert seconds(settings, SURFACE_RATE)[0] == pytest.approx(0.12 * 300.0, rel=0.15)


def test_too_few_minutes_are_refused(clock):
    fiber, message = (
        CaptureSettings.usual("fiber"),
        r"--minutes 0\.2 leaves .* --minutes (\d+) would",
    )
    with pytest.raises(CaptureError, match=message) as caught:
        planned(fiber, "fiber", TimeLimit(0.2, 0.0), 12.0, FIBER_RATE, ())
    enough = int(re.findall(message, str(caught.value))[0])
    assert planned(fiber, "fiber", TimeLimit(enough, 0.0), 12.0, FIBER_RATE, ()).lights >= 16
    with pytest.raises(CaptureError, match=f"--minutes {enough} would do"):
        planned(fiber, "fiber", TimeLimit(enough - 1, 0.0), 12.0, FIBER_RATE, ())
    with pytest.raises(CaptureError, match="give more minutes"):
        planned(fiber, "fiber", TimeLimit(1.0, 0.0), 12.0, 0.1, ())


@pytest.fixture
def dataset(tmp_path):
    manifest = manifest_of(CaptureSettings(lights=320, validation_views=1))
    return Dataset.create(tmp_path / "ball.rays", manifest, {"asset": sphere(1)})


class WithoutBlender(CaptureWorker):
    """Runs tasks that need no Blender."""

    def __enter__(self) -> "WithoutBlender":
        self._dataset = Dataset(self._job.dataset.here().parent)
        self._scene: Any = None
        self._blender: Any = object()
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def processor_seconds(self) -> float:
        return 0.0


@pytest.mark.parametrize(("a_task", "shards"), [(5.0, 10), (10.0, 4), (20.0, 1), (200.0, 1)])
def test_a_slow_capture_ends_in_time(a_task, shards, dataset, clock, monkeypatch):
    def run(task: Task, dataset: Dataset, *_: object) -> None:
        clock.now += 0.0 if isinstance(task, WhiteRays) else a_task
        rays = 32 * dataset.manifest.settings.rays
        write_parts(task.path(dataset), {"asset": {"wo": np.zeros((rays, 3), np.float32)}})

    for kind in (TrainingShard, ValidationHalf, WhiteRays):
        monkeypatch.setattr(kind, "run", run)
    monkeypatch.setattr(run_module, "CaptureWorker", WithoutBlender)
    said: list[str] = []
    workers, source = CaptureWorkers(Path("python"), dataset.folder, 1), Source(Path("ball.py"))
    finish(dataset, source, workers, TimeLimit(1.0, 0.0), said.append)
    again = Dataset(dataset.folder)
    assert again.manifest == dataset.manifest
    assert again.manifest.shards == shards and again.manifest.settings.lights == 32 * shards
    assert all(again.train_path(k).is_file() for k in range(shards))
    assert (said == []) == (shards == 10)
    finish(again, source, workers, TimeLimit(1.0, clock.now), said.append)
    assert again.manifest.shards == shards


@pytest.mark.parametrize(("a_half", "images"), [(2.0, 5), (8.0, 3), (200.0, 2)])
def test_images_of_a_slow_machine_are_fewer(a_half, images, tmp_path, clock, monkeypatch):
    def run(task: ValidationHalf, dataset: Dataset, *_: object) -> None:
        clock.now += a_half
        write_parts(task.path(dataset), {"asset": {"wo": np.zeros((1, 3), np.float32)}})

    monkeypatch.setattr(ValidationHalf, "run", run)
    monkeypatch.setattr(run_module, "CaptureWorker", WithoutBlender)
    manifest = manifest_of(CaptureSettings(lights=320, validation_views=5))
    dataset = Dataset.create(tmp_path / "slow.rays", manifest, {"asset": sphere(1)})
    tasks = [task for task in all_tasks(dataset) if isinstance(task, ValidationHalf)]
    workers, source = CaptureWorkers(Path("python"), dataset.folder, 1), Source(Path("ball.py"))
    said: list[str] = []
    finish(dataset, source, workers, TimeLimit(50 / 60, 0.0), said.append, tasks)
    assert dataset.manifest.settings.validation_views == images == len(dataset.finished_views())
    assert dataset.manifest.settings.lights == 320
    assert (said == []) == (images == 5)


@pytest.mark.parametrize(("lights", "shard"), [(3520, 32), (1024, 32), (512, 16), (64, 2), (3, 1)])
def test_there_are_32_shards_where_there_are_lights(lights, shard):
    settings = CaptureSettings.usual("surface", lights=lights)
    assert settings.shared_out().lights_per_shard == shard
    assert settings.shared_out().lights == lights

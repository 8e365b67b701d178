"""A worker that renders frames of a sequence, one after the other, with all threads that it has."""

from __future__ import annotations

import os
import sys
import threading
import time
import warnings
from dataclasses import dataclass, replace
from pathlib import Path

from rna_render.animation import frame_scene
from rna_render.output import Output
from rna_render.render import load_world
from rna_render.scene_file import SceneFile
from rna_render.terminal import render_with_bar, tell_tiers
from rna_render.world import World
from rna_sdk.errors import SceneError
from rna_sdk.kernel_threads import limit_kernel_threads
from rna_work.sources import Carried


@dataclass(frozen=True)
class Frame:
    """A frame to render. what: its name for the user."""

    number: int
    what: str

    def __str__(self) -> str:
        return self.what


@dataclass(frozen=True)
class FrameFiles:
    """What came of a frame. seconds: without loading the scene."""

    paths: list[Path]
    warnings: list[str]
    seconds: float


@dataclass(frozen=True)
class FrameJob:
    """What a worker needs, wherever it is.

    files: the scene file and all that it names. numbers: of all frames, whose tiers are chosen
    together. output: names with a place for the number. started: when the command was, as
    perf_counter.
    """

    scene_file: SceneFile
    files: Carried
    numbers: range
    output: Output
    threads: int
    started: float


class FrameWorker:
    """Renders frames of a job: see `rna_work.worker.Worker`. The world is loaded once."""

    def __init__(self, job: FrameJob, name: str) -> None:
        self._job = job
        self._stop = threading.Event()
        self._world: World | None = None

    def __enter__(self) -> FrameWorker:
        os.environ.setdefault("OMP_WAIT_POLICY", "passive")  # see rna_render.cli
        limit_kernel_threads(self._job.threads)
        self._scene_file = replace(self._job.scene_file, path=self._job.files.here())
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def run(self, frame: Frame) -> FrameFiles:
        """Render and write a frame. Raises SceneError if that cannot be, or if it is ended."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            world = self._loaded()
            start = time.perf_counter()
            paths = self._render(frame, world)
        lines = dict.fromkeys(str(warning.message) for warning in caught)
        return FrameFiles(paths, list(lines), time.perf_counter() - start)

    def kill(self) -> None:
        self._stop.set()

    def _render(self, frame: Frame, world: World) -> list[Path]:
        scene = frame_scene(self._scene_file.scene, frame.number)
        files = self._job.output.frame(frame.number)
        film = render_with_bar(
            replace(self._scene_file, scene=scene), world, self._stop.is_set, frame.what
        )
        if self._stop.is_set() and film.samples < scene.samples:
            raise SceneError(f"{frame.what} was stopped")
        files.write(scene, film)
        return files.paths()

    def _loaded(self) -> World:
        if self._world is None:
            views = [frame_scene(self._scene_file.scene, n) for n in self._job.numbers]
            self._world = load_world(self._scene_file, views)
            tell_tiers(self._scene_file, self._world)
            seconds = time.perf_counter() - self._job.started
            print(f"assets loaded after {seconds:.2f} s", file=sys.stderr)
        return self._world

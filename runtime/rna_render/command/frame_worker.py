"""Workers that open a scene, and one that renders frames with all threads that it has."""

from __future__ import annotations

import os
import sys
import threading
import time
import warnings
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Self

from rna_render.command.devices import open_renderer
from rna_render.command.terminal import render_with_bar, tell_tiers
from rna_render.image.output import Output
from rna_render.paths.shutter import shutter_times
from rna_render.paths.world_in_time import load_world
from rna_render.scene.animation import frame_scene
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import Scene
from rna_render.world.world import World
from rna_render.world.world_loading import Loaded, placed_world, warn_of_darkness
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
    """Files of a rendered frame. seconds: without loading the scene."""

    paths: list[Path]
    warnings: list[str]
    seconds: float


@dataclass(frozen=True)
class FrameJob:
    """Data that a worker needs on any machine.

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
    device: str


class SceneWorker:
    """Opens a scene where it is entered, for a device: see `rna_work.workers.Worker`.

    Attributes:
        scene_file: as it is on this machine. stop: set when the worker is to end.
    """

    def __init__(self, scene_file: SceneFile, files: Carried, threads: int, device: str) -> None:
        self.scene_file, self._files, self._threads = scene_file, files, threads
        self.device = device
        self.stop = threading.Event()

    def __enter__(self) -> Self:
        os.environ.setdefault("OMP_WAIT_POLICY", "passive")  # see rna_render.command.rna_run
        limit_kernel_threads(self._threads)
        self.scene_file = replace(self.scene_file, path=self._files.here())
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def load(self, views: list[Scene], loaded: Loaded | None = None) -> World:
        """The world for these images; loaded: as for `load_world`."""
        world = load_world(self.scene_file, views, partial(open_renderer, self.device), loaded)
        tell_tiers(self.scene_file, world)
        warn_of_darkness(self.scene_file, world)
        return world

    def kill(self) -> None:
        self.stop.set()


class FrameWorker(SceneWorker):
    """Renders frames of a job, one after the other. Files are loaded once."""

    def __init__(self, job: FrameJob, name: str) -> None:
        super().__init__(job.scene_file, job.files, job.threads, job.device)
        self._job = job
        self._world: World | None = None
        self._files_loaded = Loaded()

    def run(self, frame: Frame) -> FrameFiles:
        """Render and write a frame. Raises SceneError if that cannot be, or if it is ended."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            world = self._loaded()
            start = time.perf_counter()
            paths = self._render(frame, world)
        lines = dict.fromkeys(str(warning.message) for warning in caught)
        return FrameFiles(paths, list(lines), time.perf_counter() - start)

    def _render(self, frame: Frame, world: World) -> list[Path]:
        scene = frame_scene(self.scene_file.scene, frame.number)
        files = self._job.output.frame(frame.number)
        moments = self._moments(frame, world)
        frame_file, stop = replace(self.scene_file, scene=scene), self.stop.is_set
        film = render_with_bar(
            frame_file, moments[0][1], stop, frame.what, device=self.device, moments=moments
        )
        if self.stop.is_set() and film.samples < scene.samples:
            raise SceneError(f"{frame.what} was stopped")
        files.write(scene, film)
        return files.paths()

    def _moments(self, frame: Frame, world: World) -> list[tuple[SceneFile, World]]:
        """The scene and its world at each time of the frame. world: where nothing bends."""
        scene = self.scene_file.scene
        assert scene.animation is not None
        blur = scene.animation.shutter, scene.animation.subframes
        moves = any(asset.motion is not None for asset in scene.assets)
        result = []
        for at in shutter_times(frame.number, *blur):
            file = replace(self.scene_file, scene=frame_scene(scene, at))
            if moves:
                loaded = self._files_loaded
                world = placed_world(file, loaded.tiers, loaded)
            result.append((file, world))
        return result

    def _loaded(self) -> World:
        if self._world is None:
            scene = self.scene_file.scene
            views = [frame_scene(scene, n) for n in self._job.numbers]
            self._world = self.load(views, self._files_loaded)
            for view in views:
                self._files_loaded.motions.check(replace(self.scene_file, scene=view))
            seconds = time.perf_counter() - self._job.started
            print(f"assets loaded after {seconds:.2f} s", file=sys.stderr)
        return self._world

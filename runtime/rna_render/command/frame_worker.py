"""Workers that open a scene, and one that renders frames with all threads that it has."""

import sys
import threading
import time
import warnings
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Self

from rna_render.command.terminal import render_with_bar, tell_tiers
from rna_render.image.output import Output
from rna_render.paths.bands import BandRenderer
from rna_render.paths.integrator_factory import open_renderer
from rna_render.paths.shutter import ShutterRenderer, shutter_times
from rna_render.paths.world_in_time import load_world
from rna_render.scene.scene_file import SceneFile
from rna_render.scene.scene_model import AssetModel, Scene
from rna_render.world.world import World
from rna_render.world.world_loading import Loaded, placed_world, warn_of_darkness
from rna_sdk.errors import MotionError, SceneError
from rna_sdk.machine.kernel_threads import limit_kernel_threads
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
        self._device = device
        self.stop = threading.Event()

    def __enter__(self) -> Self:
        limit_kernel_threads(self._threads)
        self.scene_file = replace(self.scene_file, path=self._files.here())
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def load(
        self, scene_file: SceneFile, views: list[Scene], loaded: Loaded | None = None
    ) -> World:
        """The world of this scene, with tiers for the views; loaded: as for `load_world`."""
        world = load_world(scene_file, views, partial(self.renderer, scene_file), loaded)
        tell_tiers(scene_file.scene.quality, world)
        warn_of_darkness(scene_file.path, scene_file.scene.lights, world)
        return world

    def renderer(self, scene_file: SceneFile, world: World) -> BandRenderer:
        """Renderer of the scene, whose objects are in `world`, on the device."""
        return open_renderer(
            self._device,
            scene=scene_file.resolved,
            world=world,
            next_camera=scene_file.camera_after,
        )

    def kill(self) -> None:
        self.stop.set()


class FrameWorker(SceneWorker):
    """Renders frames of a job, one after the other. Files are loaded once."""

    def __init__(self, job: FrameJob, name: str) -> None:
        super().__init__(job.scene_file, job.files, job.threads, job.device)
        self._job = job
        self._world: World | None = None
        self._assets: tuple[AssetModel, ...] = ()
        self._files_loaded = Loaded()

    def run(self, frame: Frame) -> FrameFiles:
        """Render and write a frame. Raises SceneError if that cannot be, or if it is ended."""
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            if self._world is None:
                self._load(self._times(frame)[0])
            start = time.perf_counter()
            paths = self._render(frame)
        lines = dict.fromkeys(str(warning.message) for warning in caught)
        return FrameFiles(paths, list(lines), time.perf_counter() - start)

    def _render(self, frame: Frame) -> list[Path]:
        scene, stop = self.scene_file.at(frame.number).scene, self.stop.is_set
        files = self._job.output.frame(frame.number)
        moments = [self.scene_file.at(moment) for moment in self._times(frame)]
        worlds = [self._world_at(file) for file in moments]
        renderers = [self.renderer(*at) for at in zip(moments, worlds, strict=True)]
        renderer = renderers[0] if len(renderers) == 1 else ShutterRenderer(renderers)
        film = render_with_bar(scene, renderer, worlds[0], stop, frame.what)
        if self.stop.is_set() and film.samples < scene.samples:
            raise SceneError(f"{frame.what} was stopped")
        files.write(scene, film)
        return files.paths()

    def _times(self, frame: Frame) -> list[float]:
        """The times that the frame shows, more than one with motion blur."""
        animation = self.scene_file.scene.animation
        assert animation is not None
        return shutter_times(frame.number, animation.shutter, animation.subframes)

    def _world_at(self, scene_file: SceneFile) -> World:
        """The world at a time; the one that is there where nothing bends since."""
        assert self._world is not None
        assets = scene_file.scene.assets
        if assets != self._assets:
            loaded = self._files_loaded
            self._world = placed_world(scene_file, loaded.tiers, loaded)
            self._assets = assets
        return self._world

    def _load(self, moment: float) -> None:
        """Load the files, and the world at a time."""
        first, *views = map(self.scene_file.at, (moment, *self._job.numbers))
        scenes = [view.scene for view in views]
        self._world, self._assets = self.load(first, scenes, self._files_loaded), first.scene.assets
        for view in views:
            self._check_motions(view)
        seconds = time.perf_counter() - self._job.started
        print(f"assets loaded after {seconds:.2f} s", file=sys.stderr)

    def _check_motions(self, view: SceneFile) -> None:
        """Raises SceneError where a motion has not the frame that a view shows."""
        for index, asset in enumerate(view.resolved.assets):
            if asset.motion is not None:
                try:
                    self._files_loaded.motions.check(asset.motion, asset.path)
                except MotionError as error:
                    raise view.error(("assets", index, "motion"), str(error)) from error
